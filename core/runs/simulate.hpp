#pragma once

#include "runs/output_folder.hpp"
#include "runs/prepare.hpp"
#include "runs/run.hpp"

#include <stop_token>

namespace adore::runs {

/// The run in time of a prepared deck of mode 0 to 2, into the folder.
/// @throws InputError before anything was overwritten, SolverError when no start state exists
RunOutcome simulate(const RunRequest& request, Prepared& prepared, const RunPlace& place,
                    const ProgressSink& progress, std::stop_token stop);

}  // namespace adore::runs
