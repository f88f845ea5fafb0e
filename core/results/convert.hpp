#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

/// `adore show` and `adore convert`: look into, or export, any result file. Files cut off anywhere
/// show what is there.
namespace adore::results {

enum class FileKind : unsigned char { Sol, Animation, Final, Master, RunJson, ResultsH5 };

/// What a file is, by its content. @throws InputError when it is none of ours.
[[nodiscard]] FileKind file_kind(const std::filesystem::path& path);

/// What it is, its header, and the range of each channel with name and unit. @throws InputError
[[nodiscard]] std::string describe_file(const std::filesystem::path& path);

/// The same as JSON text. @throws InputError
[[nodiscard]] std::string describe_file_json(const std::filesystem::path& path);

/// The whole content. CSV: one line per stored step, the first line names the columns with their
/// units (FINAL and MASTER: one line per component; RUN.json: one line per leaf). Decimal point and
/// full precision whatever the locale; missing values are empty (csv) or null (json). @param format
/// "csv" or "json". @returns empty, or what is wrong with the file and left out. @throws InputError
std::string convert_file(const std::filesystem::path& path, std::string_view format,
                         std::ostream& out);

}  // namespace adore::results
