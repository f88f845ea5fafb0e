#pragma once

#include "base/rotation.hpp"
#include "contact/race_surface.hpp"
#include "contact/roller_profile.hpp"
#include "contact/slice_circle.hpp"

#include <cmath>
#include <span>

/// Penetration of roller slices into a race one by one, in the frame of the race: vectors for
/// calculators and figures around contact/slice_circle.hpp. SI.
///
/// Slice k is the circle about P = C + s_k a of radius ρ_k in the plane across the roller axis a;
/// greatest error of δ 1e-16 m at skew to 30 and tilt error to 20 mrad (rounding of coordinates of
/// 40 mm; measured in the tests).
///
/// Derivatives: δ is a maximum over its circle, so the point may be held: a displacement dC and a
/// turn dω of the roller about C give
///   dδ = n·dC + ((X - C) × n)·dω                          (`rotation_gradient`)
/// and a race that moves gives the negative, its turn about c with (X - c).
/// Skew needs no extra term: to second order δ(x) = δ(0) ± x²φ²/(2r), r the radius of the roller's
/// pitch circle (not of the race): the ends of a skewed roller dig into the outer race (+) and lift
/// off the inner (-) [derived]. Undefined where the roller axis is across that of the race.
namespace adore::contact {

struct SliceContact {
  double delta = 0.0;  ///< penetration, > 0 overlap [m]
  Vec3 point;          ///< X, on the roller [m]
  Vec3 normal;         ///< n at X, from the roller into the race
};

/// Roller axis from tilt θ and skew φ: a = (cos φ cos θ, sin φ, cos φ sin θ) in the azimuth frame.
/// Positive tilt lifts the +x end outward (a turn about -y), positive skew is right-handed about
/// the outward radial [choice, N101].
[[nodiscard]] inline Vec3 roller_axis(double tilt, double skew) noexcept {
  return {std::cos(skew) * std::cos(tilt), std::sin(skew), std::cos(skew) * std::sin(tilt)};
}
[[nodiscard]] inline double roller_tilt(const Vec3& axis) noexcept {
  return std::atan2(axis[2], axis[0]);
}
[[nodiscard]] inline double roller_skew(const Vec3& axis) noexcept {
  return std::asin(std::clamp(axis[1], -1.0, 1.0));
}

/// One slice; everything in the race frame. No throw, no allocation.
[[nodiscard]] inline SliceContact slice_contact(const RaceSurface& race, const Vec3& centre,
                                                const Vec3& axis,
                                                const RollerSlice& slice) noexcept {
  double r = 0.0, tan_chi = 0.0;
  const MeridianRotation turn = meridian_rotation(centre[1], centre[2], r);
  const double way = axis[0] < 0.0 ? -1.0 : 1.0;  // s along -a is -s along a
  const Triple<double> a = turn.to_meridian(Triple<double>{axis[0], axis[1], axis[2]});
  const DeepestSlicePoint<double> d = deepest_slice_point(
      race, slice_axes(way * a.z, way * a.y), centre[0], r, way * slice.s, slice.radius, tan_chi);
  const Triple<double> X = turn.from_meridian(d.X), n = turn.from_meridian(d.at.n);
  return {d.at.depth, {X.x, X.y, X.z}, {n.x, n.y, n.z}};
}

/// All slices of a roller against a displaced race; C, a and the results are in the frame in which
/// the pose is given.
/// @param contacts as many as slices
inline void roller_race_contacts(const RaceSurface& race, const RacePose& pose, const Vec3& centre,
                                 const Vec3& axis, std::span<const RollerSlice> slices,
                                 std::span<SliceContact> contacts) noexcept {
  const Vec3 C = pose.point(centre), a = pose.direction(axis);
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const SliceContact c = slice_contact(race, C, a, slices[k]);
    contacts[k] = {c.delta, pose.point_from_race(c.point), pose.direction_from_race(c.normal)};
  }
}

/// ∂δ/∂ω of a turn of the roller about `about` [m/rad]; ∂δ/∂C is the normal itself.
[[nodiscard]] inline Vec3 rotation_gradient(const SliceContact& contact,
                                            const Vec3& about) noexcept {
  return (contact.point - about).cross(contact.normal);
}

}  // namespace adore::contact
