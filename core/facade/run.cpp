#include "facade/run.hpp"

#include "deck/unit_text.hpp"
#include "facade/run_outputs.hpp"
#include "facade/system_ode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::facade {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// The request's overrides of the deck's run control.
void apply_overrides(const RunRequest& request, Prepared& prepared) {
  if (!request.integrator.empty()) {
    try {
      prepared.control.integrator = integrators::make_stepper(request.integrator)->name();
    } catch (const std::invalid_argument& error) {
      throw InputError(error.what());
    }
  }
  if (request.tolerance) {
    if (!(*request.tolerance > 0.0 && *request.tolerance < 1.0))
      throw InputError(
          fmt::format("--tol {} is no local error limit; give a number between 0 and 1, e.g. 1e-6",
                      *request.tolerance));
    prepared.control.tolerance = *request.tolerance;
  }
}

/// Steps and end time of a run in seconds.
struct Span {
  double end = 0.0;    ///< [s]
  long max_steps = 0;  ///< counted steps
};

Span run_span(const RunRequest& request, const Prepared& prepared, double time_scale) {
  const double shaft_speed = prepared.bearing.speed[1] - prepared.bearing.speed[0];
  if (!request.until.empty())
    return {parse_until(request.until, shaft_speed, time_scale), std::numeric_limits<long>::max()};
  return {prepared.control.end_time * time_scale, prepared.control.max_steps};
}

/// Reports progress at most about 20 times a second.
class ProgressMeter {
 public:
  ProgressMeter(const ProgressSink& sink, double start, const Span& span, double shaft_speed)
      : sink_(sink),
        start_(start),
        span_(span),
        turns_per_second_(shaft_speed / (2.0 * std::numbers::pi)) {}

  void update(double time, long step, long first_step) {
    if (sink_ && seconds_since(begin_) - sent_ >= 0.05) send(time, step, first_step, false);
  }
  /// The last report; `done`: the run came to its end.
  void finish(double time, long step, long first_step, bool done) {
    if (sink_) send(time, step, first_step, done);
  }

 private:
  void send(double time, long step, long first_step, bool done) {
    const double elapsed = seconds_since(begin_);
    sent_ = elapsed;
    Progress p;
    const double by_time = span_.end > start_ ? (time - start_) / (span_.end - start_) : 1.0;
    const double by_steps =
        static_cast<double>(step - first_step) / static_cast<double>(std::max(1L, span_.max_steps));
    p.fraction = done ? 1.0 : std::clamp(std::max(by_time, by_steps), 0.0, 0.9999);
    p.revolutions = turns_per_second_ * time;
    p.time = time;
    p.end_time = span_.end;
    p.step = step;
    p.elapsed = elapsed;
    p.remaining = p.fraction > 0.0 ? elapsed * (1.0 - p.fraction) / p.fraction : 0.0;
    p.speed_up = elapsed > 0.0 ? (time - start_) / elapsed : 0.0;
    sink_(p);
  }

  const ProgressSink& sink_;
  double start_;
  Span span_;
  double turns_per_second_;
  Clock::time_point begin_ = Clock::now();
  double sent_ = -1.0;
};

RunOutcome run_quasi_static(const Prepared& prepared, const fs::path& folder) {
  RunOutcome out;
  RunOutputs outputs(prepared, folder);
  out.results = outputs.write_quasi_static();
  out.files = outputs.files();
  out.summary = outputs.summary();
  return out;
}

/// The deck's integrator. @throws InputError when it cannot do what the deck asks of it.
std::unique_ptr<integrators::Stepper> make_checked_stepper(const build::RunControl& control,
                                                           const SystemOde& ode, bool held) {
  auto stepper = integrators::make_stepper(control.integrator);
  if (stepper->name() == "arkode-imex" && !ode.has_stiff_part())
    throw InputError(
        "arkode-imex takes the normal contacts of elements and races implicitly, and this deck has "
        "none; use arkode-dirk (intMet 32) or arkode-erk (intMet 31)");
  if (stepper->name() == "arkode-imex" && held)
    throw InputError(
        "arkode-imex splits the motion of freely moving elements, and qFac on record 2.1 holds "
        "some "
        "in force balance; set qFac to 0, or use arkode-dirk (intMet 32) or arkode-erk (intMet "
        "31)");
  if (control.step_minimum == control.step_maximum && !stepper->holds_constant_step())
    throw InputError(
        fmt::format("record 2.1 asks for a constant step (stpMin = stpMax), which {} cannot hold; "
                    "use intMet 1-7, 11-18 or 31-32, or let stpMin be smaller than stpMax",
                    stepper->name()));
  return stepper;
}

