// Compiled with the flags that core/CMakeLists.txt sets for this file on x86-64; empty elsewhere.
#if defined(__x86_64__)
#include "dynamics/race_kernel_impl.hpp"
#include "dynamics/race_rolling_impl.hpp"

namespace adore::dynamics {

RaceKernelSums race_kernel_avx2(const RaceKernelInput& in) noexcept { return evaluate_race(in); }
RaceKernelSums race_rolling_avx2(const RaceKernelInput& in) noexcept { return roll_on_race(in); }

}  // namespace adore::dynamics
#endif
