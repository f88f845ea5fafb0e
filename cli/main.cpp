#include "cli/commands.hpp"
#include "cli/default_run_choice.hpp"
#include "cli/picture_program.hpp"
#include "cli/whole_program.hpp"
#include "command_line/program.hpp"

#include <array>
#include <string>

int main(int argc, char** argv) {
  using namespace adore;
  return cli::whole_program([&] {
    std::string run = "run";
    std::array<char*, 3> run_here{argv[0], run.data(), nullptr};
    if (argc == 1) switch (cli::confirm_default_run()) {
        case cli::DefaultRunChoice::NoDeck:
          break;
        case cli::DefaultRunChoice::Declined:
          return 0;
        case cli::DefaultRunChoice::NotAsked:
          return 2;
        case cli::DefaultRunChoice::Run:
          argc = 2;
          argv = run_here.data();
      }
    const auto app = command_line::make_program(
        "Adore: dynamics of rolling bearings. Reads a deck; writes listings, result files and "
        "pictures.",
        "adore");
    app->footer(
        "First steps\n"
        "  adore new ball --out DATA.txt    write a complete deck\n"
        "  adore plan                       show its effects, computing time and disk space\n"
        "  adore run                        simulate it\n"
        "  adore COMMAND --help             show options and examples of a command\n\n"
        "Exit codes: 0 success; 1 program error, failed reference case or damaged file; 2 wrong "
        "input;\n"
        "3 failed computation; 130 interrupted.");
    app->require_subcommand(1);
    int exit_code = 0;
    cli::add_run_command(*app, exit_code);
    cli::add_deck_commands(*app, exit_code);
    cli::add_calc_commands(*app, exit_code);
    cli::add_find_command(*app, exit_code);
    cli::add_accuracy_command(*app, exit_code);
    cli::add_user_command(*app, exit_code);
    cli::add_study_command(*app, exit_code);
    cli::add_file_commands(*app, exit_code);
    cli::add_picture_commands(*app, cli::forwarding_actions(argv));
    return command_line::parse(*app, argc, argv).value_or(exit_code);
  });
}
