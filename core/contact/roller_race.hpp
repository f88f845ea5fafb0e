#pragma once

#include "contact/line_contact.hpp"
#include "contact/slice_circle.hpp"
#include "contact/slice_traction.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <span>
#include <type_traits>
#include <vector>

/// All that one race does to one roller that moves: penetration, load, slip and traction of every
/// slice, for motion. One source for numbers (T = double) and for a slice a lane (T = vector). SI.
///
/// Slice k: X_k, n_k, δ_k of contact/slice_circle.hpp; Q_k = K_l L_e^(-1/9) w_k δ_k^(10/9), w_k the
/// part of the slice on the land of the race; slip u_k = v_race(X_k) - v_roller(X_k) without its
/// part along n_k.
///   on the roller:  F = Σ f_k,  M_C = Σ (X_k - C) × f_k,  f_k = -Q_k n_k + Q_k g(u_k²) u_k
///   on the race:    -F,  and -(C - c) × F - M_C about its reference point c
///   U = Σ 9/19 Q_k δ_k,  heat = Σ Q_k g u_k² >= 0,  load-slip = Σ Q_k |u_k|
/// g is the rounded law κ(s)/s (tribology/rounded_law.hpp). Without traction (F, M_C) is minus the
/// gradient of U over every displacement and turn of the roller (δ_k is a maximum over its circle,
/// so the point may be held), and the race gets the opposite; it is the force of statics
/// (statics/slice_potential.hpp) at the same pose. The edge of a land is left out of the potential
/// there as here: no force pulls a roller over it.
/// Line pressure of slice k: p = √(Q_k/w_k E* Σρ/π), Σρ = 1/ρ_k - n_r/r.
/// Limits: the roller axis points towards +x of the race (|angle| < π/2); no spin within the width
/// of a contact; slices are independent.
namespace adore::contact {

/// One race against rollers of one shape; arrays in slice order, padded to whole vectors with
/// slices of width 0.
struct RollerRaceSlices {
  RaceSurface race;
  PowerLaw law;
  double E_star = 0.0;    ///< for the pressure, which only some laws of traction ask for [Pa]
  std::size_t count = 0;  ///< slices
  std::vector<double> s, radius, width;  ///< [m]

