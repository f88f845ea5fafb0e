#pragma once

#include <cstddef>
#include <string>

/// Properties of the terminal, file or pipe behind a stream.
namespace adore::command_line {

/// Whether a stream (STDERR_FILENO ...) is a terminal.
[[nodiscard]] bool is_terminal(int stream) noexcept;

/// Width of the terminal of a stream: from the terminal, else from the variable COLUMNS, else 80.
[[nodiscard]] std::size_t columns(int stream) noexcept;

/// The text wrapped between words to lines of at most `width` columns, all but the first indented.
[[nodiscard]] std::string wrap_text(const std::string& text, std::size_t width, std::size_t indent);

}  // namespace adore::command_line