void add_counters(integrators::Counters& sum, const integrators::Counters& c) {
  sum.steps += c.steps;
  sum.rejected += c.rejected;
  sum.evaluations += c.evaluations;
  sum.at_minimum += c.at_minimum;
  sum.restarts += c.restarts;
  sum.jacobians += c.jacobians;
  sum.nonlinear_iterations += c.nonlinear_iterations;
}

RunOutcome run_dynamic(const RunRequest& request, const Prepared& prepared, const fs::path& folder,
                       const ProgressSink& progress, std::stop_token stop) {
  const auto begin = Clock::now();
  dynamics::System system = make_system(prepared);
  SystemOde ode(system);
  const auto stepper =
      make_checked_stepper(prepared.control, ode, prepared.plan.light_load_ratio > 0.0);
  // Everything that the deck alone decides is checked before a file of an earlier run is touched.
  (void)run_span(request, prepared, system.scales().time);
  RunOutputs outputs(prepared, folder);
  StartPoint start =
      outputs.begin(system, prepared.control.start);  // y, t, step; appends when it continues
  const double scale = system.scales().time;
  const Span span = run_span(request, prepared, scale);

  RunOutcome out;
  integrators::StepControl control;
  control.initial = start.step_size > 0.0 && prepared.control.step_initial == 0.0
                        ? start.step_size
                        : prepared.control.step_initial * scale;
  control.minimum = prepared.control.step_minimum * scale;
  control.maximum = prepared.control.step_maximum * scale;
  control.tolerance = prepared.control.tolerance;

  const int stepper_cost = system.cost().add_entry("stepper");
  const int output_cost = system.cost().add_entry("output");
  ProgressMeter meter(progress, start.time, span,
                      prepared.bearing.speed[1] - prepared.bearing.speed[0]);
  long step = start.step;
  double h = start.step_size;
  double output_seconds = 0.0;
  auto output = [&](auto&& action) {
    const auto at = Clock::now();
    action();
    system.cost().add(output_cost, Clock::now() - at);
    output_seconds += seconds_since(at);
  };

  integrators::Counters counters;  // of the stepper before its last start
  long held_changes = 0;
  /// Light-load balance: after a finished step elements may be held or released; the stepper then
  /// starts anew from the changed state with its last step size.
  auto update_held = [&] {
    std::vector<double> y(stepper->state().begin(), stepper->state().end());
    if (!system.between_steps(stepper->time(), y)) return;
    ++held_changes;
    add_counters(counters, stepper->counters());
    ++counters.restarts;
    integrators::StepControl again = control;
    again.initial = h;
    stepper->start(ode, stepper->time(), y, again);
  };
  const bool may_hold = prepared.plan.has(dynamics::Effect::LightLoadBalance);

  const auto loop_begin = Clock::now();
  try {
    if (!start.continued && system.between_steps(start.time, start.y)) ++held_changes;
    stepper->start(ode, start.time, start.y, control);
    if (!start.continued)
      output([&] {
        outputs.store(system, {0, start.time, 0.0, start.y}, true);
        outputs.write_first_checkpoint(system);
      });
    const long last_step = span.max_steps > std::numeric_limits<long>::max() - step
                               ? span.max_steps
                               : step + span.max_steps;
    while (stepper->time() < span.end && step < last_step) {
      if (stop.stop_requested()) {
        out.status = RunStatus::Interrupted;
        break;
      }
      for (int k = 0; k < prepared.control.substeps && stepper->time() < span.end; ++k)
        h = stepper->step(span.end).h;
      ++step;
      system.check_state(stepper->time(), stepper->state().data());
      if (may_hold) update_held();
      if (outputs.wants(step))
        output([&] { outputs.store(system, {step, stepper->time(), h, stepper->state()}, false); });
      output([&] {
        outputs.checkpoint_if_due(system, {step, stepper->time(), h, stepper->state()});
      });
      meter.update(stepper->time(), step, start.step);
    }
  } catch (const integrators::StepFailure& failure) {
    out.status = RunStatus::Failed;
    out.message = failure.what();
  } catch (const SolverError& failure) {
    out.status = RunStatus::Failed;
    out.message = deck::message_in_units(failure.what(), prepared.input.deck.units());
  }
  const RunPoint end{step, stepper->time(), h, stepper->state()};
  if (out.status != RunStatus::Failed)
    meter.finish(end.time, step, start.step, out.status == RunStatus::Done);

  // A failed state may be meaningless: the files end with the last stored step, and FINAL keeps the
  // last checkpoint.
  if (out.status != RunStatus::Failed) output([&] { outputs.store(system, end, true); });
  // What the loop spent outside the right-hand side and the output belongs to the stepper.
  const double loop_seconds = seconds_since(loop_begin);
  double rhs_seconds = 0.0;
  for (const auto& row : system.cost().rows())
    if (row.name != "stepper" && row.name != "output") rhs_seconds += row.seconds;
  const double rest = std::max(0.0, loop_seconds - rhs_seconds - output_seconds);
  system.cost().add(stepper_cost, std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(rest)));

  RunEnd summary;
  summary.status = out.status;
  summary.message = out.message;
  summary.point = end;
  add_counters(counters, stepper->counters());
  summary.counters = counters;
  summary.held_changes = held_changes;
  summary.loop_seconds = loop_seconds;
  outputs.finish(system, summary);

  out.files = outputs.files();
  out.summary = outputs.summary();
  out.steps = step;
  out.time = end.time;
  out.revolutions =
      ((prepared.bearing.speed[1] - prepared.bearing.speed[0]) * end.time + start.turned_before) /
      (2.0 * std::numbers::pi);
  out.warnings = outputs.remarks();
  out.seconds = seconds_since(begin);
  out.energy_residual = outputs.energy_residual();
  out.energy_scale = outputs.energy_scale();
  return out;
}

}  // namespace

