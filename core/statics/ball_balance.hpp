#pragma once

#include "statics/ball_position.hpp"
#include "statics/contact_laws.hpp"
#include "statics/friction_balance.hpp"
#include "tribology/bearing_drag.hpp"

#include <array>
#include <optional>

/// Balance of moments and of the force along the orbit of one ball (ball_friction.hpp). SI.
namespace adore::statics {

/// Residual over the larger contact load: end of the search (with few nodes: kFewNodesTolerance),
/// and limit of an accepted balance.
inline constexpr double kBalanceTolerance = 1e-11, kFewNodesTolerance = 1e-5,
                        kAcceptedResidual = 1e-5;
inline constexpr double kMaxSpeedStep = 0.03;     ///< over the spin
inline constexpr double kSpeedDifference = 1e-7;  ///< likewise

using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;
/// Loads, contact angles and radius that the traction forces of a ball depend on, in the order of
/// LinearizedTractions.
using Places = Eigen::Matrix<double, static_cast<int>(LinearizedTractions::kPlaces), 1>;
[[nodiscard]] Places contact_variables_of(const StaticBall& ball);

[[nodiscard]] inline bool is_loaded(const StaticBall& ball) {
  return ball.Q[0] > 0.0 && ball.Q[1] > 0.0;
}

/// Derivatives of residual G and results t = (f_o, f_i, ω_m) of a ball over its speeds v, in units
/// of the spin, and its places s. Those over s are 0 of a ball with two contacts at a
/// race.
struct BallLinearization {
  Mat4 G_v = Mat4::Identity();
  Eigen::Matrix<double, 3, 4> t_v = Eigen::Matrix<double, 3, 4>::Zero();
  Eigen::Matrix<double, 4, 5> G_s = Eigen::Matrix<double, 4, 5>::Zero();
  Eigen::Matrix<double, 3, 5> t_s = Eigen::Matrix<double, 3, 5>::Zero();
};

/// One ball at its place.
class BallBalance {
 public:
  BallBalance(const bearing::Bearing& bearing, const ContactLaws& laws,
              const tribology::BearingDrag* drag, double frame, const StaticBall& ball);

  /// The cage has it orbit at this speed [rad/s].
  void set_cage_orbital_speed(double orbit) { cage_orbital_speed_ = orbit; }
  [[nodiscard]] bool has_cage_orbital_speed() const { return cage_orbital_speed_.has_value(); }
  /// Of the cage along the orbit, at the last evaluation [N].
  [[nodiscard]] double cage_force() const { return cage_force_; }
  /// Nodes of the ellipses, kept as a reference.
  void use(const tribology::EllipseRule& rule) { quadrature_rule_ = &rule; }

  /// From the given motion; false: no balance was found, and the motion is of no use.
  /// @param rule kept for linearize(), as a reference
  bool find(BallMotion& motion, const tribology::EllipseRule& rule, double balanced);
  /// Of a balance G(v, s) = 0 that stays balanced while the contacts move: dt/ds = t_s - t_v G_v⁻¹
  /// G_s.
  [[nodiscard]] Eigen::Matrix<double, 3, 5> slopes(const BallInGrooves& seat,
                                                   const StaticBall& ball,
                                                   const BallMotion& motion);
  [[nodiscard]] BallLinearization linearize(const BallInGrooves& seat, const StaticBall& ball,
                                            const BallMotion& motion);

  [[nodiscard]] double spin() const { return spin_; }  ///< unit of speeds [rad/s]
  /// Speeds (ω, ω_m) in units of the spin, and back.
  [[nodiscard]] Vec4 speeds(const BallMotion& motion) const;
  void set_speeds(const Vec4& v, BallMotion& motion) const;
  /// M_x, M_r, M_θ over load and radius; F_θ over the load, as what it does to the orbit.
  Vec4 residual(const Vec4& v, BallMotion& motion) const;
  /// Residual of a change dv/dφ of the speeds, φ the angle that spins: J spin²/(load R) [-]. The
  /// same of moments and of the orbit.
  [[nodiscard]] double inertia() const;
  /// Friction moment of both races at this slip along the major axes, over load and radius [-].
  [[nodiscard]] double friction_moment_at(double slip) const;

 private:
  void set_position(const StaticBall& ball);
  Vec4 at(const Vec4& v, Eigen::Vector3d& result) const;

  const bearing::Bearing& bearing_;
  const ContactLaws& laws_;
  const tribology::EllipseRule* quadrature_rule_ = nullptr;
  const tribology::BearingDrag* drag_;
  double frame_, r_ = 0.0, radius_ = 0.0, load_ = 0.0, spin_ = 0.0;
  std::optional<double> cage_orbital_speed_;
  mutable double cage_force_ = 0.0;
  std::array<BallContact, 2> contact_;
  std::array<std::optional<BallContact>, 2> second_;  ///< with the other half of a split race
  std::array<Eigen::Vector2d, 2> normal_;             ///< of their resultant on (e_x, e_r)
};

}  // namespace adore::statics
