#pragma once

#include "agore/animation.hpp"
#include "desktop/chart_page.hpp"

namespace adore::agore {

/// Frequency of the fastest contact of the run [Hz], estimated in RUN.json; 0: unknown.
[[nodiscard]] double fastest_frequency(const Animation& animation);

/// Adds a note if a line without extremes between its values has few values per period of that
/// contact.
void note_missed_peaks(desktop::ChartPage& page, const Animation& animation);

}  // namespace adore::agore
