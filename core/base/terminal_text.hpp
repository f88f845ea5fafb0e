#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

/// All text that a program prints goes through here (tests/architecture checks that): names of
/// files and texts in them are of other people, and a terminal obeys escape sequences.
namespace adore {

/// The text with its control characters made visible: "\x1b" for those of one byte, U+FFFD for
/// those of two (U+0080 to U+009F). Line ends and tabs stay.
[[nodiscard]] std::string escape_for_terminal(std::string_view text);

/// Writes escape_for_terminal() to a stream.
void print_text(std::FILE* stream, std::string_view text);

template <class... Args>
void print(std::FILE* stream, fmt::format_string<Args...> format, Args&&... args) {
  print_text(stream, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void print(fmt::format_string<Args...> format, Args&&... args) {
  print_text(stdout, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace adore
