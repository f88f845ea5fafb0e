#include "dynamics/race_kernel_impl.hpp"
#include "dynamics/race_pair_impl.hpp"
#include "dynamics/race_rolling_impl.hpp"

namespace adore::dynamics {

RaceKernelSums race_kernel_baseline(const RaceKernelInput& in) noexcept {
  return evaluate_race(in);
}
void race_pair_baseline(const RaceKernelInput* in, RaceKernelSums* sums) noexcept {
  evaluate_pair(in, sums);
}
RaceKernelSums race_rolling_baseline(const RaceKernelInput& in) noexcept {
  return run_rolling_kernel(in);
}

}  // namespace adore::dynamics
