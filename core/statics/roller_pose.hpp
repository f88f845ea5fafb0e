#pragma once

#include "contact/slice_circle.hpp"
#include "statics/race_equilibrium.hpp"
#include "statics/race_pose.hpp"
#include "statics/roller_model.hpp"
#include "statics/roller_state.hpp"

#include <array>
#include <type_traits>

/// A roller as both races see it.
///
/// Azimuth frame: x along the bearing, z radially outward, y = z × x. Pose relative to race (centre
/// c, axis A): d = C - c, x' = d·A, r' e = d - x'A, y' = e × A, t = a·e, f = a·y'.
/// An inner race that is not round has R(ψ) = R + R' (ψ - ψ_k) near roller k: it is seen at r' - R'
/// (ψ - ψ_k), so that its normals lean and push sideways. The slope of the outer race pushes the
/// roller against its cage, which has no effect here.
namespace adore::statics {

/// Derivatives over the roller only, while it is brought into equilibrium; one unused, so that
/// loops fill vector registers.
using PlaceDual = Dual<4>;
/// Derivatives over the roller (0: x, 1: r, 2: tilt) and the inner race (3-7).
using RollerDual = Dual<8>;

/// Coordinate k of the roller (0-2) or of the inner race (3-7).
template <class S>
S coordinate(double value, int k) {
  if constexpr (std::is_same_v<S, RollerDual>) {
    return S::variable(value, k);
  } else if constexpr (std::is_same_v<S, PlaceDual>) {
    return k < 3 ? S::variable(value, k) : S(value);
  } else {
    return value;
  }
}

/// The azimuth frame of a roller in the base frame.
[[nodiscard]] inline contact::MeridianRotation azimuth_rotation(const RollerState& at) noexcept {
  return {-at.sin, at.cos};
}

/// Outer and inner.
template <class S>
using Races = std::array<RacePose<S>, 2>;

template <class S>
Races<S> races_at(const RollerModel& m, const Vec5& q) {
  Races<S> races;
  auto& [outer, inner] = races;
  if (m.outer_tilt[0] != 0.0 || m.outer_tilt[1] != 0.0) {
    outer.axis = tilted_axis(S(m.outer_tilt[0]), S(m.outer_tilt[1]));
  }
  outer.q = {S(0.0), S(0.0), S(0.0), S(m.outer_tilt[0]), S(m.outer_tilt[1])};
  for (int k = 0; k < 5; ++k) {
    inner.q[static_cast<std::size_t>(k)] = coordinate<S>(q(k), k + 3);
  }
  inner.centre = {inner.q[0], inner.q[1], inner.q[2]};
  inner.axis = tilted_axis(inner.q[3], inner.q[4]);
  return races;
}

template <class S>
struct Roller {
  Triple<S> centre, axis;
  S over_tilt_x, over_tilt_r;  ///< da/dθ in (x, r)
};

template <class S>
Roller<S> roller_at(const RollerModel& m, const RollerState& at) {
  const S x = coordinate<S>(at.e(0), 0);
  const S r = coordinate<S>(0.5 * m.rollers.pitch_diameter + at.e(1), 1);
  const S tilt = coordinate<S>(at.e(2) - m.rollers.axis_angle, 2);
  const S s = at.skew_cos * sine(tilt);
  const S c = at.skew_cos * cosine(tilt);
  return {{x, S(0.0), r}, {c, S(at.skew_sin), s}, -s, c};
}

/// Roller relative to one race.
template <class S>
struct Relative {
  Triple<S> d, A, e, y;
  S x, r, t, f;
  S seen;             ///< r less what a race that is not round has grown where the roller is now
  double lean = 0.0;  ///< dR/dψ of that race

  [[nodiscard]] Vec4 values() const {
    return {value_of(x), value_of(seen), value_of(t), value_of(f)};
  }
};

/// A race that is not round: `ahead` is the azimuth of the roller in it minus that of its body.
template <class S>
void apply_race_slope(const RollerContactGeometry& body, std::size_t j, const S& ahead,
                      Relative<S>& out) {
  out.seen = out.r;
  if (j == 1 && body.inner_slope != 0.0) {
    out.lean = body.inner_slope;
    out.seen = out.r - body.inner_slope * ahead;
  }
}

/// First order (reference family D): x' = x - q_x, r' = r - w, t = θ - g, w = z cos ψ - y sin ψ, g
/// = -(θ_y cos ψ + θ_z sin ψ).
template <class S>
Relative<S> linearized_relative_pose(const Roller<S>& roller, const RollerState& at,
                                     const RacePose<S>& race, const RollerContactGeometry& body,
                                     std::size_t j) {
  Relative<S> out{};  // f = 0: no skew to first order
  const auto& q = race.q;
  out.x = roller.centre.x - q[0];
  out.r = roller.centre.z - (q[2] * at.cos - q[1] * at.sin);
  out.t = coordinate<S>(at.e(2), 2) + (q[3] * at.cos + q[4] * at.sin);
  apply_race_slope(body, j, (q[1] * at.cos + q[2] * at.sin) / out.r, out);
  return out;
}

template <class S>
Relative<S> relative(const RollerModel& m, const Roller<S>& roller, const RollerState& at,
                     const RacePose<S>& race, std::size_t j) {
  const RollerContactGeometry& body = m.body(at.number);
  if (m.linear) {
    return linearized_relative_pose(roller, at, race, body, j);
  }
  const contact::MeridianRotation turn = azimuth_rotation(at);
  Relative<S> out;
  out.d = roller.centre - turn.to_meridian(race.centre);
  out.A = turn.to_meridian(race.axis);
  out.x = dot(out.d, out.A);
  const Triple<S> across = out.d - out.x * out.A;
  out.r = square_root(dot(across, across));
  out.e = (1.0 / out.r) * across;
  out.y = cross(out.e, out.A);
  out.t = dot(roller.axis, out.e);
  out.f = dot(roller.axis, out.y);
  apply_race_slope(body, j, -out.e.y, out);
  return out;
}

/// A roller at one pose as seen from both races.
template <class S>
struct Pose {
  Roller<S> roller;
  std::array<Relative<S>, 2> seen_from;
};
template <class S>
Pose<S> pose_of(const RollerModel& m, const RollerState& at, const Races<S>& races) {
  const Roller<S> roller = roller_at<S>(m, at);
  return {roller, {relative(m, roller, at, races[0], 0), relative(m, roller, at, races[1], 1)}};
}

}  // namespace adore::statics
