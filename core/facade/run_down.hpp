#pragma once

#include "facade/deck_request.hpp"

#include <vector>

/// A disc that runs down in time on the balls that carry it: the inner race of a deck is free about
/// x with the inertia of record 6.2.2, and friction takes its speed. Sliding and spin come from the
/// contacts in motion; the rolling resistance of the oil, which motion does not have (decision
/// 406), acts on the disc as a moment of its speed, from equilibria at several speeds:
///   ln M = a + b ln ω + c (ln ω)², least squares,
/// through the formulas of a user routine (ADRX1).
namespace adore::facade {

/// Friction of the equilibrium at one speed of the disc.
struct TorqueAtSpeed {
  double speed = 0.0;    ///< [rad/s]
  double rolling = 0.0;  ///< of the oil in the inlets [N m]
  double total = 0.0;    ///< [N m]
};

struct RunDown {
  double exponent = 0.0;         ///< n of -dω/dt ~ ωⁿ, least squares over equal ratios of speed
  double time = 0.0;             ///< simulated [s]
  double end_speed = 0.0;        ///< [rad/s]
  double energy_residual = 0.0;  ///< over the energy that moved
  long steps = 0;
};

/// @param moving a deck of motion with record 6.2.2, whose kMD12 is 0; it starts at the largest of
/// the speeds
/// @param at equilibria, speeds ascending, three at least; the run lasts as long as their torque
/// needs from the last to the first speed
/// @param inertia of the disc about x, as in record 6.2.2 [kg m²]
/// @throws InputError, SolverError when the run does not come to its end
[[nodiscard]] RunDown run_down(const DeckRequest& moving, const std::vector<TorqueAtSpeed>& at,
                               double inertia);

/// n of y ~ xⁿ by least squares in logarithms.
[[nodiscard]] double power_of(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace adore::facade
