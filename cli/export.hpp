#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>
#include <vector>

namespace adore::cli {

/// Writes a file named by the user: a new one, or one that replaces an earlier export with the same
/// beginning.
/// @throws InputError if it is an input file, a link, or not such an export.
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
