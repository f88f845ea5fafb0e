#pragma once

#include <cstddef>
#include <string>

/// Properties of the terminal, file or pipe behind a stream.
namespace adore::command_line {

/// Whether a stream (STDERR_FILENO ...) is a terminal.
[[nodiscard]] bool is_terminal(int stream) noexcept;

/// Columns of the terminal on a stream: what the terminal says, else the variable COLUMNS, else 80.
[[nodiscard]] std::size_t columns(int stream) noexcept;

/// The text broken between words into lines of at most `width` columns, all but the first indented.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

}  // namespace adore::command_line
