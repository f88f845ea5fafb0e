// Compiled with the flags that core/CMakeLists.txt sets for this file on x86-64; empty elsewhere.
#if defined(__x86_64__)
#include "dynamics/roller_springs_impl.hpp"

namespace adore::dynamics {

void roller_springs_avx512(const contact::RaceSlicesView& slices,
                           const statics::SliceRotations& axes, double x, double r,
                           RollerSprings& out) noexcept {
  sum_springs(slices, axes, x, r, out);
}

}  // namespace adore::dynamics
#endif
