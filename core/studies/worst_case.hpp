#pragma once

#include "studies/points.hpp"

#include <vector>

/// Search of the largest or smallest value of one quantity within the ranges of the variables.
///
/// First round: the samples, the middle, and the corners of the box while there are no more than 32
/// of them (quantities that rise or fall throughout have their extreme in a corner). Then a compass
/// search from the best point: a step of a quarter of each range to both sides of every variable;
/// if that finds nothing better the step is halved, down to a hundredth. It finds the extreme of
/// a quantity with one maximum; with several, that of the maximum near a sample.
/// Every round follows from the results before it, so that a search can continue after an
/// interruption.
namespace adore::studies {

[[nodiscard]] std::vector<Point> first_round_points(const Study& study);
/// Points of the first round in addition to the samples.
[[nodiscard]] std::size_t count_corners_and_middle(const Study& study);

class WorstCaseSearch {
 public:
  explicit WorstCaseSearch(const Study& study);

  /// Takes the values of the objective at the points of the round before (NaN: a failed run) and
  /// gives the next round; empty: the search is over.
  [[nodiscard]] std::vector<Point> next(const std::vector<Point>& points,
                                        const std::vector<double>& values);
  /// The best point so far; empty: no run has a value.
  [[nodiscard]] const std::vector<double>& best() const { return best_point_; }
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double step() const { return step_; }  ///< share of the ranges
  [[nodiscard]] int rounds() const { return round_; }

 private:
  const Study& study_;
  std::vector<double> low_, high_, best_point_;
  double value_ = 0.0, step_ = 0.25;
  int round_ = 0;
};

}  // namespace adore::studies
