#pragma once

#include "desktop/chart_page.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// A picture of curves with their points over two logarithmic axes.
namespace adore::desktop {

struct LogChart {
  std::string title, x_title, y_title;
  std::vector<ChartCurve> curves;  ///< with their own x; all values above 0
};

/// Writes it as a PNG of 1280 by 800. False, and no file, without a single point.
bool save_log_chart(const LogChart& chart, const std::filesystem::path& file);

}  // namespace adore::desktop
