#pragma once

#include <optional>
#include <string_view>

/// The three standard streams of a program that must not lose a run to them.
namespace adore::cli {

/// A stream that was closed when the program started is opened so that writing fails as before, but
/// no result file gets its number. Call first.
void reserve_standard_streams();

/// Writes to standard error; ignores errors. `patient` false: only if no waiting is needed
/// (progress on a full pipe or a stopped terminal).
void tell(std::string_view text, bool patient = true) noexcept;

/// Asks `question` on standard error, followed by "[y/N]", and reads a line from standard input.
/// @return true if the answer begins with y; no value if either stream is not a terminal
[[nodiscard]] std::optional<bool> ask(std::string_view question);

/// Flushes standard output and reports errors.
/// @return the exit code: `code`, or 2 if it was 0 and output is lost
[[nodiscard]] int close_output(int code) noexcept;

}  // namespace adore::cli
