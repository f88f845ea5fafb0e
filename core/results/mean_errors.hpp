#pragma once

#include "results/batch_means.hpp"

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

/// Batch sums behind these means.
struct MeanSeries {
  RatioSeries orbital_ratio, cage_ratio, swept_whirl_ratio;
  RatioSeries power_loss, heat_outer, heat_inner, heat_elsewhere;
  RatioSeries largest_load;
  std::array<RatioSeries, 3> load;
};

[[nodiscard]] MeanErrors errors_of(const MeanSeries& series);

}  // namespace adore::results
