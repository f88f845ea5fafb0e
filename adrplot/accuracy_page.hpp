#pragma once

#include "desktop/chart_page.hpp"

#include <filesystem>
#include <vector>

namespace adore::adrplot {

/// The pages of ACCURACY.json, which `adore accuracy` writes: error over computing time, a point
/// for each run that came to its end, a color for each integrator. Low and left is good.
/// @throws InputError for another file
[[nodiscard]] std::vector<desktop::ChartPage> accuracy_pages(const std::filesystem::path& path);

/// Is it such a file, by its name?
[[nodiscard]] bool is_accuracy_file(const std::filesystem::path& path);

}  // namespace adore::adrplot
