#pragma once

#include <filesystem>
#include <optional>
#include <vector>

/// Files of a run's folder that can be drawn, for any file names of record 2.3 of its deck.
namespace adore::results {

struct PlottableFiles {
  /// Existing SOL1 to SOL7, then those of other names that RUN.json lists and whose header
  /// has this format.
  std::vector<std::filesystem::path> plots;
  std::optional<std::filesystem::path> animation;  ///< SOL8
};

/// Nothing where nothing is found; a RUN.json that cannot be read adds nothing.
[[nodiscard]] PlottableFiles run_folder(const std::filesystem::path& folder);

/// Animation of a run: for a folder its SOL8, otherwise its RESULTS.h5; any other path is itself.
/// @throws InputError for a folder without either.
[[nodiscard]] std::filesystem::path animation_file(const std::filesystem::path& path);

}  // namespace adore::results
