#include "dynamics/roller_springs_impl.hpp"

namespace adore::dynamics {

void roller_springs_baseline(const contact::RaceSlicesView& slices,
                             const statics::SliceRotations& axes, double x, double r,
                             RollerSprings& out) noexcept {
  sum_springs(slices, axes, x, r, out);
}

}  // namespace adore::dynamics
