#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>
#include <vector>

namespace adore::cli {

/// Writes a file that the user named: a new one, or in place of an earlier export that begins
/// alike.
/// @throws InputError when it is one of the inputs, a link, or something else than such an export.
void write_export(const std::filesystem::path& path, std::string_view text,
                  const std::vector<std::filesystem::path>& inputs);
/// The same for text that is written to a stream and never held as a whole.
void write_export(const std::filesystem::path& path,
                  const std::function<void(std::ostream&)>& produce,
                  const std::vector<std::filesystem::path>& inputs);

/// The same text to standard output.
void print_export(const std::function<void(std::ostream&)>& produce);

/// Throws if write_export would reject the target. @throws InputError
void check_export(const std::filesystem::path& path, std::string_view text,
                  const std::vector<std::filesystem::path>& inputs);

}  // namespace adore::cli
