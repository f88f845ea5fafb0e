#pragma once

#include "runs/run.hpp"

#include <stop_token>

/// Processor time of a whole run: set-up, motion, output and files.
namespace adore::runs {

struct RunCost {
  double seconds = 0.0;      ///< of the whole run; 0: not measured
  double pilot_turns = 0.0;  ///< revolutions that were run for it
  double pilot_time = 0.0;   ///< the same [s]
  double end_time = 0.0;     ///< of the run [s]
  bool whole = false;        ///< the pilot came to the end of the run
  std::string failure;       ///< why there is no figure
};

/// Pilot: the run itself, with all its files, in a folder that is removed, for at most `budget`
/// seconds of processor time in the motion. The rest of the run is taken to cost what the later
/// half of the pilot did per simulated time, and its end (last page, checkpoint) what that of the
/// pilot cost. Limits: what happens later (ramps, a load zone that is entered, a cage that begins
/// to strike) is not in it; processor time of one run on a busy machine scatters by 5 to 15 %.
[[nodiscard]] RunCost run_cost(const RunRequest& request, double budget, std::stop_token stop);

}  // namespace adore::runs
