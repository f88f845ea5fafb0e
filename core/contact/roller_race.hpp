#pragma once

#include "contact/line_contact.hpp"
#include "contact/race_surface.hpp"
#include "contact/roller_race_sum.hpp"
#include "contact/slice_traction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

/// All that one race does to one roller that moves: penetration, load, slip and traction of every
/// slice, for motion. One source for numbers (T = double) and for a slice a lane (T = vector). SI.
///
/// Slice k: X_k, n_k, δ_k of contact/slice_circle.hpp; Q_k = K_l L_e^(-1/9) w_k δ_k^(10/9), w_k the
/// part of the slice on the land of the race; slip u_k = v_race(Y_k) - v_roller(Y_k) without its
/// part along n_k, at the middle of the overlap, Y_k = X_k - δ_k n_k/2: two bodies of one stiffness
/// meet half way between their profiles, whichever of them is crowned, as the ball's surface of
/// 2fD/(2f+1) does [harris2006; choice of the half for unlike materials, too].
///   on the roller:  F = Σ f_k,  M_C = Σ (Y_k - C) × f_k,  f_k = -Q_k n_k + Q_k g(u_k²) u_k
///   on the race:    -F,  and -(C - c) × F - M_C about its reference point c
///   U = Σ 9/19 Q_k δ_k,  heat = Σ Q_k g u_k² >= 0,  load-slip = Σ Q_k |u_k|
/// g is the rounded law κ(s)/s (tribology/rounded_law.hpp). Without traction (F, M_C) is minus the
/// gradient of U over every displacement and turn of the roller (δ_k is a maximum over its circle,
/// so the point may be held), and the race gets the opposite; it is the force of statics
/// (statics/slice_potential.hpp) at the same pose. Where a roller reaches over the edge of a land
/// that is in the gradient, too (contact/land_edge.hpp).
/// With damping F of contact/damping_law.hpp stands for Q_k but in U: friction, pressure, loads and
/// load-slip are of the total force.
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
  /// A cone about the roller that holds all slices: where it ends, and its radii there [m].
  std::array<double, 2> end{}, around{};
  DampingLaw<> damping;  ///< none: elastic

  static constexpr std::size_t kPadding = 8;  ///< doubles of the widest vector
};
[[nodiscard]] inline RollerRaceSlices roller_race_slices(const RaceSurface& race,
                                                         std::span<const RollerSlice> slices,
                                                         double width, const PowerLaw& law,
                                                         double E_star) {
  RollerRaceSlices out{race, law, E_star, slices.size(), {}, {}, {}, {}, {}, {}};
  const std::size_t padded = (slices.size() + RollerRaceSlices::kPadding - 1) /
                             RollerRaceSlices::kPadding * RollerRaceSlices::kPadding;
  for (std::size_t k = 0; k < padded; ++k) {
    const RollerSlice& slice = slices[std::min(k, slices.size() - 1)];
    out.s.push_back(slice.s);
    out.radius.push_back(slice.radius);
    out.width.push_back(k < slices.size() ? width : 0.0);
  }
  const RollerSlice &first = slices.front(), &last = slices.back();
  const double rise = slices.size() > 1 ? (last.radius - first.radius) / (last.s - first.s) : 0.0;
  double beyond = 0.0;
  for (const RollerSlice& slice : slices)
    beyond = std::max(beyond, slice.radius - first.radius - rise * (slice.s - first.s));
  out.end = {first.s, last.s};
  out.around = {first.radius + beyond, last.radius + beyond};
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

[[nodiscard]] inline RaceSlicesView view_of(const RollerRaceSlices& slices) noexcept {
  return {slices.race,
          slices.law,
          slices.E_star,
          !std::isinf(slices.race.land_width),
          slices.s.size(),
          slices.s.data(),
          slices.radius.data(),
          slices.width.data(),
          {slices.end[0], slices.end[1]},
          {slices.around[0], slices.around[1]},
          slices.damping,
          is_damped(slices.damping)};
}

/// No slice can touch: a bound from the pose alone, for races along cones; of grooves never known.
/// Depth grows by no more than the way, so that a slice about P is no deeper than φ(P) + ρ; along
/// the roller axis that bound is convex with r (outer race) or with r's part in the meridian plane,
/// which is no more (inner race), so that it is greatest at an end. Crowns recede from the cone.
[[nodiscard]] inline bool is_certainly_open(const RaceSlicesView& slices, double x, double r,
                                            const Triple<double>& axis) noexcept {
  const RaceSurface& race = slices.race;
  if (race.shape == RaceSurface::Shape::Groove) return false;
  for (int k = 0; k < 2; ++k) {
    const double s = slices.end[k], z = r + s * axis.z, y = s * axis.y;
    const double from_axis = race.side == 0 ? std::sqrt(y * y + z * z) : z;
    const double depth = race.sigma() * ((from_axis - race.radius) * race.cos_angle +
                                         (x + s * axis.x) * race.sin_angle);
    if (!(depth + slices.around[k] < 0.0)) return false;
  }
  return true;
}

/// A roller as the sums read it, and the way back to the frame of its pose.
struct RollerInMeridian {
  RollerPose roller;
  MeridianRotation turn;
  [[nodiscard]] Vec3 back(const RacePose& pose, const Triple<double>& v) const noexcept {
    const Triple<double> of_race = turn.from_meridian(v);
    return pose.direction_from_race({of_race.x, of_race.y, of_race.z});
  }
};
[[nodiscard]] inline RollerInMeridian roller_in_meridian(const RacePose& pose,
                                                         const RigidMotion& race,
                                                         const Vec3& centre, const Vec3& axis,
                                                         const RigidMotion& roller) noexcept {
  RollerInMeridian out;
  const Vec3 C = pose.point(centre);
  out.turn = meridian_rotation(C[1], C[2], out.roller.r);
  const auto to_meridian = [&](const Vec3& v) {
    const Vec3 of_race = pose.direction(v);
    return out.turn.to_meridian({of_race[0], of_race[1], of_race[2]});
  };
  const Triple<double> a = to_meridian(axis);
  out.roller.x = C[0];
  out.roller.axes = slice_axes(a.z, a.y);
  // Race minus roller, as a rigid motion about C.
  out.roller.velocity = to_meridian(race.at(centre) - roller.at(centre));
  out.roller.omega = to_meridian(race.omega - roller.omega);
  return out;
}

/// @param centre C, axis a and the motion of the roller, pose and motion of the race: one frame
/// @param traction callable (u², pressure) -> κ(s)/s on T, or nullptr: none. No throw, no
/// allocation.
template <class T, class Traction>
[[nodiscard]] RollerRaceAction roller_race_action(const RollerRaceSlices& slices,
                                                  const RacePose& pose, const RigidMotion& race,
                                                  const Vec3& centre, const Vec3& axis,
                                                  const RigidMotion& roller,
                                                  const Traction& traction) noexcept {
  using Lanes = SliceLanes<T>;
  const RollerInMeridian in = roller_in_meridian(pose, race, centre, axis, roller);
  const RollerRaceSums<T> sums = roller_race_sums<T>(view_of(slices), in.roller, traction);
  RollerRaceAction out;
  const auto back = [&](const Triple<T>& v) {
    return in.back(pose, {Lanes::sum(v.x), Lanes::sum(v.y), Lanes::sum(v.z)});
  };
  out.force = back(sums.force);
  out.moment = back(sums.moment);
  out.race_moment = -(centre - pose.centre).cross(out.force) - out.moment;
  out.load = Lanes::sum(sums.load);
  out.energy = Lanes::sum(sums.energy);
  out.heat = Lanes::sum(sums.heat);
  out.load_slip = Lanes::sum(sums.load_slip);
  return out;
}

}  // namespace adore::contact
