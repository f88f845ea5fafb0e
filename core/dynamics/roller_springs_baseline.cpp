#include "dynamics/roller_springs_impl.hpp"

namespace adore::dynamics {

void roller_springs_baseline(const contact::RaceSlices& slices, const statics::SliceTurns& axes,
                             double x, double r, RollerSprings& out) noexcept {
  sum_springs(slices, axes, x, r, out);
}

}  // namespace adore::dynamics
