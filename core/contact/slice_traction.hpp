#pragma once

#include "contact/slice_contact.hpp"

/// Slip, traction, force, moment and heat of contacts on a roller. SI.
///
/// All velocities in one non-rotating frame that coincides with the frame of the contact points at
/// the instant; ω absolute.
///   u = v_race(X) - v_roller(X) without its part along n
///   f = -Q n + κ(|u|) Q u/|u|,   F = Σ f,   M_C = Σ (X - C) × f,   heat = Σ κ Q |u|
/// Moment about the mass centre G = C + s_G a: M_G = M_C - s_G a × F.
/// A skewed roller slips axially by ∓ω_s ρ sin φ (race minus roller, upper sign outer race): the
/// two races push it to opposite sides [derived]. Left out: spin within the half width b of a slice
/// (ω_n b, far below the slip elsewhere) [choice].
namespace adore::contact {

/// Velocity field of a rigid body: v(X) = velocity + ω × (X - origin).
struct RigidMotion {
  Vec3 origin = Vec3::Zero();    ///< [m]
  Vec3 velocity = Vec3::Zero();  ///< of the origin [m/s]
  Vec3 omega = Vec3::Zero();     ///< [rad/s]
  [[nodiscard]] Vec3 at(const Vec3& X) const { return velocity + omega.cross(X - origin); }
};

/// u at a contact point X with unit normal n [m/s].
[[nodiscard]] inline Vec3 contact_slip(const RigidMotion& race, const RigidMotion& roller,
                                       const Vec3& X, const Vec3& normal) {
  const Vec3 u = race.at(X) - roller.at(X);
  return u - u.dot(normal) * normal;
}

struct ContactWrench {
  Vec3 force = Vec3::Zero();   ///< on the roller [N]
  Vec3 moment = Vec3::Zero();  ///< on the roller about `about` [N m]
  double heat = 0.0;           ///< dissipated power [W]
};

/// Adds one contact of load Q whose normal `into_race` points from the roller outwards.
/// @param traction_per_slip callable: |u|² -> κ/|u| [s/m], finite at 0 (laws with κ(0) ≠ 0 rounded
/// over a stated slip)
template <class TractionPerSlip>
inline void add_contact(ContactWrench& sum, double Q, const Vec3& X, const Vec3& into_race,
                        const Vec3& slip, const Vec3& about,
                        const TractionPerSlip& traction_per_slip) {
  const double u2 = slip.squaredNorm();
  const double per_slip = Q * traction_per_slip(u2);
  const Vec3 f = -Q * into_race + per_slip * slip;
  sum.force += f;
  sum.moment += (X - about).cross(f);
  sum.heat += per_slip * u2;
}

/// Moment about a point from the moment about another: M_to = M_from + (from - to) × F.
[[nodiscard]] inline Vec3 moment_about(const Vec3& moment, const Vec3& force, const Vec3& from,
                                       const Vec3& to) {
  return moment + (from - to).cross(force);
}

/// The three parts of a moment on a roller; e = unit vector of z across the axis a.
struct RollerMoments {
  double driving = 0.0;  ///< M·a, about the axis [N m]
  double tilting = 0.0;  ///< M·(a × e), raises the tilt θ [N m]
  double skewing = 0.0;  ///< M·e, raises the skew φ [N m]
};
[[nodiscard]] inline RollerMoments roller_moments(const Vec3& moment, const Vec3& axis) {
  const Vec3 e = (Vec3::UnitZ() - axis[2] * axis).normalized();
  return {moment.dot(axis), moment.dot(axis.cross(e)), moment.dot(e)};
}

}  // namespace adore::contact
