#pragma once

#include "bearing/bearing.hpp"
#include "dynamics/system.hpp"
#include "statics/ball_statics.hpp"

#include <vector>

/// Estimates of a scene plan that need the static solution: how fast the model vibrates and what a
/// run will cost.
namespace adore::dynamics {

/// Periods of the fastest contact vibration per step of an order-5 stepper at the usual tolerance
/// of 1e-6: the rule of expected_step (0.11 to 0.23 measured on angular-contact ball bearings with
/// cage; impacts of the cage shorten the steps).
inline constexpr double kPeriodsPerStep = 0.2;
/// Right-hand sides per step of that stepper (Fehlberg 5(6)).
inline constexpr int kEvaluationsPerStep = 8;

/// How the center of one ball vibrates between its two contacts, in its axial plane: along the
/// stiffer principal direction (near the contact normals), and across it. 0: nothing pulls it back.
struct BallVibration {
  double along = 0.0, across = 0.0;  ///< angular frequency [rad/s]
  /// Damping ratios vᵀ Σ (d Q + c) n nᵀ v/(2 m ω) of both (contact/damping_law.hpp).
  double along_damping = 0.0, across_damping = 0.0;
  int stiffer_race = 0;  ///< race with the stiffer contact
};

/// One per ball of the static solution: √(λ/m) of the two eigenvalues λ of its contact stiffness
/// Σ 1.5 Q/δ n nᵀ + Q/l (I - n nᵀ), l groove center to ball center.
[[nodiscard]] std::vector<BallVibration> ball_vibrations(const ScenePlan& plan,
                                                         const bearing::Bearing& bearing,
                                                         const SystemOptions& options,
                                                         const statics::StaticSolution& statics);

/// fastest_frequency and fastest_contact of the plan alone; both stay empty when no contact is
/// loaded.
void find_fastest_vibration(ScenePlan& plan, const bearing::Bearing& bearing,
                            const statics::StaticSolution& statics);

/// Fills the estimates of `plan` and its number of quadratures:
/// fastest_frequency: the largest of ball_vibrations() [Hz]; fastest_contact names the stiffer
/// contact of that ball. Without a loaded
///   contact: of a contact at 1e-3 of the force scale (the time scale of the run);
/// expected_step = kPeriodsPerStep/f; steps per revolution of inner relative to outer race (0 for a
/// bearing at rest); seconds_per_revolution from the least of a few timed right-hand sides at
/// the start state. The system's cost ledger is not changed.
/// @throws SolverError when the start state is outside the model's validity.
void estimate(ScenePlan& plan, const bearing::Bearing& bearing,
              const statics::StaticSolution& statics, System& system);

}  // namespace adore::dynamics
