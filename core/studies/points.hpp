#pragma once

#include "studies/study.hpp"

#include <string>
#include <vector>

/// Which runs a study consists of.
namespace adore::studies {

/// One run to be made: what differs from the base.
struct Point {
  std::size_t deck = 0;  ///< of Study::decks
  Settings sets, options;
  std::vector<double> values;  ///< one per Columns::names
  std::string label;           ///< what-if: the case; otherwise empty
};

/// The columns of the table with the varied values.
struct Columns {
  std::vector<std::string> names;  ///< deck variables, options; lots have one for each element
  bool decks = false;              ///< more than one deck: a separate column
  bool labels = false;
};
[[nodiscard]] Columns columns_of(const Study& study);

/// How many points; cheap: none is made. @throws InputError for more than kMaxStudyRuns, and for
/// points that together take more memory than kMaxStudyBytes
[[nodiscard]] long count_points(const Study& study);

/// Memory of a run in the lists of points and tasks [bytes].
[[nodiscard]] double point_memory_bytes(const Point& point);

/// All points of kinds that know them beforehand, in the order of the table: decks, then values of
/// grids and lists (the last one fastest), then samples, then bearing seeds. For a worst-case
/// search the first round. @throws InputError for a correlation that cannot be
[[nodiscard]] std::vector<Point> make_points(const Study& study);

/// A point of a worst-case search or of a sensitivity, at these values of the variables.
[[nodiscard]] Point point_at(const Study& study, const std::vector<double>& values);

/// As --set takes it: whole values without a decimal point, so that integer variables take them.
[[nodiscard]] std::string setting_text(double value);

/// Steps of a sensitivity: 0, then -2, -1, 1, 2 of each variable in turn.
inline constexpr int kSensitivitySides[] = {-2, -1, 1, 2};

}  // namespace adore::studies
