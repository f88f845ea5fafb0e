#pragma once

#include "adrplot/spectrum.hpp"
#include "desktop/chart_page.hpp"

namespace adore::adrplot {

/// Turns the first curve of the first panel with values into a waterfall: the spectra of pieces of
/// the run, one above the other, the earliest at the bottom. The distance between two lines is a
/// fifth of the largest amplitude, which the axis title says.
void to_waterfall(desktop::ChartPage& page, const std::vector<double>& times,
                  const SpectrumOptions& options);

}  // namespace adore::adrplot