  static constexpr std::size_t kPadding = 8;  ///< doubles of the widest vector
};
[[nodiscard]] inline RollerRaceSlices roller_race_slices(const RaceSurface& race,
                                                         std::span<const RollerSlice> slices,
                                                         double width, const PowerLaw& law,
                                                         double E_star) {
  RollerRaceSlices out{race, law, E_star, slices.size(), {}, {}, {}};
  const std::size_t padded = (slices.size() + RollerRaceSlices::kPadding - 1) /
                             RollerRaceSlices::kPadding * RollerRaceSlices::kPadding;
  for (std::size_t k = 0; k < padded; ++k) {
    const RollerSlice& slice = slices[std::min(k, slices.size() - 1)];
    out.s.push_back(slice.s);
    out.radius.push_back(slice.radius);
    out.width.push_back(k < slices.size() ? width : 0.0);
  }
  return out;
}

/// What the contact does; vectors in the frame in which pose and motion were given.
struct RollerRaceAction {
  Vec3 force = Vec3::Zero();        ///< on the roller [N]
  Vec3 moment = Vec3::Zero();       ///< on the roller about C [N m]
  Vec3 race_moment = Vec3::Zero();  ///< on the race about its reference point [N m]; force: -force
  double load = 0.0;                ///< Σ Q_k [N]
  double energy = 0.0;              ///< U [J]
  double heat = 0.0, load_slip = 0.0;  ///< [W]
};

/// How vectors are read from memory and summed over lanes: for double, and in roller_race_simd.hpp
/// for vectors.
template <class T>
struct SliceLanes;
template <>
struct SliceLanes<double> {
  static constexpr std::size_t kSize = 1;
  static double read(const double* from) { return *from; }
  static double sum(double x) { return x; }
};

/// @param centre C, axis a and the motion of the roller, pose and motion of the race: one frame
/// @param traction callable (u², pressure) -> κ(s)/s on T, or nullptr: none. No throw, no
/// allocation.
template <class T, class Traction>
[[nodiscard]] RollerRaceAction roller_race_action(const RollerRaceSlices& slices,
                                                  const RacePose& pose, const RigidMotion& race,
                                                  const Vec3& centre, const Vec3& axis,
                                                  const RigidMotion& roller,
                                                  const Traction& traction) noexcept {
  using M = ScalarMath<T>;
  using Lanes = SliceLanes<T>;
  constexpr bool kTraction = !std::is_null_pointer_v<Traction>;
  const Vec3 C = pose.point(centre);
  double r = 0.0;
  const MeridianTurn turn = meridian_turn(C[1], C[2], r);
  const auto into = [&](const Vec3& v) {
    const Vec3 of_race = pose.direction(v);
    return turn.into({of_race[0], of_race[1], of_race[2]});
  };
  const Triple<double> a = into(axis);
  const SliceAxes axes = slice_axes(a.z, a.y);
  // Race minus roller, as a rigid motion about C.
  Triple<double> velocity{}, omega{};
  if constexpr (kTraction) {
    velocity = into(race.at(centre) - roller.at(centre));
    omega = into(race.omega - roller.omega);
  }
  const RaceSurface& surface = slices.race;
  const bool limited = !std::isinf(surface.land_width);
  const double high = surface.land_offset + 0.5 * surface.land_width;
  const double low = surface.land_offset - 0.5 * surface.land_width;

  Triple<T> force{T(0.0), T(0.0), T(0.0)}, moment{T(0.0), T(0.0), T(0.0)};
  T load = 0.0, energy = 0.0, heat = 0.0, load_slip = 0.0;
  T tan_chi = 0.0, last = 0.0;
  for (std::size_t k = 0; k < slices.s.size(); k += Lanes::kSize) {
    const T s = Lanes::read(slices.s.data() + k);
    const T radius = Lanes::read(slices.radius.data() + k);
    T width = Lanes::read(slices.width.data() + k);
    const SliceDeepest<T> d = deepest_on_slice(surface, axes, C[0], r, s, radius, tan_chi);
    // χ changes evenly along the roller: the next slices start from its extrapolation.
    const T found = tan_chi;
    tan_chi = k == 0 ? found : 2.0 * found - last;
    last = found;
    if (!M::any(d.at.depth > 0.0)) continue;
    if (limited) {
      const T x = (d.X.x - surface.mid_x) / surface.cos_angle;
      const T half = 0.5 * width;
      width = M::max(M::min(half, high - x) - M::max(-half, low - x), T(0.0));
    }
    const T delta = M::max(d.at.depth, T(0.0));
    const T Q = slice_secant(slices.law, width, delta) * delta;
    const Triple<T>& n = d.at.n;
    const Triple<T> arm = s * axes.a + radius * d.u;
    Triple<T> f{-Q * n.x, -Q * n.y, -Q * n.z};
    if constexpr (kTraction) {
      const Triple<T> u = velocity + cross(omega, arm);
      const Triple<T> slip = u - dot(u, n) * n;
      const T square = dot(slip, slip);
      // Pressures of slices without width are not read: Q is 0 there.
      const T per_length = Q / M::max(width, T(1e-30));
      const T pressure =
          M::root(per_length * ((1.0 / radius - d.at.A_hoop) * (slices.E_star / std::numbers::pi)));
      const T per_slip = Q * traction(square, pressure);
      f = f + per_slip * slip;
      heat += per_slip * square;
      load_slip += Q * M::root(square);
    }
    force = force + f;
    moment = moment + cross(arm, f);
    load += Q;
    energy += (9.0 / 19.0) * Q * delta;
  }
  const auto back = [&](const Triple<T>& v) {
    const Triple<double> b = turn.back({Lanes::sum(v.x), Lanes::sum(v.y), Lanes::sum(v.z)});
    return pose.direction_back({b.x, b.y, b.z});
  };
  RollerRaceAction out;
  out.force = back(force);
  out.moment = back(moment);
  out.race_moment = -(centre - pose.centre).cross(out.force) - out.moment;
  out.load = Lanes::sum(load);
  out.energy = Lanes::sum(energy);
  out.heat = Lanes::sum(heat);
  out.load_slip = Lanes::sum(load_slip);
  return out;
}

}  // namespace adore::contact
