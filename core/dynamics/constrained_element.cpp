#include "dynamics/constrained_element.hpp"

#include "dynamics/rigid_body.hpp"

namespace adore::dynamics {

ElementRates constrained_element(const Evaluation& e, std::size_t i, const ElementMass& body,
                                 const ElementConstraints& hold) noexcept {
  const ElementViews& b = e.elements;
  const double r = b.r[i], td = b.theta_dot[i];
  Mat3 axes;  // body -> (x, r, θ)
  for (int k = 0; k < 3; ++k) axes.col(k) = e.to_cylindrical(i, Vec3(e.attitude[i].col(k)));
  const ConstrainedBody at{body.mass, axes * body.inertia * axes.transpose(), axes * body.arm};
  const Vec3 omega(b.omega_x[i], b.omega_r[i], b.omega_theta[i]);
  const Vec3 with_frame(0.0, -r * td * td, 2.0 * b.r_dot[i] * td);
  const Vec3 turning(0.0, -td * omega[2], td * omega[1]);  // θ̇ e_x × ω

  RaceConstraints given;
  given.translation = {hold.x, hold.r, hold.theta};
  given.rotation = {hold.spin, hold.tilt, hold.tilt};
  given.acceleration = with_frame;
  given.angular_acceleration = turning;
  const auto& a = e.actions;
  const RaceAccelerations found = constrained_accelerations(
      at, omega, Vec3(a[0][i], a[1][i], a[2][i]), Vec3(a[3][i], a[4][i], a[5][i]), given);
  ElementRates out;
  const Vec3 rates = found.acceleration - with_frame;
  out.x_ddot = rates[0];
  out.r_ddot = rates[1];
  out.theta_ddot = rates[2] / r;
  out.omega = found.angular_acceleration - turning;
  out.force = found.holding_force;
  out.moment = found.holding_moment;
  return out;
}

}  // namespace adore::dynamics
