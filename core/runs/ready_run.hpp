#pragma once

#include "integrators/stepper.hpp"
#include "runs/ring_growth.hpp"
#include "runs/run_outputs.hpp"
#include "runs/run_span.hpp"
#include "runs/step_limits.hpp"
#include "runs/system_ode.hpp"
#include "runs/thermal_run.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace adore::runs {

/// A run in time up to its first step: everything found and checked, nothing written.
struct ReadyRun {
  /// A change becomes a remark on the deck and part of its plan.
  /// @throws InputError, SolverError when no start state exists
  ReadyRun(const RunRequest& request, Prepared& prepared, const RunPlace& place);
  ReadyRun(const ReadyRun&) = delete;
  ReadyRun& operator=(const ReadyRun&) = delete;

  std::filesystem::path master;
  std::optional<ThermalRun> thermal;
  std::optional<RingGrowth> growth;
  bool thermal_restored = false;           ///< with the temperatures of an earlier run
  std::optional<dynamics::System> system;  ///< thermal steps put another one into its place
  std::optional<SystemOde> ode;
  std::unique_ptr<integrators::Stepper> stepper;
  double time_scale = 0.0;  ///< that the deck's times are multiples of [s]
  RunSpan span;
  StepLimits limits;
  std::optional<RunOutputs> outputs;
  StartPoint start;
};

}  // namespace adore::runs
