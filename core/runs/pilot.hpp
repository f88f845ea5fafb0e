#pragma once

#include "runs/prepare.hpp"
#include "runs/step_limits.hpp"

/// The first stretch of a deck's run, for the sake of what its steps cost.
namespace adore::runs {

struct PilotResult {
  double step = 0.0;              ///< mean of the later half [s]; 0: there was no step
  double seconds_per_step = 0.0;  ///< processor time without output
};

/// Takes steps of the deck's own integrator from its start, within `limits`, for at most `budget`
/// seconds of processor time, `span` seconds of motion or 20,000 steps. What stops the integrator
/// ends it, too. Limits: what happens later (a load zone that is entered, a ramp) is not in it.
[[nodiscard]] PilotResult run_pilot(const Prepared& prepared, dynamics::System& system,
                                    const StepLimits& limits, double span, double budget);

}  // namespace adore::runs
