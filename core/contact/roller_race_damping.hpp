#pragma once

#include "contact/land_edge.hpp"
#include "contact/roller_race_sum.hpp"

#include <algorithm>

/// Material damping of the slices of one roller on one race (dynamics/effects/contact_damping.cpp):
/// beside its elastic load Q_k (roller_race_sum.hpp) slice k has -Q_k max(d δ̇_k, -1) n_k, with
///   δ̇_k = n_k · (v_roller(X_k) - v_race(X_k)) + ψ̇ ∂δ_k/∂ψ
/// The point X_k may be held, because δ_k is a maximum over its circle. The second part is that of
/// a race with errors: its surface changes with the azimuth ψ of C in the race, ψ̇ = v_y/r with the
/// velocity of the race relative to the roller; the force that does its work acts at C along y.
/// Plain numbers in the meridian frame, for kernels too. SI.
namespace adore::contact {

template <class T>
struct RollerDampingSums {
  Triple<T> force{T(0.0), T(0.0), T(0.0)};   ///< on the roller, without that of `turning`
  Triple<T> moment{T(0.0), T(0.0), T(0.0)};  ///< about C
  T heat = 0.0;                              ///< Σ Q_k max(d δ̇_k, -1) δ̇_k >= 0
  T turning = 0.0;                           ///< Σ Q_k max(d δ̇_k, -1) ∂δ_k/∂ψ [J/rad]
};

/// @param d [s/m], > 0; slope RaceSlope of a race with errors at the azimuth of C, or nullptr
template <class T, class Slope = std::nullptr_t>
[[nodiscard, gnu::always_inline]] inline RollerDampingSums<T> roller_damping_sums(
    const RaceSlices& slices, const RollerPose& at, double d,
    const Slope& slope = nullptr) noexcept {
  using M = ScalarMath<T>;
  using Lanes = SliceLanes<T>;
  constexpr bool kWavy = !std::is_null_pointer_v<Slope>;
  const RaceSurface& surface = slices.race;
  const double turning_speed = at.velocity.y / at.r;
  RollerDampingSums<T> sum;
  T tan_chi = 0.0;
  for (std::size_t k = 0; k < slices.count; k += Lanes::kSize) {
    const T radius = Lanes::read(slices.radius + k), s = Lanes::read(slices.s + k);
    const SliceDeepest<T> deepest =
        deepest_on_slice(surface, at.axes, at.x, at.r, s, radius, tan_chi);
    const T depth = M::max(deepest.at.depth, T(0.0));
    if (!M::any(depth > 0.0)) continue;
    T width = Lanes::read(slices.width + k);
    if (slices.limited)
      width =
          overlap_width(land_coordinate(surface, slice_place(surface, at.axes, at.x, s, radius)),
                        width, surface.land_offset, surface.land_width);
    const Triple<T>& n = deepest.at.n;
    const Triple<T> arm = s * at.axes.a + radius * deepest.u;
    T rate = -dot(at.velocity + cross(at.omega, arm), n), rise = 0.0;
    if constexpr (kWavy) {
      rise = depth_slope(surface, slope, deepest.X, deepest.at);
      rate += turning_speed * rise;
    }
    const T more = slice_secant(slices.law, width, depth) * depth * M::max(d * rate, T(-1.0));
    const Triple<T> f{-more * n.x, -more * n.y, -more * n.z};
    sum.force = sum.force + f;
    sum.moment = sum.moment + cross(arm, f);
    sum.heat += more * rate;
    if constexpr (kWavy) sum.turning += more * rise;
  }
  return sum;
}

}  // namespace adore::contact
