#pragma once

#include "dynamics/race_kernel.hpp"

/// Largest slip of every ball on one race, for a sample between stored steps: geometry and motion
/// as in the race kernels, no traction. In separate translation units, so that the hot kernels do
/// not change (decision 750).
namespace adore::dynamics {

/// Largest slip speed of each ball goes to `load` [m/s], 0 of open contacts:
/// tribology/largest_slip.hpp. Nothing else is written, but all targets are touched.
/// @pre traction is set: the ellipse is read
using RaceSlipKernel = void (*)(const RaceKernelInput&) noexcept;

void race_slip_baseline(const RaceKernelInput& in) noexcept;
#if defined(__x86_64__)
void race_slip_avx2(const RaceKernelInput& in) noexcept;
void race_slip_avx512(const RaceKernelInput& in) noexcept;
#endif

}  // namespace adore::dynamics
