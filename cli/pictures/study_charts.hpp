#pragma once

#include <filesystem>

namespace adore::cli {

/// Draws all charts of a study's CHARTS.json into a folder, NAME.png each, and prints their names
/// unless `quiet`.
/// @throws InputError
void draw_study_charts(const std::filesystem::path& charts, const std::filesystem::path& folder,
                       bool quiet);

}  // namespace adore::cli
