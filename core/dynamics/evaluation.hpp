#pragma once

#include "base/rotation.hpp"
#include "bearing/bearing.hpp"
#include "dynamics/race_contacts.hpp"
#include "dynamics/state_layout.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

/// What one evaluation of the right-hand side works on: bodies, and the forces and moments that
/// effects (effect.hpp) add to them.
namespace adore::dynamics {

/// Where each quantity of the balls stands in the state: one slice per quantity, all balls in it.
struct BallSlices {
  Slice x, r, theta, x_dot, r_dot, theta_dot, omega_x, omega_r, omega_theta;
};

/// Pose and motion of the cage at this evaluation, and what acts on it (base axes, moment about the
/// mass centre).
struct CageState {
  Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();  ///< [m, m/s]
  Mat3 to_base = Mat3::Identity();                        ///< R, body -> base
  Vec3 omega = Vec3::Zero(), omega_body = Vec3::Zero();   ///< [rad/s]
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();       ///< [N, N m]
  double load_slip = 0.0;                                 ///< Σ N u of all its contacts [W]
  /// Velocity of the body point that is at `point` of the base frame now.
  [[nodiscard]] Vec3 velocity_at(const Vec3& point) const noexcept {
    return velocity + omega.cross(point - position);
  }
  void add_force(const Vec3& f, const Vec3& point) noexcept {
    force += f;
    moment += (point - position).cross(f);
  }
};

/// Prescribed race and the sum of all contacts with it: forces on the race, moment about its
/// centre.
struct RaceState {
  RaceMotion motion;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< [N, N m]
  [[nodiscard]] Vec3 velocity_at(const Vec3& point) const noexcept {
    const Vec3 arm = point - motion.centre;
    return motion.velocity + motion.speed * motion.axis.cross(arm) + motion.tilt.cross(arm);
  }
  void add_force(const Vec3& f, const Vec3& point) noexcept {
    force += f;
    moment += (point - motion.centre).cross(f);
  }
  /// Power that the race exerts on what it touches [W].
  [[nodiscard]] double power() const noexcept {
    return -force.dot(motion.velocity) - motion.speed * moment.dot(motion.axis) -
           moment.dot(motion.tilt);
  }
};

/// Working memory of one evaluation. Sized at set-up, reused for ever.
struct Evaluation {
  explicit Evaluation(std::size_t balls);

  double t = 0.0;
  const double* y = nullptr;
  double* dydt = nullptr;

  BallArrays balls{};  ///< views into y, and into sin_theta, cos_theta
  std::vector<double> sin_theta, cos_theta;
  std::vector<double> F_x, F_r, F_theta, M_x, M_r, M_theta;
  std::array<std::vector<double>, 2> load, heat, load_slip;  ///< per race and ball
  CageState cage;
  std::array<RaceState, 2> race;

  double elastic = 0.0;  ///< of all contacts [J]
  bool valid = true;     ///< false: outside the model's validity

  void begin(double time, const double* state, double* rates) noexcept;
  [[nodiscard]] Vec3 ball_centre(std::size_t i) const noexcept {
    return {balls.x[i], -balls.r[i] * sin_theta[i], balls.r[i] * cos_theta[i]};
  }
  /// (x, r, θ) components at ball i -> base axes, and back.
  [[nodiscard]] Vec3 to_base(std::size_t i, double x, double r, double theta) const noexcept {
    return {x, -sin_theta[i] * r - cos_theta[i] * theta, cos_theta[i] * r - sin_theta[i] * theta};
  }
  [[nodiscard]] Vec3 to_cylindrical(std::size_t i, const Vec3& v) const noexcept {
    return {v[0], -sin_theta[i] * v[1] + cos_theta[i] * v[2],
            -cos_theta[i] * v[1] - sin_theta[i] * v[2]};
  }
  [[nodiscard]] Vec3 ball_velocity(std::size_t i) const noexcept {
    return to_base(i, balls.x_dot[i], balls.r_dot[i], balls.r[i] * balls.theta_dot[i]);
  }
  [[nodiscard]] Vec3 ball_omega(std::size_t i) const noexcept {
    return to_base(i, balls.omega_x[i], balls.omega_r[i], balls.omega_theta[i]);
  }
};

}  // namespace adore::dynamics
