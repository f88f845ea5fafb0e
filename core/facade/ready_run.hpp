#pragma once

#include "facade/ring_growth.hpp"
#include "facade/run_outputs.hpp"
#include "facade/run_span.hpp"
#include "facade/step_limits.hpp"
#include "facade/system_ode.hpp"
#include "facade/thermal_run.hpp"
#include "integrators/stepper.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace adore::facade {

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
  bool thermal_goes_on = false;            ///< with the temperatures of an earlier run
  std::optional<dynamics::System> system;  ///< thermal steps put another one into its place
  std::optional<SystemOde> ode;
  std::unique_ptr<integrators::Stepper> stepper;
  double time_scale = 0.0;  ///< that the deck's times are multiples of [s]
  RunSpan span;
  StepLimits limits;
  std::optional<RunOutputs> outputs;
  StartPoint start;
};

}  // namespace adore::facade
