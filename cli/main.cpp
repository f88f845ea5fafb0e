#include "base/errors.hpp"
#include "base/interrupted.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

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
