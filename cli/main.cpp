#include "base/errors.hpp"
#include "base/interrupted.hpp"
#include "cli/commands.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "command_line/program.hpp"

#include <cstdio>
#include <new>
#include <string>
#include <system_error>

namespace {

int report(const char* text, int code) {
  adore::cli::tell(std::string("adore: ") + text + "\n");
  return code;
}

int run_command(int argc, char** argv) {
  const auto app = adore::command_line::make_program(
      "Adore: dynamics of rolling bearings, from a deck of records to listings, result files and "
      "pictures.",
      "adore");
  app->footer(
      "First steps\n"
      "  adore new ball --out DATA.txt    a complete deck\n"
      "  adore plan                       what it would simulate, why, and at what cost\n"
      "  adore run                        simulate it\n"
      "  adore COMMAND --help             options of a command, with examples\n"
      "\n"
      "Exit codes: 0 done, 1 a bug or a failed reference case, 2 wrong input, 3 the numerics gave\n"
      "up, 130 interrupted.");
  app->require_subcommand(1);
  int exit_code = 0;
  adore::cli::add_run(*app, exit_code);
  adore::cli::add_deck_commands(*app, exit_code);
  adore::cli::add_calc(*app, exit_code);
  adore::cli::add_accuracy(*app, exit_code);
  adore::cli::add_file_commands(*app, exit_code);
  adore::cli::add_picture_commands(*app, exit_code);
  try {
    return adore::command_line::parse(*app, argc, argv).value_or(exit_code);
  } catch (const adore::InputError& error) {
    return report(error.what(), 2);
  } catch (const adore::SolverError& error) {
    return report(error.what(), 3);
  } catch (const adore::Interrupted& stop) {
    return report(stop.what(), 130);
  } catch (const std::system_error& error) {
    // Writing to a standard stream: said once, when it is closed.
    return std::ferror(stdout) != 0 ? 2 : report(error.what(), 1);
  } catch (const std::bad_alloc&) {
    return report("out of memory: the deck asks for more than this machine has", 3);
  } catch (const std::exception& error) {
    return report(error.what(), 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  adore::cli::keep_stream_numbers();
  adore::cli::ignore_file_size_signal();
  return adore::cli::close_output(run_command(argc, argv));
}
