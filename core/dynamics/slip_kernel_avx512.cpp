// Compiled with the flags that core/CMakeLists.txt sets for this file on x86-64; empty elsewhere.
#if defined(__x86_64__)
#include "dynamics/race_slip_impl.hpp"

namespace adore::dynamics {

void race_slip_avx512(const RaceKernelInput& in) noexcept { run_slip_kernel(in); }

}  // namespace adore::dynamics
#endif
