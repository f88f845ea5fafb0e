#include "facade/run.hpp"

#include "base/write_error.hpp"
#include "deck/unit_text.hpp"
#include "dynamics/race_contacts.hpp"
#include "facade/chosen_settings.hpp"
#include "facade/judge_steps.hpp"
#include "facade/key_results.hpp"
#include "facade/output_folder.hpp"
#include "facade/run_outputs.hpp"
#include "facade/solver_stamp.hpp"
#include "facade/system_ode.hpp"
#include "facade/thermal_run.hpp"
#include "facade/unused_request.hpp"
#include "facade/user_session.hpp"
#include "results/growing_file.hpp"
#include "results/restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

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
    for (bearing::Bearing* one : {&prepared.as_built, &prepared.bearing})
      if (one->lubrication) one->lubrication->tolerance = *request.tolerance;
  }
}

/// Does a race turn at another speed than the deck's constant one?
bool speeds_vary(const Prepared& prepared) {
  const bearing::RaceMotions& motions = prepared.plan.race_motions;
  for (std::size_t j = 0; j < 2; ++j)
    if (motions.ramp[j] || motions.variation[j] || (prepared.user && prepared.user->drives()[j]) ||
        (motions.free[j] && !motions.free[j]->rotation_held[0]))
      return true;
  return false;
}

/// Steps and end time of a run in seconds.
struct Span {
  double end = 0.0;    ///< [s]
  long max_steps = 0;  ///< counted steps
};

Span run_span(const RunRequest& request, const Prepared& prepared, double time_scale) {
  const double shaft_speed = prepared.bearing.speed[1] - prepared.bearing.speed[0];
  const bool turns = request.until.ends_with("rev");
  if (turns && speeds_vary(prepared))
    throw InputError(fmt::format(
        "--until {}: the speed of a race varies in time (kVarSpeed, or kMD11 or kMD12 = "
        "0), so that turns of the shaft give no end time; give seconds, e.g. 0.01s",
        request.until));
  if (!request.until.empty())
    return {parse_until(request.until, shaft_speed, time_scale), std::numeric_limits<long>::max()};
  return {prepared.control.end_time * time_scale, prepared.control.max_steps};
}

/// Number of the last counted step of a run that goes on or begins at `start`.
long last_step(const RunRequest& request, const Span& span, const StartPoint& start) {
  const long from = start.continued && request.go_on ? start.segment : start.step;
  constexpr long kMost = std::numeric_limits<long>::max();
  return span.max_steps > kMost - from ? kMost : from + span.max_steps;
}

/// How much later than from the speeds alone a run that goes on has turned as far as it is asked:
/// its speeds were others before [s].
double delay_of_turns(const RunRequest& request, const StartPoint& start, double turned,
                      double turns_per_second) {
  if (!start.continued || !request.until.ends_with("rev")) return 0.0;
  const double delay = start.time - turned / turns_per_second;
  return std::abs(delay) > 1e-12 * start.time ? delay : 0.0;
}

/// A continued run must have its end before it.
/// @param turned of the shaft until now
/// @return true when it has reached it already
bool at_its_end(const Span& span, long last_step, const StartPoint& start, double turned,
                double turns_per_second) {
  const auto refuse = [&](const std::string& end, const std::string& now) {
    throw InputError(fmt::format(
        "the run to be continued stands at {} already, after the end that is asked for, {}; give a "
        "later end with --until, fTime or maxStps",
        now, end));
  };
  if (span.end < start.time * (1.0 - 1e-12)) {
    const auto text = [&](double time) {
      return turns_per_second != 0.0 ? fmt::format("{:.6g} s ({:.6g} turns)", time,
                                                   turned + turns_per_second * (time - start.time))
                                     : fmt::format("{:.6g} s", time);
    };
    refuse(text(span.end), text(start.time));
  }
  if (last_step < start.step)
    refuse(fmt::format("step {}", last_step), fmt::format("step {}", start.step));
  return start.time >= span.end || last_step == start.step;
}

/// Reports progress at most about 20 times a second.
class ProgressMeter {
 public:
  /// @param turns of the shaft, now
  ProgressMeter(const ProgressSink& sink, double start, const Span& span,
                std::function<double()> turns)
      : sink_(sink), start_(start), span_(span), turns_(std::move(turns)) {}

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
    p.revolutions = turns_();
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
  std::function<double()> turns_;
  Clock::time_point begin_ = Clock::now();
  double sent_ = -1.0;
};

