#include "cli/streams.hpp"

#include "base/terminal_text.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <poll.h>
#include <string>
#include <unistd.h>

namespace adore::cli {

void reserve_standard_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(number, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest free number is this one; neither reading from 0 nor writing to 1 and 2 succeeds.
    (void)!::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

void tell(std::string_view said, bool patient) noexcept {
  // A progress line begins with the sequence that clears the line before it.
  constexpr std::string_view kClear = "\r\x1b[K";
  std::string shown;
  try {
    const bool clear = said.starts_with(kClear);
    shown = (clear ? std::string(kClear) : std::string()) +
            escape_for_terminal(said.substr(clear ? kClear.size() : 0));
  } catch (const std::exception&) {
    return;  // no memory for a remark
  }
  std::string_view text = shown;
  while (!text.empty()) {
    pollfd ready{STDERR_FILENO, POLLOUT, 0};
    if (!patient && ::poll(&ready, 1, 0) <= 0) return;
    const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
    if (count <= 0) return;  // also when a signal ended the wait
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

std::optional<bool> ask(std::string_view question) {
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDERR_FILENO) == 0) return std::nullopt;
  tell(std::string(question) + " [y/N] ");
  const int answer = std::getchar();
  for (int rest = answer; rest != '\n' && rest != EOF;) rest = std::getchar();
  return answer == 'y' || answer == 'Y';
}

int close_output(int code) noexcept {
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && std::ferror(stdout) == 0) return code;
  const int error = errno;
  tell(std::string("adore: standard output cannot be written") +
       (error != 0 ? std::string(": ") + std::strerror(error) : std::string()) +
       "; free some disk space, or redirect the output\n");
  return code == 0 ? 2 : code;
}

}  // namespace adore::cli
