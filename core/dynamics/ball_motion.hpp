#pragma once

#include "dynamics/elements.hpp"

#include <array>
#include <span>

/// Equations of motion of balls: three equal moments of inertia I, no orientation.
///   ẍ = F_x/m,  r̈ = F_r/m + r θ̇²,  θ̈ = (F_θ/m - 2 ṙ θ̇)/r
///   ω̇ on the azimuth axes, which turn with θ̇:  ω̇_x = M_x/I,  ω̇_r = M_r/I + θ̇ ω_θ,
///   ω̇_θ = M_θ/I - θ̇ ω_r
/// Source: tests/reference/dynamics_README.md, "Ball equations". SI. Limit: r > 0.
namespace adore::dynamics {

/// Rates of all balls from what acts on them, in the order of the quantities (rates_in). False: one
/// is not finite.
[[nodiscard]] bool ball_motion(const ElementViews& balls, const ElementActions& actions,
                               double mass, double inertia,
                               const std::array<double*, kQuantities.size()>& rates) noexcept;
/// The same of balls that differ. @param per_mass, per_inertia 1/m and 1/I, one per ball
[[nodiscard]] bool ball_motion(const ElementViews& balls, const ElementActions& actions,
                               std::span<const double> per_mass,
                               std::span<const double> per_inertia,
                               const std::array<double*, kQuantities.size()>& rates) noexcept;

}  // namespace adore::dynamics