RunOutcome run_quasi_static(const RunRequest& request, const Prepared& prepared,
                            const fs::path& folder) {
  if (request.go_on)
    throw InputError(fmt::format(
        "--continue: the deck {} is quasi-static, there is nothing to go on with; leave it out",
        prepared.input.path.string()));
  RunOutcome out;
  RunOutputs outputs(prepared, folder, request_digest(request, prepared.input), request.overwrite);
  out.results = outputs.write_quasi_static();
  out.files = outputs.files();
  out.summary = outputs.summary();
  out.warnings = outputs.remarks();
  return out;
}

void warn(Prepared& prepared, const std::string& text, Severity severity = Severity::Warning) {
  Issue issue;
  issue.severity = severity;
  issue.file = prepared.input.path.string();
  issue.message = text;
  prepared.input.warnings.push_back(std::move(issue));
}

/// The steps that the run takes. What was changed becomes a remark on the deck and part of its
/// plan.
/// @throws InputError when the method is refused.
StepLimits settle_steps(Prepared& prepared, double time_scale) {
  const JudgedSteps steps = judge_steps(prepared, time_scale);
  if (steps.limits.action == StepAction::Refused) throw InputError(steps.text);
  prepared.stability = steps.text;
  if (steps.limits.action != StepAction::Kept) warn(prepared, steps.text);
  return steps.limits;
}

/// Ends a run whose steps are all too long for its tolerance and may not be shorter: what it
/// computes has no known error, and waiting for its end tells nobody.
class StepWatch {
 public:
  StepWatch(const setup::RunControl& control, double time_scale)
      : control_(control),
        constant_(control.step_minimum == control.step_maximum),
        minimum_(control.step_minimum * time_scale) {}
  /// @throws SolverError
  void look(const integrators::Stepper& stepper) {
    const integrators::Counters& now = stepper.counters();
    if (now.steps - now.at_minimum != kept_ || now.steps < since_) {
      kept_ = now.steps - now.at_minimum;
      since_ = now.steps;
    }
    if (constant_ || now.steps - since_ < kPatience) return;
    throw SolverError(fmt::format(
        "at t = {:.9g} s: each of the last {} steps of {} missed the tolerance of {:g} although it "
        "was "
        "the smallest that record 2.1 allows (stpMin {:g}, {:.3g} s): nothing is known of the "
        "error. "
        "Something decays or vibrates faster than that step, often a film or friction whose slope "
        "is steep under a high pressure. Make stpMin smaller; where that takes too long, an "
        "implicit "
        "method (arkode-dirk, cvode-bdf) may go on, or a law that is less steep there",
        stepper.time(), now.steps - since_, control_.integrator, control_.tolerance,
        control_.step_minimum, minimum_));
  }

 private:
  static constexpr long kPatience = 10000;
  const setup::RunControl& control_;
  bool constant_;
  double minimum_;             ///< [s]
  long kept_ = 0, since_ = 0;  ///< steps that kept the tolerance; how many there were at the last
};

/// What is not valid a little further on: the sentence of the first such state on the way that the
/// rates point, up to some steps of h [s] from (t, y). Empty: none found.
std::string invalid_beyond(dynamics::System& system, double t, std::span<const double> y,
                           double h) {
  std::vector<double> rates(y.size()), there(y.size());
  if (system.rhs(t, y.data(), rates.data()) != dynamics::RhsStatus::Ok) return {};
  for (double way = 0.25 * h; way <= 1e3 * h; way *= 2.0) {
    for (std::size_t i = 0; i < y.size(); ++i) there[i] = y[i] + way * rates[i];
    try {
      system.check_state(t + way, there.data());
    } catch (const SolverError& error) {
      return error.what();
    }
  }
  return {};
}

/// The deck's integrator. @throws InputError when it cannot do what the deck asks of it.
std::unique_ptr<integrators::Stepper> make_checked_stepper(const setup::RunControl& control,
                                                           const SystemOde& ode, bool held,
                                                           bool rollers, bool damped) {
  auto stepper = integrators::make_stepper(control.integrator);
  if (stepper->name() == "arkode-imex" && damped)
    throw InputError(
        "arkode-imex takes the elastic part of the normal contacts implicitly, and run option "
        "contactDamping adds a part that it does not split off; use arkode-dirk (intMet 32) or "
        "arkode-erk (intMet 31), or leave the option out");
  if (stepper->name() == "arkode-imex" && rollers)
    throw InputError(
        "arkode-imex takes the normal contacts of balls and races implicitly; those of rollers are "
        "not split off; use arkode-dirk (intMet 32) or arkode-erk (intMet 31)");

  if (stepper->name() == "arkode-imex" && held)
    throw InputError(
        "arkode-imex splits the motion of freely moving elements, and qFac on record 2.1, or mode "
        "1 "
        "or 2, holds elements in force balance; set qFac and mode to 0, or use arkode-dirk (intMet "
        "32) or arkode-erk (intMet 31)");
  if (stepper->name() == "arkode-imex" && !ode.has_stiff_part())
    throw InputError(
        "arkode-imex takes the normal contacts of elements and races implicitly, and this deck has "
        "none; use arkode-dirk (intMet 32) or arkode-erk (intMet 31)");
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
  sum.repeated_for_energy += c.repeated_for_energy;
}

