#include "studies/worst_case.hpp"

#include <algorithm>
#include <cmath>

namespace adore::studies {
namespace {

constexpr std::size_t kMaxCornerVariables = 5;  ///< variables
constexpr double kMinStep = 0.01;               ///< of the ranges

/// Ends of every target's range.
void ends(const Study& study, std::vector<double>& low, std::vector<double>& high) {
  for (const Variable& variable : study.variables)
    for (std::size_t k = 0; k < variable.targets.size(); ++k) {
      low.push_back(variable.a);
      high.push_back(variable.b);
    }
}

}  // namespace

std::size_t count_corners_and_middle(const Study& study) {
  std::vector<double> low, high;
  ends(study, low, high);
  return 1 + (low.size() <= kMaxCornerVariables ? std::size_t{1} << low.size() : 0);
}

std::vector<Point> first_round_points(const Study& study) {
  std::vector<Point> out = make_points(study);
  std::vector<double> low, high, at;
  ends(study, low, high);
  for (std::size_t k = 0; k < low.size(); ++k) at.push_back(0.5 * (low[k] + high[k]));
  out.push_back(point_at(study, at));
  if (low.size() <= kMaxCornerVariables)
    for (std::size_t corner = 0; corner < (std::size_t{1} << low.size()); ++corner) {
      for (std::size_t k = 0; k < low.size(); ++k)
        at[k] = ((corner >> k) & 1U) != 0 ? high[k] : low[k];
      out.push_back(point_at(study, at));
    }
  return out;
}

WorstCaseSearch::WorstCaseSearch(const Study& study) : study_(study) { ends(study, low_, high_); }

std::vector<Point> WorstCaseSearch::next(const std::vector<Point>& points,
                                         const std::vector<double>& values) {
  const bool first = round_ == 0;
  bool better = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isnan(values[i])) continue;
    if (best_point_.empty() || (study_.seek_largest ? values[i] > value_ : values[i] < value_)) {
      best_point_ = points[i].values;
      value_ = values[i];
      better = true;
    }
  }
  if (best_point_.empty()) return {};
  if (!first && !better) step_ *= 0.5;
  if (step_ < kMinStep || round_ >= study_.rounds) return {};
  ++round_;
  std::vector<Point> out;
  for (std::size_t k = 0; k < best_point_.size(); ++k)
    for (const double side : {-1.0, 1.0}) {
      std::vector<double> at = best_point_;
      at[k] = std::clamp(at[k] + side * step_ * (high_[k] - low_[k]), low_[k], high_[k]);
      if (at[k] != best_point_[k]) out.push_back(point_at(study_, at));
    }
  return out;
}

}  // namespace adore::studies
