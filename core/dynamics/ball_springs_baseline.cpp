#include "dynamics/ball_springs_impl.hpp"

namespace adore::dynamics {

void ball_springs_baseline(const BallSpringsInput& in, BallSpring* out) noexcept {
  find_springs(in, out);
}

}  // namespace adore::dynamics
