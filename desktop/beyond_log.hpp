#pragma once

#include "desktop/chart_page.hpp"

#include <string>
#include <vector>

/// What has no place on logarithmic axes.
namespace adore::desktop {

/// Of which curves that are shown, and how many of their values: a sentence, empty where all have a
/// place. A curve without any has its own words in its legend; that an abscissa which begins at 0
/// begins after it is seen.
[[nodiscard]] std::string beyond_log_axes(const ChartPage& page);

/// The values as a logarithmic axis draws them: those of 0 and less stand at `below`, beyond the
/// foot of the picture, so that a line leaves it and comes back; a gap would be of no value.
[[nodiscard]] std::vector<double> above_or_at(const std::vector<double>& values, double below);

}  // namespace adore::desktop
