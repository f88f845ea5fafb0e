#include "dynamics/ball_motion.hpp"

#include <cmath>

namespace adore::dynamics {

bool ball_motion(const ElementViews& b, const ElementActions& actions, double mass, double inertia,
                 const std::array<double*, kQuantities.size()>& rates) noexcept {
  const double per_mass = 1.0 / mass, per_inertia = 1.0 / inertia;
  double check = 0.0;
  const auto& [F_x, F_r, F_theta, M_x, M_r, M_theta] = actions;
  const auto [x, r, theta, x_dot, r_dot, theta_dot, omega_x, omega_r, omega_theta] = rates;
  for (std::size_t i = 0; i < b.n; ++i) {
    const double td = b.theta_dot[i];
    const double ax = F_x[i] * per_mass;
    const double ar = F_r[i] * per_mass + b.r[i] * td * td;
    const double at = (F_theta[i] * per_mass - 2.0 * b.r_dot[i] * td) / b.r[i];
    const double wx = M_x[i] * per_inertia;
    const double wr = M_r[i] * per_inertia + td * b.omega_theta[i];
    const double wt = M_theta[i] * per_inertia - td * b.omega_r[i];
    x[i] = b.x_dot[i];
    r[i] = b.r_dot[i];
    theta[i] = td;
    x_dot[i] = ax;
    r_dot[i] = ar;
    theta_dot[i] = at;
    omega_x[i] = wx;
    omega_r[i] = wr;
    omega_theta[i] = wt;
    check += ax + ar + at + wx + wr + wt + b.x_dot[i] + b.r_dot[i];
  }
  return std::isfinite(check);
}

}  // namespace adore::dynamics
