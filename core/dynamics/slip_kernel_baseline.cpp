#include "dynamics/race_slip_impl.hpp"

namespace adore::dynamics {

void race_slip_baseline(const RaceKernelInput& in) noexcept { run_slip_kernel(in); }

}  // namespace adore::dynamics
