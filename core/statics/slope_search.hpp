#pragma once

#include <algorithm>

/// Line search for a convex potential: the load along a step must fall to between 90 % and -50 % of
/// its first value. Overshoot brackets the minimum from above, undershoot after an overshoot from
/// below. For the race on its elements and for one element between its races alike.
namespace adore::statics {

class SlopeSearch {
 public:
  /// @param first load along the step where it begins
  /// @param closed width of the bracket, over its upper end, in which nothing is left to search
  SlopeSearch(double first, double closed) noexcept : first_(first), bracket_width_limit_(closed) {}

  /// What to try, as a share of the step.
  [[nodiscard]] double length() const noexcept { return t_; }

  /// Is length() good, where the load along the step is `slope`? If not, it is now another one.
  [[nodiscard]] bool accepts(double slope) noexcept {
    const bool bracket_closed = high_ > 0.0 && high_ - low_ <= bracket_width_limit_ * high_;
    if (slope < -0.5 * first_ && first_ > 0.0 && !bracket_closed) {
      high_ = t_;
      t_ = low_ + (high_ - low_) * std::clamp(first_ / (first_ - slope), 0.05, 0.5);
      return false;
    }
    if (slope > 0.9 * first_ && high_ > 0.0 && !bracket_closed) {
      low_ = t_;
      t_ = 0.5 * (low_ + high_);
      return false;
    }
    return true;
  }
  /// Nothing is known at length(): nearer.
  void backtrack() noexcept {
    high_ = t_;
    t_ = 0.5 * (low_ + high_);
  }

 private:
  double first_, bracket_width_limit_;
  double low_ = 0.0, high_ = 0.0;  ///< high 0: no overshoot yet
  double t_ = 1.0;
};

}  // namespace adore::statics
