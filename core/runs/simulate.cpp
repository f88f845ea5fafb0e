#include "runs/simulate.hpp"

#include "runs/ready_run.hpp"
#include "runs/time_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <numbers>
#include <span>
#include <string>
#include <utility>

namespace adore::runs {
namespace fs = std::filesystem;
namespace {

/// Lengths of steps in seconds: the deck's, as far as they may stay.
integrators::StepControl step_control(const setup::RunControl& deck, const StepLimits& limits,
                                      double last_step_size, double time_scale) {
  integrators::StepControl control;
  control.initial = last_step_size > 0.0 && deck.step_initial == 0.0
                        ? last_step_size
                        : deck.step_initial * time_scale;
  control.minimum = deck.step_minimum * time_scale;
  control.maximum = deck.step_maximum * time_scale;
  if (limits.action != StepAction::Kept) {
    control.minimum = limits.minimum;
    control.maximum = limits.maximum;
    control.highest_order = limits.highest_order;
  }
  control.tolerance = deck.tolerance;
  return control;
}

RunOutcome complete_outcome(const StartPoint& start, double turned) {
  RunOutcome out;
  out.message = fmt::format(
      "the run is complete, at step {} and t = {:.6g} s; to continue, give a later end (--until, "
      "fTime, maxStps)",
      start.step, start.time);
  out.steps = start.step;
  out.time = start.time;
  out.revolutions = turned;
  return out;
}

/// How the path of a continued run may differ from that of an unbroken one; empty: not at all.
std::string continued_remark(const StartPoint& start, bool remembers,
                             const integrators::Stepper& stepper) {
  if (!start.continued) return {};
  if (!remembers)
    return fmt::format(
        "continued from step {}: {} restarts without its step history, because the method, the "
        "tolerance or the step limits changed, or the run ended with a failure",
        start.step, stepper.name());
  if (!stepper.loses().empty())
    return fmt::format(
        "continued from step {}: {} does not restore {}. The results differ from those of an "
        "uninterrupted run by errors within the tolerance",
        start.step, stepper.name(), stepper.loses());
  return {};
}

}  // namespace

RunOutcome simulate(const RunRequest& request, Prepared& prepared, const RunPlace& place,
                    const ProgressSink& progress, std::stop_token stop) {
  const auto begin = std::chrono::steady_clock::now();
  // Everything is checked before a file of an earlier run is touched.
  ReadyRun ready(request, prepared, place);
  dynamics::System& system = *ready.system;
  const integrators::Stepper& stepper = *ready.stepper;
  RunOutputs& outputs = *ready.outputs;
  StartPoint& start = ready.start;
  RunSpan& span = ready.span;
  const auto turns = [&](double time, std::span<const double> y) {
    return (system.shaft_rotation(time, y) + start.turned_before) / (2.0 * std::numbers::pi);
  };
  const long last = last_step(request, span, start);
  const double turns_per_second =
      (prepared.bearing.speed[1] - prepared.bearing.speed[0]) / (2.0 * std::numbers::pi);
  const double turned = turns(start.time, start.y);
  span.end += end_time_delay(request, start, turned, turns_per_second);
  if (start.continued && has_reached_end(span, last, start, turned, turns_per_second) &&
      start.complete)
    return complete_outcome(start, turned);
  if (!start.continued || !request.go_on) start.segment = start.step;
  const bool remembers = start.continued && !start.resume.memory.empty();
  if (const std::string text = continued_remark(start, remembers, stepper); !text.empty())
    outputs.remark(make_finding("run.continued", text));
  outputs.open(system, start);
  if (ready.thermal && !ready.thermal_restored)
    ready.thermal->start(start.time, system.snapshot(start.time, start.y).energy);

  const auto turns_now = [&] {
    // A stepper that refused to start has no state.
    return stepper.state().empty() ? turned : turns(stepper.time(), stepper.state());
  };
  ProgressMeter meter(progress, start, request.go_on, span, turns_now);
  TimeRun run({prepared, ready.system, *ready.ode, *ready.stepper, outputs,
               ready.thermal ? &*ready.thermal : nullptr, *ready.growth, meter, ready.master},
              start, span, last,
              step_control(prepared.control, ready.limits, start.step_size, ready.time_scale),
              std::move(stop));
  RunOutcome out = run.run(remembers);
  out.revolutions = turns_now();
  if (out.status == RunStatus::Done && request.until.empty() && out.time < span.end * (1.0 - 1e-9))
    out.missed_end = span.end;
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return out;
}

}  // namespace adore::runs
