#pragma once

#include <filesystem>

namespace adore::cli {

/// Draws every chart of a study's CHARTS.json into a folder, NAME.png each, and says their names
/// unless `quiet`.
/// @throws InputError
void draw_study(const std::filesystem::path& charts, const std::filesystem::path& folder,
                bool quiet);

}  // namespace adore::cli
