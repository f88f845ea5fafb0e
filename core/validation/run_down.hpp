#pragma once

#include "runs/deck_request.hpp"

#include <vector>

/// A disc that runs down in time on the balls that carry it: the inner race of a deck is free about
/// x with the inertia of record 6.2.2, and friction takes its speed. All of it comes from the
/// motion: sliding and spin of the contacts, and the rolling resistance of the oil in their inlets
/// (dynamics/effects/rolling_resistance.cpp).
namespace adore::validation {

/// Friction of the equilibrium at one speed of the disc.
struct TorqueAtSpeed {
  double speed = 0.0;  ///< [rad/s]
  double total = 0.0;  ///< [N m]
};

struct RunDown {
  double exponent = 0.0;         ///< n of -dω/dt ~ ωⁿ, least squares over equal ratios of speed
  double time = 0.0;             ///< simulated [s]
  double end_speed = 0.0;        ///< [rad/s]
  double energy_residual = 0.0;  ///< over the energy that moved
  double rolling = 0.0;          ///< share of rolling resistance in the heat of the run
  long steps = 0;
};

/// @param moving a deck of motion with record 6.2.2, whose kMD12 is 0; it starts at the largest of
/// the speeds
/// @param at equilibria, speeds ascending, two at least; the run lasts as long as their torque
/// needs from the last to the first speed
/// @param inertia of the disc about x, as in record 6.2.2 [kg m²]
/// @throws InputError, SolverError when the run does not come to its end
[[nodiscard]] RunDown run_down(const runs::DeckRequest& moving,
                               const std::vector<TorqueAtSpeed>& at, double inertia);

/// n of y ~ xⁿ by least squares in logarithms.
[[nodiscard]] double fit_power_exponent(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace adore::validation
