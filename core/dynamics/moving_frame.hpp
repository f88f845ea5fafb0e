#pragma once

#include "dynamics/rigid_body.hpp"

/// Base frame that turns about a fixed axis parallel to X (record 9.5): motion relative to it, SI
/// and rad, base axes. Every position, velocity and ω is relative to the base frame unless said
/// otherwise.
namespace adore::dynamics {

struct MovingFrame {
  double speed = 0.0;         ///< Ω about the fixed axis, along +X [rad/s]
  double orbit_radius = 0.0;  ///< R_o, fixed axis -> base origin [m]
  double orbit_angle = 0.0;  ///< φ0, azimuth of the base origin seen from the fixed axis, constant
                             ///< in the base frame [rad]

  /// -m Ω × (Ω × (R_o e_r(φ0) + ρ)) [N]; its potential is -½ m Ω² ρ·(2 R_o e_r + ρ)
  /// across X, zero in the base origin.
  [[nodiscard]] Vec3 transport_force(double mass, const Vec3& position) const noexcept {
    const Vec3 from_axis = orbit_radius * radial_direction(orbit_angle) + position;
    return mass * speed * speed * Vec3(0.0, from_axis[1], from_axis[2]);
  }
  /// -2 m Ω × ρ̇ [N]; does no work.
  [[nodiscard]] Vec3 coriolis_force(double mass, const Vec3& velocity) const noexcept {
    return -2.0 * mass * speed * Vec3::UnitX().cross(velocity);
  }
  [[nodiscard]] Vec3 inertial_force(double mass, const Vec3& position,
                                    const Vec3& velocity) const noexcept {
    return transport_force(mass, position) + coriolis_force(mass, velocity);
  }
};

/// Rates relative to the base frame of a body of revolution about the unit axis u (polar,
/// transverse moments of inertia): Euler's equations for ω + Ω, then (dω/dt)_rel = ω̇_abs - Ω × ω; u̇
/// = ω × u.
struct RelativeSpinRates {
  Vec3 omega, axis;  ///< [rad/s², 1/s]
};
[[nodiscard]] inline RelativeSpinRates relative_spin(const MovingFrame& frame, double polar,
                                                     double transverse, const Vec3& omega,
                                                     const Vec3& axis,
                                                     const Vec3& moment) noexcept {
  const Vec3 Omega = frame.speed * Vec3::UnitX();
  const Vec3 rate =
      axisymmetric_spin(polar, transverse, 0.0, omega + Omega, axis, moment).omega_inertial;
  return {rate - Omega.cross(omega), omega.cross(axis)};
}

}  // namespace adore::dynamics
