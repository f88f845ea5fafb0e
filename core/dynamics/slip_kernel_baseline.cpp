#include "dynamics/race_slip_impl.hpp"

namespace adore::dynamics {

void race_slip_baseline(const RaceKernelInput& in) noexcept { slip_on_race(in); }

}  // namespace adore::dynamics
