#pragma once

#include "dynamics/system.hpp"
#include "integrators/stepper.hpp"
#include "setup/run_control.hpp"

#include <span>
#include <string>

/// Steps with an unknown error, and the cause of a step that failed.
namespace adore::runs {

/// Ends a run whose steps all miss its tolerance although they have the smallest allowed size: its
/// results have an unknown error.
class StepErrorMonitor {
 public:
  /// @param time_scale unit of the deck's step sizes [s]
  StepErrorMonitor(const setup::RunControl& control, double time_scale)
      : control_(control),
        is_step_constant_(control.step_minimum == control.step_maximum),
        minimum_step_(control.step_minimum * time_scale) {}
  /// @throws SolverError
  void check(const integrators::Stepper& stepper);

 private:
  const setup::RunControl& control_;
  bool is_step_constant_;
  double minimum_step_;              ///< [s]
  long steps_within_tolerance_ = 0;  ///< steps that kept the tolerance
  long last_good_step_ = 0;          ///< number of steps at the last of them
};

/// Cause of invalid states ahead: the message of the first such state in the direction of the
/// rates, up to 1000 steps of h [s] from (t, y). Empty: none found.
[[nodiscard]] std::string invalid_state_message(dynamics::System& system, double t,
                                                std::span<const double> y, double h);

}  // namespace adore::runs
