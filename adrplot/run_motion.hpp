#pragma once

#include "desktop/chart_page.hpp"

#include <string>
#include <vector>

/// Rotation in a run: its rates are the frequencies of the marks.
namespace adore::adrplot {

/// Number of events of a mark up to each time: revolutions of the shaft, or elements that passed a
/// point.
struct MarkEventCounts {
  std::string label;                ///< "shaft", "BPFO", "2 BPFO"
  std::vector<double> time, turns;  ///< time [s] rises
};

struct RunMotion {
  std::vector<double> times, turns;  ///< stored times [s] and relative revolutions of the races
  std::vector<MarkEventCounts> marks = {};  ///< empty: not known
  std::string source = {};                  ///< of the revolutions: "bearing rotation in SOL1"
  bool oscillates = false;                  ///< the shaft turns back: its revolutions are no angle
};

/// Events of a mark at other times, by linear interpolation and continuation; none: unknown.
[[nodiscard]] std::vector<double> event_counts_of(const MarkEventCounts& mark,
                                                  const std::vector<double>& times);

/// Mean frequency between two times [Hz]; 0: unknown. Outside the known times the nearest known
/// interval is used.
[[nodiscard]] double frequency_between(const MarkEventCounts& mark, double from, double to);

/// The marks with their mean frequencies over the run, without those of zero frequency.
[[nodiscard]] std::vector<desktop::ChartMark> mean_marks(const std::vector<MarkEventCounts>& marks);

}  // namespace adore::adrplot
