#pragma once

#include "base/simd_math.hpp"
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

/// What depends on the place of contacts at an edge of the land, through their width: ∂U_p over the
/// land coordinate of the point.
struct EdgeSums {
  std::array<V, 4> of[4];
  EdgeSums() {
    for (auto& row : of) row.fill(V(0.0));
  }
  void add(const statics::SliceSums<V>& slices, const V& load_slope) {
    const std::array<V, 4> along{V(1.0), V(0.0), slices.X_t.x, slices.X_f.x};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) of[i][j] += load_slope * slices.over[i] * along[j];
  }
};

inline void sum_springs(const contact::RaceSlices& slices, const statics::SliceTurns& axes,
                        double x, double r, RollerSprings& out) {
  using M = ScalarMath<V>;
  const contact::RaceSurface& surface = slices.race;
  statics::SliceSums<V> sums;
  EdgeSums edges;
  bool edge = false;
  V tan_chi = 0.0, last = 0.0;
  for (std::size_t k = 0; k < slices.count; k += Lanes::kSize) {
    const V s = Lanes::read(slices.s + k), radius = Lanes::read(slices.radius + k);
    V width = Lanes::read(slices.width + k);
    const contact::SliceDeepest<V> d =
        contact::deepest_on_slice(surface, axes, x, r, s, radius, tan_chi);
    // χ changes evenly along the roller: the next slices start from its extrapolation.
    const V found = tan_chi;
    tan_chi = k == 0 ? found : 2.0 * found - last;
    last = found;
    if (!M::any(d.at.depth > 0.0)) continue;
    V narrows = 0.0;  // change of the width over the land coordinate
    if (slices.limited) {
      const V at = contact::land_coordinate(surface, d.X.x);
      narrows = -contact::width_slope(at, width, surface.land_offset, surface.land_width);
      width = contact::overlap_width(at, width, surface.land_offset, surface.land_width);
    }
    const V delta = M::max(d.at.depth, V(0.0));
    const V secant = contact::slice_secant(slices.law, width, delta);
    sums.add(axes, d, secant * delta, (10.0 / 9.0) * secant);
    if (!M::any(narrows != 0.0)) continue;
    edge = true;
    // Slices beyond the land, which do not press, change nothing.
    const V load_slope = M::pick(width > 0.0, secant * delta / M::max(width, V(1e-30)), V(0.0));
    edges.add(sums, load_slope * narrows / surface.cos_angle);
  }
  std::size_t k = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    out.gradient[i] = Lanes::sum(sums.gradient[i]);
    for (std::size_t j = 0; j <= i; ++j) out.hessian[i][j] = Lanes::sum(sums.hessian[k++]);
    for (std::size_t j = 0; j < i; ++j) out.hessian[j][i] = out.hessian[i][j];
  }
  for (std::size_t i = 0; edge && i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) out.hessian[i][j] += Lanes::sum(edges.of[i][j]);
  out.load = Lanes::sum(sums.load);
  out.stiffness = Lanes::sum(sums.slope);
}

}  // namespace
}  // namespace adore::dynamics
