#pragma once

#include <filesystem>
#include <vector>

/// What AdrPlot opens of a folder.
namespace adore::adrplot {

/// Of a run's folder SOL1 to SOL7, else RUN.json, SWEEP.csv and ACCURACY.json; a study's folder and
/// everything that is no folder is itself. Throws InputError where a folder holds none of them.
[[nodiscard]] std::vector<std::filesystem::path> files_of(const std::filesystem::path& path);

}  // namespace adore::adrplot
