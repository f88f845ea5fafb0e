#pragma once

#include "runs/run.hpp"

#include <filesystem>
#include <stop_token>

/// `--set var=a:b:n`: n runs with evenly spaced values, one folder each, and a table SWEEP.csv.
namespace adore::studies {

/// Does one of the sets hold a range a:b:n?
[[nodiscard]] bool is_sweep(const runs::RunRequest& request);

struct SweepOutcome {
  std::filesystem::path table;    ///< SWEEP.csv: one line per run
  int exit_code = 0;              ///< the worst of the runs
  long failed = 0;                ///< runs without a result; a continued sweep repeats them
  std::vector<Finding> warnings;  ///< of all runs, those that differ only in numbers once
};

/// Runs are independent and spread over `threads` (0: all cores); folders "<var>-<k>" below the
/// output folder. The table is written as the runs end; SWEEP.json (sweep_mark.hpp) identifies the
/// sweep and stores whether it is complete. With RunRequest::go_on only missing
/// runs are computed: interrupted, not started, or failed ones.
/// @throws InputError for a malformed range, or more than one of them; ResultsExist as run().
SweepOutcome run_sweep(const runs::RunRequest& request, int threads,
                       const runs::ProgressSink& progress = {}, std::stop_token stop = {});

}  // namespace adore::studies
