#include "command_line/terminal.hpp"

#include <cstdlib>
#include <sys/ioctl.h>
#include <unistd.h>

namespace adore::command_line {

bool is_terminal(int stream) noexcept { return isatty(stream) != 0; }

std::size_t columns(int stream) noexcept {
  winsize size{};
  if (ioctl(stream, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  const char* text = std::getenv("COLUMNS");
  const long given = text == nullptr ? 0 : std::strtol(text, nullptr, 10);
  constexpr long kMaxColumns = 1000;
  return given > 0 && given < kMaxColumns ? static_cast<std::size_t>(given) : 80;
}

std::string wrap_text(const std::string& text, std::size_t width, std::size_t indent) {
  std::string out;
  const std::string margin(indent, ' ');
  std::size_t column = 0, at = 0;
  while (at < text.size()) {
    if (text[at] == '\n') {
      out += '\n' + margin;
      column = 0;
      ++at;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    const std::size_t length = end - at;
    if (column > 0 && indent + column + 1 + length > width) {
      out += '\n' + margin;
      column = 0;
    } else if (column > 0) {
      out += ' ';
      ++column;
    }
    out.append(text, at, length);
    column += length;
    at = end < text.size() && text[end] == ' ' ? end + 1 : end;
  }
  return out;
}

}  // namespace adore::command_line
