#pragma once

#include "dynamics/system.hpp"
#include "integrators/stepper.hpp"
#include "setup/run_control.hpp"

#include <span>
#include <string>

/// Steps that tell nothing, and why one could not be made.
namespace adore::runs {

/// Ends a run whose steps are all too long for its tolerance and may not be shorter: what it
/// computes has no known error, and waiting for its end tells nobody.
class StepWatch {
 public:
  /// @param time_scale unit of the deck's step sizes [s]
  StepWatch(const setup::RunControl& control, double time_scale)
      : control_(control),
        constant_(control.step_minimum == control.step_maximum),
        minimum_(control.step_minimum * time_scale) {}
  /// @throws SolverError
  void look(const integrators::Stepper& stepper);

 private:
  const setup::RunControl& control_;
  bool constant_;
  double minimum_;             ///< [s]
  long kept_ = 0, since_ = 0;  ///< steps that kept the tolerance; how many there were at the last
};

/// Cause of invalid states ahead: the sentence of the first such state in the direction of the
/// rates point, up to some steps of h [s] from (t, y). Empty: none found.
[[nodiscard]] std::string invalid_beyond(dynamics::System& system, double t,
                                         std::span<const double> y, double h);

}  // namespace adore::runs
