#pragma once

#include "adrplot/spectrum.hpp"
#include "desktop/chart_page.hpp"

#include <string>
#include <utility>
#include <vector>

namespace adore::adrplot {

/// Turns the first curve of the first panel with values into a waterfall: the spectra of pieces of
/// the run, one above the other, the earliest at the bottom: in units, over the largest of all, or
/// in dB of that, cut off at -60 dB. The distance between two lines is a fifth of the largest
/// amplitude or of the 60 dB, which the note says. Each line is named after the middle
/// of its piece and, where the shaft changes its speed, the speed there.
/// @param turns of the shaft at the times, growing; empty: not known
void to_waterfall(desktop::ChartPage& page, const std::vector<double>& times,
                  const std::vector<double>& turns, const SpectrumOptions& options);

/// Does the shaft keep its speed within 1 % over the whole run? Then the frequencies of its
/// elements are the same in all of it.
[[nodiscard]] bool keeps_speed(const std::vector<double>& times, const std::vector<double>& turns);

/// Lowest and highest speed of the shaft over twentieths of a run [turns/s]; 0, 0: not known.
[[nodiscard]] std::pair<double, double> speed_range(const std::vector<double>& times,
                                                    const std::vector<double>& turns);

/// "10000 rpm", of turns per second: four digits, never a power of ten.
[[nodiscard]] std::string rpm_text(double speed);

}  // namespace adore::adrplot
