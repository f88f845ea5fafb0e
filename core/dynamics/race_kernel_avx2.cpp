// Compiled with the flags that core/CMakeLists.txt sets for this file on x86-64; empty elsewhere.
#if defined(__x86_64__)
#include "dynamics/race_kernel_impl.hpp"
#include "dynamics/race_pair_impl.hpp"
#include "dynamics/race_rolling_impl.hpp"

namespace adore::dynamics {

RaceKernelSums race_kernel_avx2(const RaceKernelInput& in) noexcept { return evaluate_race(in); }
void race_pair_avx2(const RaceKernelInput* in, RaceKernelSums* sums) noexcept {
  evaluate_pair(in, sums);
}
RaceKernelSums race_rolling_avx2(const RaceKernelInput& in) noexcept {
  return run_rolling_kernel(in);
}

}  // namespace adore::dynamics
#endif
