#pragma once

#include "desktop/chart_page.hpp"

#include <string>
#include <vector>

/// How a run turned: what the frequencies of its marks are the rates of.
namespace adore::adrplot {

/// How often what a mark counts has happened up to each time: turns of the shaft, elements that
/// have passed a place.
struct MarkTurns {
  std::string label;                ///< "shaft", "BPFO", "2 BPFO"
  std::vector<double> time, turns;  ///< time [s] rises
};

struct RunMotion {
  std::vector<double> times, turns;   ///< stored times [s] and turns of one race against the other
  std::vector<MarkTurns> marks = {};  ///< empty: not known
};

/// Mean frequency between two times [Hz]; 0: not known. Of what lies outside the known times the
/// nearest known stretch is taken.
[[nodiscard]] double frequency_between(const MarkTurns& mark, double from, double to);

/// The marks with their mean frequencies over the run; those that do not turn are none.
[[nodiscard]] std::vector<desktop::ChartMark> mean_marks(const std::vector<MarkTurns>& marks);

}  // namespace adore::adrplot
