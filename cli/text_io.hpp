#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// "-" is a standard stream wherever one file is read or written.
namespace adore::cli {

inline constexpr std::string_view kStream = "-";

/// The whole of standard input. @throws InputError above `most` bytes.
[[nodiscard]] std::string read_standard_input(std::size_t most);

/// Writes a text to standard output for "" and "-", into a folder under `name`, or else to the file
/// like write_export. Returns the name of the file; empty for standard output.
/// @throws InputError if it cannot be written.
std::string write_text(const std::string& out, const std::string& name, std::string_view text,
                       const std::vector<std::filesystem::path>& inputs = {});

}  // namespace adore::cli
