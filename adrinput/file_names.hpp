#pragma once

#include <filesystem>
#include <string>

/// Names of files that are kept, and how they are said. No Qt.
namespace adore::adrinput {

/// The same file from wherever it is asked for, also after the working folder has changed:
/// absolute, its folder without links and dots. A link keeps its own name, for what stands beside
/// it counts.
[[nodiscard]] std::filesystem::path whole_path(const std::filesystem::path& path);

/// A whole name with folders left out in the middle where it is long: every deck is called
/// DATA.txt, and the folders before it tell which one it is.
[[nodiscard]] std::string short_name(const std::filesystem::path& path);

}  // namespace adore::adrinput
