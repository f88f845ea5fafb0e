#include "dynamics/race_kernel_impl.hpp"

namespace adore::dynamics {

RaceKernelSums race_kernel_baseline(const RaceKernelInput& in) noexcept {
  return evaluate_race(in);
}

}  // namespace adore::dynamics
