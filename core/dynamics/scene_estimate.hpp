#pragma once

#include "bearing/bearing.hpp"
#include "dynamics/scene_plan.hpp"
#include "dynamics/system.hpp"
#include "statics/ball_statics.hpp"

/// Estimates of a scene plan that need the static solution: how fast the model vibrates and what a
/// run will cost.
namespace adore::dynamics {

/// Periods of the fastest contact vibration per step of an order-5 stepper at the usual tolerance
/// of 1e-6: the rule of expected_step (0.11 to 0.23 measured on angular-contact ball bearings with
/// cage; impacts of the cage shorten the steps).
inline constexpr double kPeriodsPerStep = 0.2;
/// Right-hand sides per step of that stepper (Fehlberg 5(6)).
inline constexpr int kEvaluationsPerStep = 8;

/// Fills the estimates of `plan` and its number of quadratures:
/// fastest_frequency: largest f = √(λ/m)/2π over the balls, λ the larger eigenvalue of the contact
/// stiffness of a ball
///   between its two contacts in its axial plane, Σ 1.5 Q/δ n nᵀ + Q/l (I - n nᵀ), l groove centre
///   to ball centre; fastest_contact names the stiffer contact of that ball. Without a loaded
///   contact: of a contact at 1e-3 of the force scale (the time scale of the run);
/// expected_step = kPeriodsPerStep/f; steps per revolution of inner relative to outer race (0 for a
/// bearing that stands); seconds_per_revolution from the least of a few timed right-hand sides at
/// the start state. The system's cost ledger is left as it was.
/// @throws SolverError when the start state is outside the model's validity.
void estimate(ScenePlan& plan, const bearing::Bearing& bearing,
              const statics::StaticSolution& statics, System& system);

}  // namespace adore::dynamics
