#pragma once

#include <filesystem>
#include <string>

/// Names of files, and their short form. No Qt.
namespace adore::adrinput {

/// Identity of a file, independent of later changes of the working folder: absolute, without links
/// and dots in its folder. A link keeps its name, because its folder determines the other files.
[[nodiscard]] std::filesystem::path normalized_path(const std::filesystem::path& path);

/// A complete name with folders omitted in the middle if it is long: every deck is called DATA.txt,
/// and the folders distinguish them.
[[nodiscard]] std::string shortened_path(const std::filesystem::path& path);

}  // namespace adore::adrinput
