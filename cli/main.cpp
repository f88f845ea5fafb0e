#include "base/errors.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <new>

namespace {

int report(const char* text, int code) {
  fmt::print(stderr, "adore: {}\n", text);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Adore: rolling-bearing dynamics. Exit codes: 0 done, 1 a bug or a failed reference case, 2 "
      "wrong input, "
      "3 the numerics gave up, 130 interrupted."};
  app.set_version_flag("--version", std::string(adore::kProgramVersion));
  app.require_subcommand(1);
  int exit_code = 0;
  adore::cli::add_run(app, exit_code);
  adore::cli::add_deck_commands(app, exit_code);
  adore::cli::add_calc(app, exit_code);
  adore::cli::add_accuracy(app, exit_code);
  adore::cli::add_file_commands(app, exit_code);
  adore::cli::add_picture_commands(app, exit_code);
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const adore::InputError& error) {
    return report(error.what(), 2);
  } catch (const adore::SolverError& error) {
    return report(error.what(), 3);
  } catch (const std::bad_alloc&) {
    return report("out of memory: the deck asks for more than this machine has", 3);
  } catch (const std::exception& error) {
    return report(error.what(), 1);
  }
}
