#pragma once

#include "base/rotation.hpp"
#include "bearing/bearing.hpp"
#include "dynamics/race_contacts.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

/// What one evaluation of the right-hand side works on: bodies, and the forces and moments that
/// effects (effect.hpp) add to them.
namespace adore::dynamics {

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
  explicit Evaluation(std::size_t count);

  double t = 0.0;
  const double* y = nullptr;
  double* dydt = nullptr;

  ElementViews elements{};  ///< views into y, and into sin_theta, cos_theta
  std::vector<double> sin_theta, cos_theta;
  ElementActions actions;  ///< forces and moments on the elements, about their centres [N, N m]
  std::array<std::vector<double>, 2> load, heat, load_slip;  ///< per race and element
  CageState cage;
  std::array<RaceState, 2> race;

  double elastic = 0.0;  ///< of all contacts [J]
  bool valid = true;     ///< false: outside the model's validity

  void begin(double time, const double* state, double* rates) noexcept;
  [[nodiscard]] Vec3 element_centre(std::size_t i) const noexcept {
    return {elements.x[i], -elements.r[i] * sin_theta[i], elements.r[i] * cos_theta[i]};
  }
  /// Adds to what acts on element i, (x, r, θ) components.
  void add_force(std::size_t i, const Vec3& f) noexcept {
    for (std::size_t k = 0; k < 3; ++k) actions[k][i] += f[static_cast<Eigen::Index>(k)];
  }
  void add_moment(std::size_t i, const Vec3& m) noexcept {
    for (std::size_t k = 0; k < 3; ++k) actions[3 + k][i] += m[static_cast<Eigen::Index>(k)];
  }
  /// (x, r, θ) components at element i -> base axes, and back.
  [[nodiscard]] Vec3 to_base(std::size_t i, double x, double r, double theta) const noexcept {
    return {x, -sin_theta[i] * r - cos_theta[i] * theta, cos_theta[i] * r - sin_theta[i] * theta};
  }
  [[nodiscard]] Vec3 to_base(std::size_t i, const Vec3& v) const noexcept {
    return to_base(i, v[0], v[1], v[2]);
  }
  [[nodiscard]] Vec3 to_cylindrical(std::size_t i, const Vec3& v) const noexcept {
    return {v[0], -sin_theta[i] * v[1] + cos_theta[i] * v[2],
            -cos_theta[i] * v[1] - sin_theta[i] * v[2]};
  }
  [[nodiscard]] Vec3 element_velocity(std::size_t i) const noexcept {
    return to_base(i, elements.x_dot[i], elements.r_dot[i], elements.r[i] * elements.theta_dot[i]);
  }
  [[nodiscard]] Vec3 element_omega(std::size_t i) const noexcept {
    return to_base(i, elements.omega_x[i], elements.omega_r[i], elements.omega_theta[i]);
  }
};

}  // namespace adore::dynamics