/// How to go on after a file could not be written.
std::string way_on(const fs::path& master) {
  std::error_code error;
  return fs::exists(master, error)
             ? "the files are valid up to their last whole step: go on with --continue"
             : "the run had no checkpoint yet: start it again, with --overwrite";
}

/// Temperatures and geometry of the run that goes on; false: it has none.
bool restore_thermal(ThermalRun& thermal, Prepared& prepared, const fs::path& master) {
  std::error_code error;
  if (!fs::exists(master, error)) return false;
  if (!thermal.restore(results::read_master(master).averages, master)) return false;
  move_to(prepared, thermal.operating());
  return true;
}

RunOutcome simulate(const RunRequest& request, Prepared& prepared, const fs::path& folder,
                    const ProgressSink& progress, std::stop_token stop) {
  const auto begin = Clock::now();
  const setup::StartState how =
      request.go_on ? setup::StartState::Continue : prepared.control.start;
  const fs::path master = folder / prepared.control.master_file;
  const double elastic = static_elastic(prepared);  // as the first run had it, before thermal steps
  std::optional<ThermalRun> thermal;
  if (prepared.bearing.thermal) thermal.emplace(prepared);
  const bool thermal_goes_on =
      thermal && how == setup::StartState::Continue && restore_thermal(*thermal, prepared, master);
  std::optional<dynamics::System> at_present(make_system(prepared));
  state_in(prepared.plan, *at_present);
  dynamics::System& system = *at_present;  // thermal steps put another one into its place
  SystemOde ode(system, elastic);
  const auto stepper = make_checked_stepper(
      prepared.control, ode,
      prepared.plan.light_load_ratio > 0.0 || prepared.plan.has(scene::Effect::ElementBalance),
      prepared.plan.rollers, prepared.plan.has(scene::Effect::ContactDamping));
  // Everything is checked before a file of an earlier run is touched.
  (void)run_span(request, prepared, system.scales().time);
  const StepLimits limits = settle_steps(prepared, system.scales().time);
  if (request.go_on && !fs::exists(master))
    throw InputError(fmt::format(
        "{}: there is no run to go on with: it was never started here, or ended before its first "
        "checkpoint; start it again without --continue, with --overwrite if files are left",
        master.string()));
  RunOutputs outputs(prepared, folder, request_digest(request, prepared.input), request.overwrite);
  if (thermal) outputs.show_thermal(*thermal);
  StartPoint start = outputs.find_start(system, how);
  const double scale = system.scales().time;
  Span span = run_span(request, prepared, scale);
  const long last = last_step(request, span, start);
  const double turns_per_second =
      (prepared.bearing.speed[1] - prepared.bearing.speed[0]) / (2.0 * std::numbers::pi);
  const double turned =
      (system.shaft_rotation(start.time, start.y) + start.turned_before) / (2.0 * std::numbers::pi);
  span.end += delay_of_turns(request, start, turned, turns_per_second);
  if (start.continued && at_its_end(span, last, start, turned, turns_per_second) &&
      start.complete) {
    RunOutcome nothing;
    nothing.message = fmt::format(
        "nothing left to do: the run is complete, at step {} and t = {:.6g} s; go on with a later "
        "end (--until, fTime, maxStps)",
        start.step, start.time);
    nothing.steps = start.step;
    nothing.time = start.time;
    nothing.revolutions = turned;
    return nothing;
  }
  if (!start.continued || !request.go_on) start.segment = start.step;
  const bool remembers = start.continued && !start.resume.memory.empty();
  if (start.continued) {
    if (!remembers)
      outputs.remark(
          fmt::format("continued from step {}: {} starts anew there, because the run so far had "
                      "another method, "
                      "tolerance or limits of the step, or ended with a failure",
                      start.step, prepared.control.integrator));
    else if (!stepper->loses().empty())
      outputs.remark(
          fmt::format("continued from step {}: {} loses {}; the path differs from that of an "
                      "unbroken run by errors of the size that the tolerance allows",
                      start.step, prepared.control.integrator, stepper->loses()));
  }
  outputs.open(system, start);
  if (thermal && !thermal_goes_on)
    thermal->start(start.time, system.snapshot(start.time, start.y).energy);

  RunOutcome out;
  integrators::StepControl control;
  control.initial = start.step_size > 0.0 && prepared.control.step_initial == 0.0
                        ? start.step_size
                        : prepared.control.step_initial * scale;
  control.minimum = prepared.control.step_minimum * scale;
  control.maximum = prepared.control.step_maximum * scale;
  if (limits.action != StepAction::Kept) {
    control.minimum = limits.minimum;
    control.maximum = limits.maximum;
    control.highest_order = limits.highest_order;
  }
  control.tolerance = prepared.control.tolerance;

  const int stepper_cost = system.cost().add_entry("stepper");
  const int output_cost = system.cost().add_entry("output");
  const auto turns = [&] {
    return (system.shaft_rotation(stepper->time(), stepper->state()) + start.turned_before) /
           (2.0 * std::numbers::pi);
  };
  ProgressMeter meter(progress, start.time, span, turns);
  long step = start.step;
  long substeps = start.resume.substeps;  // done of the counted step under way
  double h = start.step_size;
  StepWatch step_watch(prepared.control, system.scales().time);
  double output_seconds = 0.0;  // of the processor, as all of the ledger
  auto output = [&](auto&& action) {
    const double at = scene::processor_seconds();
    action();
    const double spent = scene::processor_seconds() - at;
    system.cost().add(output_cost, spent);
    output_seconds += spent;
  };

  // Of the run before this process, and of the stepper before its last start.
  integrators::Counters counters = start.resume.counters;
  long held_changes = start.resume.held_changes;
  double error_sum = start.resume.error_sum, error_largest = start.resume.error_largest;
  const auto resume = [&](bool failed) {
    Resume so_far{0, {}, counters, held_changes, error_sum, error_largest};
    add_counters(so_far.counters, stepper->counters());
    if (failed) return so_far;  // what the stepper remembers may be meaningless
    so_far.substeps = substeps;
    so_far.memory = stepper->memory();
    return so_far;
  };
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
  /// Thermal analysis: the window is full; the state goes on in the new geometry, and the stepper
  /// starts anew.
  auto thermal_step = [&] {
    const double t = stepper->time();
    std::vector<double> y(stepper->state().begin(), stepper->state().end());
    const bool settled = thermal->settled();
    const ThermalRun::Step done = thermal->close(system.snapshot(t, y));
    if (thermal->settled() && !settled)
      outputs.remark(
          fmt::format("thermal analysis: temperatures settled at thermal step {}, t = {:.6g} s",
                      done.number, t));
    try {
      move_to(prepared, thermal->operating());
      dynamics::System next = make_system(prepared);
      next.take_over(system, t, y);
      at_present.emplace(std::move(next));
    } catch (const InputError& error) {
      throw SolverError(
          fmt::format("at t = {:.9g} s, thermal step {} leaves no bearing that could work: {}", t,
                      done.number, error.what()));
    } catch (const SolverError& error) {
      throw SolverError(
          fmt::format("at t = {:.9g} s, after thermal step {}: {}", t, done.number, error.what()));
    }
    outputs.thermal_step(done, t);
    add_counters(counters, stepper->counters());
    ++counters.restarts;
    integrators::StepControl again = control;
    again.initial = h;
    stepper->start(ode, t, y, again);
  };
  const bool may_hold = prepared.plan.has(scene::Effect::LightLoadBalance);

  const double loop_begin = scene::processor_seconds();
  try {
    if (!start.continued && system.between_steps(start.time, start.y)) ++held_changes;
    try {
      if (remembers)
        stepper->resume(ode, start.time, start.y, control, start.resume.memory);
      else
        stepper->start(ode, start.time, start.y, control);
    } catch (const std::out_of_range&) {
      throw InputError(
          fmt::format("{}: what {} remembers is incomplete; the file is damaged, restore it or "
                      "start again with "
                      "--overwrite",
                      master.string(), prepared.control.integrator));
    }
    const auto checkpoint = [&] {
      output([&] {
        outputs.checkpoint(system, {step, stepper->time(), h, stepper->state()}, resume(false));
      });
    };
    if (!start.continued) {
      output([&] { outputs.store(system, {0, start.time, 0.0, start.y}, true); });
      checkpoint();
    }
    while (out.status == RunStatus::Done && stepper->time() < span.end && step < last) {
      while (substeps < prepared.control.substeps && stepper->time() < span.end) {
        if (stop.stop_requested()) {
          out.status = RunStatus::Interrupted;
          break;
        }
        const integrators::StepInfo made = stepper->step(span.end);
        h = made.h;
        error_sum += made.error;
        error_largest = std::max(error_largest, made.error);
        ++substeps;
        if (substeps == prepared.control.substeps) break;
        outputs.follow_loads(system, stepper->time());
        if (outputs.checkpoint_due()) checkpoint();
        meter.update(stepper->time(), step, start.step);
      }
      if (out.status == RunStatus::Interrupted) break;
      substeps = 0;
      ++step;
      const RunPoint point{step, stepper->time(), h, stepper->state()};
      system.check_state(point.time, point.y.data());
      step_watch.look(*stepper);
      outputs.follow_loads(system, point.time);
      if (may_hold) update_held();
      if (thermal && thermal->due(stepper->time())) output(thermal_step);
      const RunPoint now{step, stepper->time(), h, stepper->state()};
      if (outputs.wants(step)) output([&] { outputs.store(system, now, false); });
      outputs.follow(now);
      if (prepared.user) output([&] { outputs.call_user(system, now); });
      if (outputs.checkpoint_due()) checkpoint();
      meter.update(stepper->time(), step, start.step);
    }
  } catch (const integrators::StepFailure& failure) {
    out.status = RunStatus::Failed;
    out.message = failure.what();
    const double least =
        std::max(prepared.control.step_minimum * system.scales().time, 1e-3 * std::abs(h));
    if (const std::string why = invalid_beyond(system, stepper->time(), stepper->state(), least);
        !why.empty())
      out.message +=
          " What is not valid there: " + deck::message_in_units(why, prepared.input.deck.units());
  } catch (const SolverError& failure) {
    out.status = RunStatus::Failed;
    out.message = deck::message_in_units(failure.what(), prepared.input.deck.units());
  }
  if (out.status == RunStatus::Failed && prepared.user)
    out.message = user_message(*prepared.user, out.message);
  const RunPoint end{step, stepper->time(), h, stepper->state()};
  if (out.status != RunStatus::Failed)
    meter.finish(end.time, step, start.step, out.status == RunStatus::Done);

  RunEnd summary;
  summary.status = out.status;
  summary.point = end;
  summary.resume = resume(out.status == RunStatus::Failed);
  try {
    output([&] { outputs.store_end(system, summary); });
  } catch (const SolverError& failure) {
    // A routine of the user refuses a state that it took before: the last checkpoint stands.
    if (out.status != RunStatus::Failed) {
      out.status = summary.status = RunStatus::Failed;
      out.message = deck::message_in_units(failure.what(), prepared.input.deck.units());
      if (prepared.user) out.message = user_message(*prepared.user, out.message);
    }
  }
  const results::EnergyJudgement judgement = outputs.judge_energy();
  if (judgement.trust == results::Trust::None && out.status != RunStatus::Failed) {
    if (out.status == RunStatus::Done) out.status = RunStatus::Untrusted;
    out.message = judgement.text;
  } else if (judgement.trust == results::Trust::Warned) {
    warn(prepared, judgement.text);
  }
  if (const std::string text = outputs.load_warning(); !text.empty()) warn(prepared, text);
  // What the loop spent outside the right-hand side and the output belongs to the stepper.
  const double loop_seconds = scene::processor_seconds() - loop_begin;
  double rhs_seconds = 0.0;
  for (const auto& row : system.cost().rows())
    if (row.name != "stepper" && row.name != "output") rhs_seconds += row.seconds;
  system.cost().add(stepper_cost, std::max(0.0, loop_seconds - rhs_seconds - output_seconds));

  summary.status = out.status;
  summary.message = out.message;
  summary.loop_seconds = loop_seconds;
  if (thermal && thermal->steps() == 0)
    outputs.remark(
        "thermal analysis: the run ended before its first thermal step (aveTime); temperatures "
        "stayed those of record 9.1.3");
  outputs.finish(system, summary);

  out.files = outputs.files();
  out.summary = outputs.summary();
  out.steps = step;
  out.taken = summary.resume.counters.steps;
  out.evaluations = summary.resume.counters.evaluations;
  out.longest_step = control.maximum;
  out.time = end.time;
  out.revolutions = turns();
  out.warnings = outputs.remarks();
  out.seconds = seconds_since(begin);
  out.energy_residual = outputs.energy_residual();
  out.energy_scale = outputs.energy_scale();
  return out;
}

