#pragma once

#include "adrplot/own_chart.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

/// Curves taken from the pages of files for a user-defined chart.
namespace adore::adrplot {

/// Identifies a curve: quantity, body and run.
using Names = std::array<std::string, 3>;

struct CollectedCurve {
  std::string name, unit, title;
  int group = -1;
  Names names = {};
  std::string brief = {};  ///< without the common part of all curves
  std::vector<double> x, y;
  bool wraps = false;
  int element = 0;             ///< its rolling element, from 1; 0: another body
  std::vector<bool> own = {};  ///< as long as x: a value that is stored; empty: all are
  /// Extremes between the stored values, as long as x; empty: not known.
  std::vector<double> low = {}, high = {};
};

[[nodiscard]] std::string joined_names(const Names& names, const std::array<bool, 3>& which);

/// The names that distinguish the curves, and always the quantity.
[[nodiscard]] std::array<bool, 3> distinguishing_names(const std::vector<CollectedCurve>& curves);

/// Notes of the pages of the curves: once if they apply to all curves, else by curve name.
class SourceNotes {
 public:
  void add(const std::string& source, const std::string& sentence);
  void add_notes_to(desktop::ChartPage& page) const;

 private:
  std::vector<std::string> sources_;
  std::vector<std::pair<std::string, std::vector<std::string>>> sources_by_sentence_;
};

/// The selected curves, each over its own horizontal axis, whose title and unit are stored in the
/// page.
[[nodiscard]] std::vector<CollectedCurve> take(const std::vector<CurvePick>& picks,
                                               const PageOptions& options, Domain domain,
                                               desktop::ChartPage& page, SourceNotes& notes);

}  // namespace adore::adrplot
