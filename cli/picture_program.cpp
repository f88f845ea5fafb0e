#include "cli/picture_program.hpp"

#include "base/ending.hpp"
#include "base/errors.hpp"
#include "cli/streams.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace adore::cli {
namespace {

std::string program_path() {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "adore-pictures")
      .string();
}

[[noreturn]] void refuse(const std::string& program, int error) {
  throw InputError(
      fmt::format("the drawing program {} does not start: {}; install it next to `adore`, or use "
                  "`adore convert FILE --to csv` and another plotting program",
                  program, std::strerror(error)));
}

void become(char** argv) {
  if (!has_pictures())
    throw InputError(
        "this program was built without Qt and cannot draw; build with ADORE_WITH_QT=ON (preset "
        "release), or use `adore convert FILE --to csv` and another plotting program");
  const std::string program = program_path();
  (void)std::fflush(nullptr);
  // An interrupt that arrives while the other program is loaded waits until that program handles
  // it.
  const InterruptBlocker wait;
  ::execv(program.c_str(), argv);
  refuse(program, errno);
}

}  // namespace

bool has_pictures() noexcept {
#ifdef ADORE_HAS_PICTURES
  return true;
#else
  return false;
#endif
}

PictureActions forwarding_actions(char** argv) {
  return {[argv](const PlotRequest&) { become(argv); },
          [argv](const AnimateRequest&) { become(argv); },
          [argv](const GalleryRequest&) { become(argv); },
          [argv](const ReportRequest&) { become(argv); }};
}

bool run_picture_program(const std::vector<std::string>& words) {
  if (!has_pictures()) return false;
  const std::string program = program_path();
  std::vector<std::string> all{program};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> argv;
  for (std::string& word : all) argv.push_back(word.data());
  argv.push_back(nullptr);
  (void)std::fflush(nullptr);
  pid_t child = 0;
  if (const int error =
          ::posix_spawn(&child, program.c_str(), nullptr, nullptr, argv.data(), environ);
      error != 0)
    refuse(program, error);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status) == 0;  // it has said why
  tell(
      fmt::format("adore: {} was ended by signal {} ({}) while drawing. Pictures are missing or "
                  "incomplete; all other results are written.\n",
                  program, WTERMSIG(status), ::strsignal(WTERMSIG(status))));
  return false;
}

}  // namespace adore::cli