RunOutcome run_dynamic(const RunRequest& request, Prepared& prepared, const fs::path& folder,
                       const ProgressSink& progress, std::stop_token stop) {
  try {
    return simulate(request, prepared, folder, progress, stop);
  } catch (const WriteError& error) {
    throw InputError(
        fmt::format("{}; {}", error.what(), way_on(folder / prepared.control.master_file)));
  } catch (const SolverError& error) {  // before the first step
    if (!prepared.user) throw;
    const std::string& failure = prepared.user->failure();
    throw SolverError(failure.empty() ? user_message(*prepared.user, error.what()) : failure);
  }
}

/// Shows a table over speed as pieces of work, at most about 20 times a second.
std::function<void(long, long)> table_meter(const ProgressSink& sink) {
  return [&sink, begin = Clock::now(), sent = -1.0](long done, long total) mutable {
    Progress p;
    p.elapsed = seconds_since(begin);
    if (p.elapsed - sent < 0.05 && done < total) return;
    sent = p.elapsed;
    p.fraction = static_cast<double>(done) / static_cast<double>(total);
    p.step = done;
    p.runs = total;
    p.piece = "speed";
    p.remaining = p.elapsed * (1.0 - p.fraction) / p.fraction;
    sink(p);
  };
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

std::string request_digest(const RunRequest& request, const LoadedDeck& deck) {
  std::string text = fmt::format("{}\n{}\n", solver_stamp(), deck::write_deck(deck.deck));
  for (const auto& [name, value] : deck.option_values) text += fmt::format("{}={}\n", name, value);
  if (!deck.user.empty())
    text += fmt::format("user={}\n{}\n", deck.user.string(), results::read_text_file(deck.user));
  text += fmt::format("{}\n{}\n", request.until, request.integrator);
  if (request.tolerance) text += fmt::format("{}\n", *request.tolerance);
  std::uint64_t sum = 0xcbf29ce484222325U;  // Fowler, Noll and Vo's FNV-1a
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return fmt::format("{:016x}", sum);
}

namespace {

/// @param remark on how the request came about; empty: none
RunOutcome run_with(const RunRequest& request, const std::string& remark,
                    const ProgressSink& progress, std::stop_token stop) {
  const auto begin = Clock::now();
  dynamics::check_instruction_set_request();
  LoadedDeck input = load_deck(request);
  input.stop = stop;
  if (progress) input.table_progress = table_meter(progress);
  if (input.deck.integer("kStif") > 0 && !request.go_on && input.deck.integer("kIcOpt") != 1) {
    // The table may take minutes: a folder that is taken is refused before.
    const fs::path there = request.out ? *request.out : input.path.parent_path();
    check_room({there.empty() ? "." : there, {"PRINT.txt"}, {input.path}}, request.overwrite);
  }
  Prepared prepared = prepare(std::move(input));
  apply_overrides(request, prepared);
  if (!remark.empty()) warn(prepared, remark, Severity::Note);
  const fs::path folder = output_folder(request, prepared.input.path);
  const FolderLock lock(folder);
  RunOutcome out = prepared.control.dynamic ? run_dynamic(request, prepared, folder, progress, stop)
                                            : run_quasi_static(request, prepared, folder);
  out.folder = folder;
  std::vector<Issue> remarks = std::move(out.warnings);
  out.warnings = prepared.input.warnings;
  for (Issue& note : unused_request(request, prepared)) out.warnings.push_back(std::move(note));
  for (Issue& issue : solution_notes(prepared)) out.warnings.push_back(std::move(issue));
  for (Issue& issue : remarks) out.warnings.push_back(std::move(issue));
  out.seconds = seconds_since(begin);
  return out;
}

}  // namespace

RunOutcome run(const RunRequest& request, const ProgressSink& progress, std::stop_token stop) {
  return run_with(request, {}, progress, std::move(stop));
}

RunOutcome run_chosen(RunRequest request, const ChosenSettings& chosen,
                      const ProgressSink& progress, std::stop_token stop) {
  add_choice(request, chosen);
  return run_with(request, chosen.text, progress, std::move(stop));
}

}  // namespace adore::facade
