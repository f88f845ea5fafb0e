#include "cli/whole_program.hpp"

#include "base/ending.hpp"
#include "base/errors.hpp"
#include "base/interrupted.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"

#include <cstdio>
#include <new>
#include <string>
#include <system_error>

namespace adore::cli {
namespace {

int report(const char* text, int code) {
  tell(std::string("adore: ") + text + "\n");
  return code;
}

int guarded(const std::function<int()>& body) {
  try {
    return body();
  } catch (const InputError& error) {
    return report(error.what(), 2);
  } catch (const SolverError& error) {
    return report(error.what(), 3);
  } catch (const Interrupted& stop) {
    return report(stop.what(), 130);
  } catch (const std::system_error& error) {
    // Errors of standard output: reported once, when it is closed.
    return std::ferror(stdout) != 0 ? 2 : report(error.what(), 1);
  } catch (const std::bad_alloc&) {
    return report("out of memory: the deck needs more memory than this machine has", 3);
  } catch (const std::exception& error) {
    return report(error.what(), 1);
  }
}

}  // namespace

int whole_program(const std::function<int()>& body) {
  reserve_standard_streams();
  ignore_file_size_signal();
  exit_on_interrupt();
  return close_output(guarded(body));
}

}  // namespace adore::cli
