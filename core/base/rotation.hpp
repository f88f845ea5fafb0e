#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>

/// Orientation of bodies and frames. Header-only: the right-hand side calls these.
///
/// Passive matrices: T = Rz(λ) Ry(ξ) Rx(η) turns parent components into turned-frame components; Rx
/// has +sin in (2,3), Ry has -sin in (1,3), Rz has +sin in (1,2). As motions: turn by η about X,
/// then ξ about y', then λ about z''. A quaternion q = (w, x, y, z) is of unit length and turns
/// body components into parent components: v_parent = R(q) v_body, R(q) = T^T; q and -q are the
/// same attitude. Angles in rad. Only the angles are singular (at ξ = ±90°, where λ is set to 0
/// and η to the sum or difference); quaternion and matrix never are.
namespace adore {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = std::array<double, 4>;  ///< (w, x, y, z), body -> parent

/// Passive rotations about one axis, parent components -> turned-frame components.
[[nodiscard]] inline Mat3 passive_rotation_x(double angle) noexcept {
  const double c = std::cos(angle), s = std::sin(angle);
  return (Mat3() << 1, 0, 0, 0, c, s, 0, -s, c).finished();
}
[[nodiscard]] inline Mat3 passive_rotation_y(double angle) noexcept {
  const double c = std::cos(angle), s = std::sin(angle);
  return (Mat3() << c, 0, -s, 0, 1, 0, s, 0, c).finished();
}
[[nodiscard]] inline Mat3 passive_rotation_z(double angle) noexcept {
  const double c = std::cos(angle), s = std::sin(angle);
  return (Mat3() << c, s, 0, -s, c, 0, 0, 0, 1).finished();
}

/// T(η, ξ, λ) = Rz(λ) Ry(ξ) Rx(η), parent -> turned frame. `eta_xi_lambda` in this order [rad].
[[nodiscard]] inline Mat3 passive_matrix(const Vec3& eta_xi_lambda) noexcept {
  return passive_rotation_z(eta_xi_lambda[2]) * passive_rotation_y(eta_xi_lambda[1]) *
         passive_rotation_x(eta_xi_lambda[0]);
}

/// (η, ξ, λ) of a passive matrix T, in -π..π, |ξ| <= π/2: η = atan2(-T32, T33), ξ = atan2(T31, c),
/// c = cos ξ = |(T32, T33)|, and λ of the frame rotated back by η, so that the three give T to
/// rounding for any small c. Below c = 1e-12 only η ± λ is defined: λ is 0, η the whole rotation,
/// and T is reproduced to 2e-12.
[[nodiscard]] inline Vec3 angles_from_matrix(const Mat3& T) noexcept {
  constexpr double kParallel = 1e-12;
  const double cos_xi = std::hypot(T(2, 1), T(2, 2));
  const double xi = std::atan2(T(2, 0), cos_xi);
  if (cos_xi < kParallel) return {std::atan2(T(1, 2), T(1, 1)), xi, 0.0};
  const double eta = std::atan2(0.0 - T(2, 1), T(2, 2));  // no -0, or -180° would be shown
  const double c = std::cos(eta), s = std::sin(eta);
  return {eta, xi, std::atan2(c * T(0, 1) + s * T(0, 2), c * T(1, 1) + s * T(1, 2))};
}

/// (ξ, λ) of an axis, a unit vector: of the frame that was turned by ξ about Y, then by λ about z',
/// with no spin η, and has its x axis there: axis = (cos ξ cos λ, sin λ, -sin ξ cos λ). Decks and
/// listings call them misalignment about y and about z. An axis along ±Y has ξ = 0.
[[nodiscard]] inline std::array<double, 2> tilt_of_axis(const Vec3& axis) noexcept {
  const double across = std::hypot(axis[0], axis[2]);
  const double xi = across < 1e-12 ? 0.0 : std::atan2(0.0 - axis[2], axis[0]);
  return {xi, std::atan2(axis[1], across)};
}

/// Hamilton product a ⊗ b.
[[nodiscard]] inline Quat multiply(const Quat& a, const Quat& b) noexcept {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

[[nodiscard]] inline double norm(const Quat& q) noexcept {
  return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

/// Unit quaternion of the same attitude; the identity for the zero quaternion.
[[nodiscard]] inline Quat normalize_quaternion(const Quat& q) noexcept {
  const double n = norm(q);
  if (!(n > 0.0)) return {1.0, 0.0, 0.0, 0.0};
  return {q[0] / n, q[1] / n, q[2] / n, q[3] / n};
}

/// The one of q and -q with w >= 0, for output.
[[nodiscard]] inline Quat with_positive_w(const Quat& q) noexcept {
  return q[0] < 0.0 ? Quat{-q[0], -q[1], -q[2], -q[3]} : q;
}

/// R(q), body -> parent, of a unit quaternion.
[[nodiscard]] inline Mat3 rotation_matrix(const Quat& q) noexcept {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return (Mat3() << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
          2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y),
          2 * (y * z + w * x), 1 - 2 * (x * x + y * y))
      .finished();
}

/// Quaternion of a rotation by `angle` about the unit vector `axis`.
[[nodiscard]] inline Quat quaternion_about(const Vec3& axis, double angle) noexcept {
  const double s = std::sin(0.5 * angle);
  return {std::cos(0.5 * angle), s * axis[0], s * axis[1], s * axis[2]};
}

/// Attitude of the frame turned by η about X, then ξ about y', then λ about z''.
[[nodiscard]] inline Quat quaternion_from_angles(const Vec3& eta_xi_lambda) noexcept {
  return multiply(multiply(quaternion_about(Vec3::UnitX(), eta_xi_lambda[0]),
                           quaternion_about(Vec3::UnitY(), eta_xi_lambda[1])),
                  quaternion_about(Vec3::UnitZ(), eta_xi_lambda[2]));
}

/// (η, ξ, λ) as angles_from_matrix gives them, of a quaternion that need not be of unit length.
[[nodiscard]] inline Vec3 angles_from_quaternion(const Quat& q) noexcept {
  return angles_from_matrix(rotation_matrix(normalize_quaternion(q)).transpose());
}

/// q̇ = ½ q ⊗ (0, ω), ω in body components [rad/s].
[[nodiscard]] inline Quat quaternion_rate(const Quat& q, const Vec3& omega_body) noexcept {
  return multiply(q, {0.0, 0.5 * omega_body[0], 0.5 * omega_body[1], 0.5 * omega_body[2]});
}

/// ω in body components from the angles and their rates:
/// (ξ̇ sin λ + η̇ cos ξ cos λ, ξ̇ cos λ - η̇ cos ξ sin λ, λ̇ + η̇ sin ξ).
[[nodiscard]] inline Vec3 omega_from_angle_rates(const Vec3& eta_xi_lambda,
                                                 const Vec3& rates) noexcept {
  const double c2 = std::cos(eta_xi_lambda[1]), s2 = std::sin(eta_xi_lambda[1]);
  const double c3 = std::cos(eta_xi_lambda[2]), s3 = std::sin(eta_xi_lambda[2]);
  return {rates[1] * s3 + rates[0] * c2 * c3, rates[1] * c3 - rates[0] * c2 * s3,
          rates[2] + rates[0] * s2};
}

/// Azimuth unit vectors of the base frame: e_r(ψ) = (0, -sin ψ, cos ψ), e_θ = e_x × e_r = (0, -cos
/// ψ, -sin ψ).
[[nodiscard]] inline Vec3 radial_direction(double psi) noexcept {
  return {0.0, -std::sin(psi), std::cos(psi)};
}
[[nodiscard]] inline Vec3 circumferential_direction(double psi) noexcept {
  return {0.0, -std::cos(psi), -std::sin(psi)};
}

/// Azimuth of a vector about +X, measured from Z: atan2(-y, z), in (-π, π].
[[nodiscard]] inline double azimuth(const Vec3& v) noexcept { return std::atan2(-v[1], v[2]); }

}  // namespace adore