fs::path output_folder(const RunRequest& request, const fs::path& deck) {
  const fs::path folder = request.out ? *request.out : deck.parent_path();
  if (folder.empty()) return ".";
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw InputError(
        fmt::format("cannot make the output folder {}: {}; name another one with --out",
                    folder.string(), error ? error.message() : "a file of that name exists"));
  return folder;
}

double parse_until(const std::string& text, double shaft_speed, double time_scale) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (error != std::errc() || !(value > 0.0) || !std::isfinite(value) ||
      (unit != "" && unit != "rev" && unit != "s"))
    throw InputError(
        fmt::format("--until {}: give turns of the shaft (5rev), seconds (0.02s) or a "
                    "dimensionless time (1000), above 0",
                    text));
  if (unit == "s") return value;
  if (unit == "") return value * time_scale;
  if (shaft_speed == 0.0)
    throw InputError(
        fmt::format("--until {}: both races turn at the same speed, so there are no shaft turns to "
                    "count; give seconds, e.g. 0.01s",
                    text));
  return value * 2.0 * std::numbers::pi / std::abs(shaft_speed);
}

RunOutcome run(const RunRequest& request, const ProgressSink& progress, std::stop_token stop) {
  const auto begin = Clock::now();
  Prepared prepared = prepare(request);
  apply_overrides(request, prepared);
  const fs::path folder = output_folder(request, prepared.input.path);
  RunOutcome out = prepared.control.dynamic ? run_dynamic(request, prepared, folder, progress, stop)
                                            : run_quasi_static(prepared, folder);
  out.folder = folder;
  std::vector<Issue> remarks = std::move(out.warnings);
  out.warnings = prepared.input.warnings;
  for (Issue& note : solution_notes(prepared)) out.warnings.push_back(std::move(note));
  for (Issue& note : remarks) out.warnings.push_back(std::move(note));
  out.seconds = seconds_since(begin);
  return out;
}

}  // namespace adore::facade
