#pragma once

#include "agore/animation.hpp"
#include "desktop/chart_page.hpp"

namespace adore::agore {

/// Of the run's fastest contact [Hz], as RUN.json beside its files estimates it; 0: not known.
[[nodiscard]] double fastest_frequency(const Animation& animation);

/// Says so where a line of the page without extremes between its values has few values in a period
/// of that contact.
void tell_of_peaks(desktop::ChartPage& page, const Animation& animation);

}  // namespace adore::agore
