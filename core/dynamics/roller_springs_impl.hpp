#pragma once

#include "base/simd_math.hpp"
#include "contact/land_edge.hpp"
#include "contact/roller_race_simd.hpp"
#include "dynamics/roller_springs.hpp"

#include <array>
#include <cstddef>

/// The slices of one roller against one race, a slice a lane. Included by one translation unit per
/// instruction set.
namespace adore::dynamics {
namespace {

using V = SimdReal;
using Lanes = contact::SliceLanes<V>;

inline void sum_springs(const contact::RaceSlicesView& slices, const statics::SliceRotations& axes,
                        double x, double r, RollerSprings& out) {
  using M = ScalarMath<V>;
  const contact::RaceSurface& surface = slices.race;
  statics::SliceSums<V> sums;
  statics::EdgeSums<V> edges;
  V tan_chi = 0.0, last = 0.0;
  for (std::size_t k = 0; k < slices.count; k += Lanes::kSize) {
    const V s = Lanes::read(slices.s + k), radius = Lanes::read(slices.radius + k);
    V width = Lanes::read(slices.width + k);
    const contact::DeepestSlicePoint<V> d =
        contact::deepest_slice_point(surface, axes, x, r, s, radius, tan_chi);
    // χ changes evenly along the roller: the next slices start from its extrapolation.
    const V found = tan_chi;
    tan_chi = k == 0 ? found : 2.0 * found - last;
    last = found;
    if (!M::any(d.at.depth > 0.0)) continue;
    V narrows = 0.0;  // change of the width over the land coordinate
    if (slices.limited) {
      const V at = contact::land_coordinate(
          surface, contact::slice_axial_position(surface, axes, x, s, radius));
      narrows =
          -contact::width_slope_over_offset(at, width, surface.land_offset, surface.land_width);
      width = contact::overlap_width(at, width, surface.land_offset, surface.land_width);
    }
    const V delta = M::max(d.at.depth, V(0.0));
    const V secant = contact::slice_secant_stiffness(slices.law, width, delta);
    sums.add(axes, d, secant * delta, (10.0 / 9.0) * secant);
    if (!M::any(narrows != 0.0)) continue;
    edges.add(statics::land_position_derivatives(axes, surface.sigma(), s, radius), sums.over,
              secant * delta, delta, width, narrows, surface.cos_angle);
  }
  if (edges.reached) {
    for (std::size_t i = 0; i < 4; ++i) sums.gradient[i] += edges.gradient[i];
    for (std::size_t i = 0; i < 10; ++i) sums.hessian[i] += edges.hessian[i];
  }
  std::size_t k = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    out.gradient[i] = Lanes::sum(sums.gradient[i]);
    for (std::size_t j = 0; j <= i; ++j) out.hessian[i][j] = Lanes::sum(sums.hessian[k++]);
    for (std::size_t j = 0; j < i; ++j) out.hessian[j][i] = out.hessian[i][j];
  }
  out.load = Lanes::sum(sums.load);
  out.stiffness = Lanes::sum(sums.slope);
}

}  // namespace
}  // namespace adore::dynamics
