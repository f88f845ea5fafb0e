#pragma once

#include "desktop/chart_page.hpp"

#include <string>
#include <vector>

/// Values that cannot be shown on logarithmic axes.
namespace adore::desktop {

/// Curves with such values and their fraction, as a sentence; empty if all values can be shown. A
/// curve without positive values is described in its legend; an abscissa that begins at 0 needs no
/// note.
[[nodiscard]] std::string log_axis_note(const ChartPage& page);

/// Values for a logarithmic axis: those of 0 and less are at `below`, outside the lower end of the
/// picture, so that lines leave and return; a gap would mean a missing value.
[[nodiscard]] std::vector<double> replace_nonpositive(const std::vector<double>& values,
                                                      double below);

}  // namespace adore::desktop
