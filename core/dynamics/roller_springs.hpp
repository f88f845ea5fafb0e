#pragma once

#include "contact/roller_race_sum.hpp"
#include "statics/slice_sums.hpp"

/// Boundary between held_rollers.cpp and the translation units that are compiled once per
/// instruction set (reason in race_kernel.hpp): the sums of slices with their derivatives of
/// statics/slice_potential.hpp for a roller that moves, edges of lands included.
namespace adore::dynamics {

/// dU over p = (x, r, t, f) and its derivative, row by row.
struct RollerSprings {
  double gradient[4], hessian[4][4];
  double load, stiffness;
};

using RollerSpringsKernel = void (*)(const contact::RaceSlicesView& slices,
                                     const statics::SliceRotations& axes, double x, double r,
                                     RollerSprings& out) noexcept;

void roller_springs_baseline(const contact::RaceSlicesView& slices,
                             const statics::SliceRotations& axes, double x, double r,
                             RollerSprings& out) noexcept;
#if defined(__x86_64__)
void roller_springs_avx2(const contact::RaceSlicesView& slices, const statics::SliceRotations& axes,
                         double x, double r, RollerSprings& out) noexcept;
void roller_springs_avx512(const contact::RaceSlicesView& slices,
                           const statics::SliceRotations& axes, double x, double r,
                           RollerSprings& out) noexcept;
#endif

}  // namespace adore::dynamics
