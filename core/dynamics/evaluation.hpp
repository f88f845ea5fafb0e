#pragma once

#include "bearing/bearing.hpp"
#include "dynamics/bodies.hpp"
#include "dynamics/race_load.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

/// Working data of one evaluation of the right-hand side: bodies, and the forces and moments that
/// effects (effect.hpp) add to them.
namespace adore::dynamics {

/// Working memory of one evaluation. Sized at set-up, reused for ever.
struct Evaluation {
  explicit Evaluation(std::size_t count);

  double t = 0.0;
  const double* y = nullptr;
  double* dydt = nullptr;

  ElementViews elements{};  ///< views into y, and into sin_theta, cos_theta
  std::vector<double> sin_theta, cos_theta;
  std::vector<Mat3> attitude;  ///< of elements, body -> base, where it is integrated; else empty
  ElementActions actions;      ///< forces and moments on the elements, about their centers [N, N m]
  std::array<std::vector<double>, 2> load, heat, load_slip;  ///< per race and element
  std::vector<BodyState> segments;  ///< of the cage; a cage of one piece is one, none: no cage
  std::array<RaceBody, 2> race;
  std::vector<BodyState> others;  ///< of effects that add bodies

  RaceLoad balance;      ///< of an inner race in force balance
  double elastic = 0.0;  ///< of all contacts [J]
  bool valid = true;     ///< false: outside the model's validity

  void begin(double time, const double* state, double* rates) noexcept;
  /// Nothing acts on any body.
  void clear_actions() noexcept;
  [[nodiscard]] BodyState& body(const BodyId& id) noexcept {
    const auto k = static_cast<std::size_t>(id.index);
    switch (id.kind) {
      case BodyId::Kind::Segment:
        return segments[k];
      case BodyId::Kind::Race:
        return race[k];
      case BodyId::Kind::Other:
        break;
    }
    return others[k];
  }
  [[nodiscard]] const BodyState& body(const BodyId& id) const noexcept {
    return const_cast<Evaluation*>(this)->body(id);
  }
  /// Calls visit(body) for every body that is integrated.
  template <class Visit>
  void for_integrated_bodies(const Visit& visit) {
    for (BodyState& body : segments) visit(body);
    for (BodyState& body : race)
      if (body.moves == Moves::Integrated) visit(body);
    for (BodyState& body : others)
      if (body.moves == Moves::Integrated) visit(body);
  }
  template <class Visit>
  void for_integrated_bodies(const Visit& visit) const {
    const_cast<Evaluation*>(this)->for_integrated_bodies(
        [&visit](const BodyState& body) { visit(body); });
  }
  [[nodiscard]] Vec3 element_centre(std::size_t i) const noexcept {
    return {elements.x[i], -elements.r[i] * sin_theta[i], elements.r[i] * cos_theta[i]};
  }
  /// Adds to what acts on element i, (x, r, θ) components.
  void add_force(std::size_t i, const Vec3& f) noexcept {
    actions[0][i] += f[0];
    actions[1][i] += f[1];
    actions[2][i] += f[2];
  }
  void add_moment(std::size_t i, const Vec3& m) noexcept {
    actions[3][i] += m[0];
    actions[4][i] += m[1];
    actions[5][i] += m[2];
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
