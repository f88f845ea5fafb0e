// Compiled with the flags that core/CMakeLists.txt sets for this file on x86-64; empty elsewhere.
#if defined(__x86_64__)
#include "dynamics/ball_springs_impl.hpp"

namespace adore::dynamics {

void ball_springs_avx2(const BallSpringsInput& in, BallSpring* out) noexcept {
  find_springs(in, out);
}

}  // namespace adore::dynamics
#endif
