#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

/// `adore show` and `adore convert`: look into, or export, any result file. Files cut off anywhere
/// show what is there.
namespace adore::results {

enum class FileKind : unsigned char { Sol, Animation, Final, Master, RunJson, ResultsH5 };

/// Type of a file, by its content. @throws InputError when it is not a file of this program.
[[nodiscard]] FileKind file_kind(const std::filesystem::path& path);

/// Type, header, and the range of each channel with name and unit. @throws InputError
[[nodiscard]] std::string describe_file(const std::filesystem::path& path);

/// The same as JSON text. @throws InputError
[[nodiscard]] std::string describe_file_json(const std::filesystem::path& path);

/// The whole content. CSV: one line per stored step, the first line names the columns with their
/// units (FINAL and MASTER: one line per component; RUN.json: one line per leaf). Decimal point and
/// full precision in every locale; missing values are empty (csv) or null (json). @param format
/// "csv" or "json". @returns empty, or a message on damaged parts left out. @throws InputError
std::string convert_file(const std::filesystem::path& path, std::string_view format,
                         std::ostream& out);

}  // namespace adore::results
