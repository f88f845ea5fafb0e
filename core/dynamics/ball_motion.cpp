#include "dynamics/ball_motion.hpp"

#include <bit>
#include <cstdint>

#ifndef ADORE_CLONES  // core/CMakeLists.txt
#define ADORE_CLONES
#endif

namespace adore::dynamics {

namespace {

/// @param per_mass_of, per_inertia_of called with the number of the ball
template <class PerMass, class PerInertia>
[[gnu::always_inline]] inline bool motion(
    const ElementViews& b, const ElementActions& actions, const PerMass& per_mass_of,
    const PerInertia& per_inertia_of,
    const std::array<double*, kQuantities.size()>& rates) noexcept {
  std::uint64_t unlike = 0;  // x - x is +0 of every finite number, and of no other
  const auto& [F_x, F_r, F_theta, M_x, M_r, M_theta] = actions;
  const auto [x, r, theta, x_dot, r_dot, theta_dot, omega_x, omega_r, omega_theta] = rates;
#pragma GCC ivdep  // no array of rates is one of the others
  for (std::size_t i = 0; i < b.n; ++i) {
    const double per_mass = per_mass_of(i), per_inertia = per_inertia_of(i);
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
    const double sum = ax + ar + at + wx + wr + wt + b.x_dot[i] + b.r_dot[i];
    unlike |= std::bit_cast<std::uint64_t>(sum - sum);
  }
  return unlike == 0;
}

}  // namespace

ADORE_CLONES
bool ball_motion(const ElementViews& b, const ElementActions& actions, double mass, double inertia,
                 const std::array<double*, kQuantities.size()>& rates) noexcept {
  const double per_mass = 1.0 / mass, per_inertia = 1.0 / inertia;
  return motion(
      b, actions, [=](std::size_t) { return per_mass; }, [=](std::size_t) { return per_inertia; },
      rates);
}

ADORE_CLONES
bool ball_motion(const ElementViews& b, const ElementActions& actions,
                 std::span<const double> per_mass, std::span<const double> per_inertia,
                 const std::array<double*, kQuantities.size()>& rates) noexcept {
  return motion(
      b, actions, [=](std::size_t i) { return per_mass[i]; },
      [=](std::size_t i) { return per_inertia[i]; }, rates);
}

}  // namespace adore::dynamics
