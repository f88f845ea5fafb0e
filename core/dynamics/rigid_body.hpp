#pragma once

#include "base/rotation.hpp"
#include "bearing/bearing.hpp"

/// Equations of motion of single bodies, SI and rad, frames of the design: X bearing axis, azimuth
/// θ about +X from Z.
namespace adore::dynamics {

/// Position, velocity and acceleration of a point from cylindrical coordinates (x, r, θ), base
/// axes.
struct PointMotion {
  Vec3 position, velocity, acceleration;
};
[[nodiscard]] inline PointMotion from_cylindrical(const Vec3& x_r_theta, const Vec3& rates,
                                                  const Vec3& second_rates) noexcept {
  const double r = x_r_theta[1], r_dot = rates[1], theta_dot = rates[2];
  const Vec3 e_r = radial_direction(x_r_theta[2]), e_t = circumferential_direction(x_r_theta[2]);
  const Vec3 e_x = Vec3::UnitX();
  return {x_r_theta[0] * e_x + r * e_r, rates[0] * e_x + r_dot * e_r + r * theta_dot * e_t,
          second_rates[0] * e_x + (second_rates[1] - r * theta_dot * theta_dot) * e_r +
              (r * second_rates[2] + 2.0 * r_dot * theta_dot) * e_t};
}

/// Rates in the azimuth frame (x axial, y = z × x, z radial), which turns with θ̇ e_x.
struct SpinRates {
  Vec3 omega_inertial;  ///< components of dω/dt [rad/s²]
  Vec3 omega_azimuth;   ///< rates of the components of ω: dω/dt - θ̇ e_x × ω
  Vec3 axis_azimuth;    ///< rates of the components of the body axis: (ω - θ̇ e_x) × u
};

/// Body of revolution about the unit axis u with polar and transverse moments I_p, I_t (a ball:
/// equal): ω̇·u = M·u/I_p, ω̇_⊥ = (M_⊥ - (I_p - I_t)(ω·u)(ω×u))/I_t. ω absolute, all vectors on
/// azimuth-frame axes.
[[nodiscard]] inline SpinRates axisymmetric_spin(double polar, double transverse, double theta_dot,
                                                 const Vec3& omega, const Vec3& axis,
                                                 const Vec3& moment) noexcept {
  const double spin = omega.dot(axis), along = moment.dot(axis);
  const Vec3 across = moment - along * axis;
  const Vec3 rate = (along / polar) * axis +
                    (across - (polar - transverse) * spin * omega.cross(axis)) / transverse;
  const Vec3 frame = theta_dot * Vec3::UnitX();
  return {rate, rate - frame.cross(omega), (omega - frame).cross(axis)};
}

/// Rigid body in geometric axes: its mass center may be off the geometric center, its principal
/// axes may be rotated.
struct RigidBody {
  double mass = 0.0;            ///< [kg]
  Mat3 inertia = Mat3::Zero();  ///< about the mass center, geometric axes [kg m²]
  Vec3 to_geometric_centre =
      Vec3::Zero();  ///< g, mass center -> geometric center, geometric axes [m]
};

/// I_geo = A diag(I) A^T, A = T(η, ξ, λ) turns principal into geometric components.
[[nodiscard]] inline Mat3 inertia_in_geometric_axes(const Vec3& principal,
                                                    const Vec3& frame_angles) {
  const Mat3 A = passive_matrix(frame_angles);
  return A * principal.asDiagonal() * A.transpose();
}

/// As records 6 and 7.7 give it.
[[nodiscard]] inline RigidBody rigid_body(const bearing::Inertia& given) {
  const bool straight = given.frame.isZero(0.0);
  return {given.mass,
          straight ? Mat3(given.moments.asDiagonal())
                   : inertia_in_geometric_axes(given.moments, given.frame),
          given.geometric_centre};
}

/// ω̇ = I⁻¹ (M - ω × Iω), body axes, M about the mass center.
[[nodiscard]] Vec3 euler_rate(const Mat3& inertia, const Vec3& omega, const Vec3& moment) noexcept;
[[nodiscard]] inline Vec3 euler_rate(const Vec3& principal, const Vec3& omega,
                                     const Vec3& moment) noexcept {
  return (moment - omega.cross(Vec3(principal.cwiseProduct(omega)))).cwiseQuotient(principal);
}

/// Velocity and acceleration of the geometric center: v_G + R(ω × g), a_G + R(ω̇ × g + ω × (ω × g)).
[[nodiscard]] inline Vec3 geometric_centre_velocity(const RigidBody& body, const Mat3& R,
                                                    const Vec3& v_mass_centre,
                                                    const Vec3& omega) noexcept {
  return v_mass_centre + R * omega.cross(body.to_geometric_centre);
}
[[nodiscard]] inline Vec3 geometric_centre_acceleration(const RigidBody& body, const Mat3& R,
                                                        const Vec3& a_mass_centre,
                                                        const Vec3& omega,
                                                        const Vec3& omega_rate) noexcept {
  const Vec3& g = body.to_geometric_centre;
  return a_mass_centre + R * (omega_rate.cross(g) + omega.cross(omega.cross(g)));
}

/// ½ m v² + ½ ω·Iω [J].
[[nodiscard]] inline double kinetic_energy(const RigidBody& body, const Vec3& v_mass_centre,
                                           const Vec3& omega) noexcept {
  return 0.5 * body.mass * v_mass_centre.squaredNorm() + 0.5 * omega.dot(body.inertia * omega);
}

/// Which of a race's six accelerations are prescribed (kFD, kMD; true = prescribed), base axes.
struct RaceConstraints {
  std::array<bool, 3> translation{}, rotation{};
  Vec3 acceleration = Vec3::Zero(), angular_acceleration = Vec3::Zero();  ///< the prescribed ones
};
struct RaceAccelerations {
  Vec3 acceleration, angular_acceleration;  ///< [m/s², rad/s²]
  Vec3 holding_force,
      holding_moment;  ///< reaction of the prescribed motion; 0 on free rows [N, N m]
};
/// Translation: a = F/m on free rows. Rotation: the free rows of I α + ω × Iω = M for the free α,
/// with the prescribed ones given; the other rows give the holding moment. `inertia` about the mass
/// center in base axes; forces and moments without the holding ones.
[[nodiscard]] RaceAccelerations race_accelerations(double mass, const Mat3& inertia,
                                                   const Vec3& omega, const Vec3& force,
                                                   const Vec3& moment,
                                                   const RaceConstraints& constraints) noexcept;

/// A body that is held at a point P, base axes.
struct ConstrainedBody {
  double mass = 0.0;
  Mat3 inertia = Mat3::Zero();   ///< about the mass center [kg m²]
  Vec3 arm = Vec3::Zero();       ///< c, P -> mass center [m]
  Mat3 axes = Mat3::Identity();  ///< columns: what rotations are constrained about
};
/// The same with forces and constraints at P, moments about it, and translations of P:
///   m (a + α × c + ω × (ω × c)) = F,
///   m c × a + I_P α + ω × I_P ω = M,   I_P = I + m (c² 1 - c cᵀ);
/// rows of prescribed components are replaced by those. `acceleration` is that of P.
[[nodiscard]] RaceAccelerations constrained_accelerations(
    const ConstrainedBody& body, const Vec3& omega, const Vec3& force, const Vec3& moment,
    const RaceConstraints& constraints) noexcept;

/// How the cage starts (record 9.6).
struct CageStart {
  double cage_speed = 0.0, whirl_speed = 0.0;  ///< [rad/s]
  Vec3 mass_centre, mass_centre_velocity;      ///< base axes [m, m/s]
  Quat orientation{1.0, 0.0, 0.0, 0.0};        ///< body -> base
  Vec3 omega_body;                             ///< [rad/s]
};
/// ω_c = speed_ratio × epicyclic (statics::epicyclic_speed) about X; whirl = whirl_ratio ω_c. Mass
/// center at locus + offset, moving with whirl e_x × offset. `angles` η, ξ, λ of the cage frame.
[[nodiscard]] CageStart cage_start(double epicyclic, double speed_ratio, double whirl_ratio,
                                   const Vec3& locus, const Vec3& offset,
                                   const Vec3& angles) noexcept;

}  // namespace adore::dynamics
