#pragma once

#include <filesystem>
#include <optional>
#include <vector>

/// What of a run's folder can be drawn, whatever record 2.3 of its deck has named the files.
namespace adore::results {

struct RunFolder {
  /// SOL1 to SOL7 that are there, then those of other names that RUN.json lists and whose header
  /// says that they are such files.
  std::vector<std::filesystem::path> plots;
  std::optional<std::filesystem::path> animation;  ///< SOL8
};

/// Nothing where nothing is found; a RUN.json that cannot be read adds nothing.
[[nodiscard]] RunFolder run_folder(const std::filesystem::path& folder);

/// What is animated of a run: of a folder its SOL8, else its RESULTS.h5; any other path is itself.
/// Throws InputError where a folder has neither.
[[nodiscard]] std::filesystem::path animation_file(const std::filesystem::path& path);

}  // namespace adore::results
