#pragma once

#include <filesystem>
#include <vector>

/// Files of a folder that AdrPlot opens.
namespace adore::adrplot {

/// For the folder of a run: SOL1 to SOL7, else RUN.json, SWEEP.csv and ACCURACY.json; for the
/// folder of a study and for a file: the path itself. Throws InputError for a folder without such
/// files.
[[nodiscard]] std::vector<std::filesystem::path> plot_files_of(const std::filesystem::path& path);

}  // namespace adore::adrplot
