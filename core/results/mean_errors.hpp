#pragma once

#include <array>
#include <limits>

namespace adore::results {

/// Half of the 95 % interval of each mean (results/batch_means.hpp), in the unit of the mean; NaN:
/// not computed. Heat, ratios and race load from the stored steps, the largest load from every
/// step.
struct MeanErrors {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double orbital_ratio = kNone, cage_ratio = kNone, swept_whirl_ratio = kNone;
  double power_loss = kNone, heat_outer = kNone, heat_inner = kNone, heat_elsewhere = kNone;
  double largest_load = kNone;
  std::array<double, 3> load{kNone, kNone, kNone};
};

}  // namespace adore::results
