#pragma once

#include "desktop/chart_page.hpp"

#include <string>
#include <vector>

/// Rotation in a run: its rates are the frequencies of the marks.
namespace adore::adrplot {

/// Number of events of a mark up to each time: revolutions of the shaft, or elements that passed a
/// point.
struct MarkTurns {
  std::string label;                ///< "shaft", "BPFO", "2 BPFO"
  std::vector<double> time, turns;  ///< time [s] rises
};

struct RunMotion {
  std::vector<double> times, turns;   ///< stored times [s] and relative revolutions of the races
  std::vector<MarkTurns> marks = {};  ///< empty: not known
};

/// Mean frequency between two times [Hz]; 0: unknown. Outside the known times the nearest known
/// interval is used.
[[nodiscard]] double frequency_between(const MarkTurns& mark, double from, double to);

/// The marks with their mean frequencies over the run, without those of zero frequency.
[[nodiscard]] std::vector<desktop::ChartMark> mean_marks(const std::vector<MarkTurns>& marks);

}  // namespace adore::adrplot
