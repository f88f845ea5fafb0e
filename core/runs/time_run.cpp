#include "runs/time_run.hpp"

#include "deck/unit_text.hpp"
#include "runs/changed_equilibrium.hpp"
#include "runs/missed_tolerance.hpp"
#include "runs/user_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace adore::runs {
namespace {

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

}  // namespace

TimeRun::TimeRun(const RunParts& parts, const StartPoint& start, const RunSpan& span, long last,
                 const integrators::StepControl& control, std::stop_token stop)
    : parts_(parts),
      start_(start),
      span_(span),
      last_counted_step_(last),
      control_(control),
      stop_(std::move(stop)),
      step_error_monitor_(parts.prepared.control, parts.system->scales().time),
      race_load_monitor_(parts.system->scales().time, control.maximum),
      film_tolerance_(control.tolerance, parts.system->scales()),
      rest_detector_(parts.prepared),
      growth_(parts.growth),
      step_(start.step),
      substeps_(start.resume.substeps),
      h_(start.step_size),
      counters_(start.resume.counters),
      held_changes_(start.resume.held_changes),
      error_sum_(start.resume.error_sum),
      error_largest_(start.resume.error_largest),
      reduced_tolerance_time_(start.resume.tight_time),
      smallest_tolerance_(start.resume.tightest),
      stepper_cost_entry_(parts.system->cost().add_entry("stepper")),
      output_cost_entry_(parts.system->cost().add_entry("output")) {
  if (start.resume.tolerance > 0.0) control_.tolerance = start.resume.tolerance;
}

template <class Action>
void TimeRun::output(Action&& action) {
  const double at = scene::processor_seconds();
  action();
  const double spent = scene::processor_seconds() - at;
  system().cost().add(output_cost_entry_, spent);
  output_seconds_ += spent;
}

Resume TimeRun::resume(bool failed) const {
  Resume so_far{0, {}, counters_, held_changes_, error_sum_, error_largest_};
  const double deck = parts_.prepared.control.tolerance;
  so_far.tolerance = control_.tolerance != deck ? control_.tolerance : 0.0;
  so_far.tight_time = reduced_tolerance_time_;
  so_far.tightest = smallest_tolerance_;
  add_counters(so_far.counters, parts_.stepper.counters());
  if (failed) return so_far;  // the stepper's memory may be meaningless
  so_far.substeps = substeps_;
  so_far.memory = parts_.stepper.memory();
  return so_far;
}

void TimeRun::checkpoint() {
  output([&] { parts_.outputs.checkpoint(system(), point(), resume(false)); });
}

void TimeRun::check_race_load() {
  const dynamics::RaceLoad& load = system().balanced_race();
  double contact = 0.0;
  if (load.asked.squaredNorm() > 0.0)
    for (const std::size_t race : {0U, 1U})
      for (const double one : system().contact_loads(race)) contact = std::max(contact, one);
  race_load_monitor_.check(parts_.stepper.time(), load, contact);
}

void TimeRun::adapt_tolerance() {
  if (step_ % FilmTolerance::kCheckInterval != 0 || control_.minimum == control_.maximum) return;
  const double wanted = film_tolerance_.wanted(system(), control_.tolerance);
  if (wanted == control_.tolerance) return;
  control_.tolerance = wanted;
  if (wanted < parts_.prepared.control.tolerance)
    smallest_tolerance_ =
        smallest_tolerance_ > 0.0 ? std::min(smallest_tolerance_, wanted) : wanted;
  restart_stepper(
      std::vector<double>(parts_.stepper.state().begin(), parts_.stepper.state().end()));
}

void TimeRun::restart_stepper(std::span<const double> y) {
  start_stepper_at(parts_.stepper.time(), y);
}

void TimeRun::start_stepper_at(double t, std::span<const double> y) {
  add_counters(counters_, parts_.stepper.counters());
  ++counters_.restarts;
  integrators::StepControl again = control_;
  again.initial = h_;
  parts_.stepper.start(parts_.ode, t, y, again);
}

bool TimeRun::update_held_elements() {
  std::vector<double> y(parts_.stepper.state().begin(), parts_.stepper.state().end());
  if (!system().between_steps(parts_.stepper.time(), y)) return false;
  ++held_changes_;
  restart_stepper(y);
  return true;
}

void TimeRun::thermal_step() {
  const double t = parts_.stepper.time();
  std::vector<double> y(parts_.stepper.state().begin(), parts_.stepper.state().end());
  ThermalRun& thermal = *parts_.thermal;
  const bool settled = thermal.settled();
  const ThermalRun::Step done =
      thermal.close(system().snapshot(t, y), race_conductance(parts_.prepared));
  add_thermal_remark(done, thermal.settled() && !settled);
  try {
    const std::vector<Finding> doubts =
        move_keeping_start_speeds(parts_.prepared, thermal.operating());
    for (const Finding& doubt : doubts)
      if (!films_uncertain_)
        parts_.outputs.remark(
            renamed(doubt, "thermal.film_doubt",
                    fmt::format("from thermal step {} on: {}", done.number, doubt.message))
                .at(t));
    films_uncertain_ = !doubts.empty();
    dynamics::System next = make_system(parts_.prepared);
    move_into_system(std::move(next), t, y, fmt::format("thermal step {}", done.number));
  } catch (const InputError& error) {
    throw SolverError(
        fmt::format("at t = {:.9g} s, the geometry after thermal step {} is not possible: {}", t,
                    done.number, error.what()));
  } catch (const SolverError& error) {
    throw SolverError(
        fmt::format("at t = {:.9g} s, after thermal step {}: {}", t, done.number, error.what()));
  }
  parts_.outputs.thermal_step(done, t);
  restart_stepper(y);
}

void TimeRun::add_thermal_remark(const ThermalRun::Step& done, bool settles) {
  const double t = parts_.stepper.time();
  if (settles)
    parts_.outputs.remark(
        make_finding(
            "thermal.settled",
            fmt::format("thermal analysis: temperatures settled at thermal step {}, t = {:.6g} s",
                        done.number, t))
            .at(t));
  if (done.number == 1 && done.window < done.passing)
    parts_.outputs.remark(
        make_finding(
            "thermal.window",
            fmt::format("thermal analysis: aveTime = {:.3g} ms is shorter than one element passage "
                        "({:.3g} ms), so the heat varies from one thermal step to the next, and "
                        "each printed thermal network shows only one step. The temperatures follow "
                        "the mean heat. For steady values, increase aveTime",
                        1e3 * done.window, 1e3 * done.passing))
            .measure(1e3 * done.window)
            .at(t));
  if (done.judged.verdict == thermal::StepVerdict::Divergent && done.window >= done.passing &&
      !temperature_growth_reported_) {
    temperature_growth_reported_ = true;
    add_remark(
        parts_.prepared,
        make_finding(
            "thermal.growing",
            fmt::format("thermal analysis: temperature changes grew over four thermal steps up to "
                        "step {}, t = {:.6g} s, heat {:.4g} W",
                        done.number, t, done.heat.sources.total()))
            .at(t));
  }
}

void TimeRun::move_into_system(dynamics::System next, double t, std::span<double> y,
                               const std::string& cause) {
  const std::vector<double> y_before(y.begin(), y.end());
  next.continue_from(system(), t, y);
  const dynamics::EquilibriumChange change =
      dynamics::move_to_equilibrium(moving_scene(parts_.prepared, system()), t, y_before,
                                    moving_scene(parts_.prepared, next), t, y);
  dynamics::book_change(system(), y_before, next, t, y);
  parts_.system.emplace(std::move(next));
  if (auto excess =
          equilibrium_change_finding(change, cause, user_routine_motion_text(parts_.prepared)))
    add_remark(parts_.prepared, excess->at(parts_.stepper.time()));
}

bool TimeRun::apply_ring_growth() {
  if (!growth_.active()) return false;
  const double t = parts_.stepper.time();
  std::vector<double> y(parts_.stepper.state().begin(), parts_.stepper.state().end());
  const dynamics::PrescribedRaces races = system().prescribed_races(t, y);
  const std::array<double, 2> speed{races[0].speed, races[1].speed};
  const RingGrowth::Levels levels = growth_.levels(speed);
  if (levels == growth_levels_) return false;
  growth_levels_ = levels;
  try {
    apply_race_speeds(parts_.prepared, parts_.thermal, growth_.speeds(levels, speed));
    move_into_system(make_system(parts_.prepared), t, y, "centrifugal growth of the rings");
  } catch (const InputError& error) {
    throw SolverError(
        fmt::format("at t = {:.9g} s, after the update of the centrifugal growth of the rings: {}",
                    t, error.what()));
  }
  restart_stepper(y);
  return true;
}

void TimeRun::begin(bool remembers) {
  if (growth_.active()) {
    const dynamics::PrescribedRaces races = system().prescribed_races(start_.time, start_.y);
    growth_levels_ = growth_.levels({races[0].speed, races[1].speed});
  }
  if (!start_.continued && system().between_steps(start_.time, start_.y)) ++held_changes_;
  try {
    if (remembers)
      parts_.stepper.resume(parts_.ode, start_.time, start_.y, control_, start_.resume.memory);
    else
      parts_.stepper.start(parts_.ode, start_.time, start_.y, control_);
  } catch (const std::out_of_range&) {
    throw InputError(
        fmt::format("{}: the stored state of the integrator {} is incomplete; the file is damaged. "
                    "Restore it, or start again with --overwrite",
                    parts_.master.string(), parts_.prepared.control.integrator));
  }
  started_ = true;
  rest_detector_.examine(system(), state());
  if (start_.continued) return;
  output([&] {
    parts_.outputs.evaluate_life(system(), {0, start_.time, 0.0, start_.y});
    parts_.outputs.store(system(), {0, start_.time, 0.0, start_.y}, true);
  });
  checkpoint();
}

bool TimeRun::take_rest_step() {
  if (substeps_ != 0 || control_.minimum == control_.maximum) return false;
  constexpr double kMinStepsPerRun = 50.0;
  const double t = parts_.stepper.time();
  const double usual = control_.maximum * static_cast<double>(parts_.prepared.control.substeps);
  const double length = rest_detector_.step(parts_.stepper, parts_.ode, control_.tolerance, usual,
                                            (span_.end - start_.time) / kMinStepsPerRun, span_.end);
  if (!(length > 0.0)) return false;
  if (rest_start_time_ < 0.0) {
    rest_start_time_ = t;
    parts_.outputs.remark(
        make_finding("run.rest",
                     fmt::format("the bearing is at rest from t = {:.4g} s: time advances in "
                                 "steps of up to {:.3g} s without integration{}",
                                 t, length,
                                 start_.at_rest ? ". The cage and the elements without load start "
                                                  "at their rest positions"
                                                : ""))
            .at(t));
  }
  const std::vector<double> y(parts_.stepper.state().begin(), parts_.stepper.state().end());
  start_stepper_at(std::min(t + length, span_.end), y);
  return true;
}

bool TimeRun::take_counted_step() {
  if (take_rest_step()) {
    ++step_;
    return true;
  }
  const long whole = parts_.prepared.control.substeps;
  while (substeps_ < whole && parts_.stepper.time() < span_.end) {
    if (stop_.stop_requested()) return false;
    const integrators::StepInfo made = parts_.stepper.step(span_.end);
    h_ = made.h;
    const double error = made.error * control_.tolerance / parts_.prepared.control.tolerance;
    error_sum_ += error;
    error_largest_ = std::max(error_largest_, error);
    if (control_.tolerance < parts_.prepared.control.tolerance) reduced_tolerance_time_ += made.h;
    ++substeps_;
    if (substeps_ == whole) break;
    parts_.outputs.follow_step(system(), parts_.stepper.time(), false);
    check_race_load();
    if (parts_.outputs.checkpoint_due()) checkpoint();
    parts_.meter.update(parts_.stepper.time(), step_);
  }
  substeps_ = 0;
  ++step_;
  return true;
}

void TimeRun::after_counted_step() {
  RunOutputs& outputs = parts_.outputs;
  const double t = parts_.stepper.time();
  system().check_state(t, parts_.stepper.state().data());
  step_error_monitor_.check(parts_.stepper);
  // The last step has all that a run tells at its end (kLifeFreq 0), where files store it anyway.
  const bool last = t >= span_.end || step_ >= last_counted_step_;
  const bool stored = outputs.saves(step_, last);
  outputs.follow_step(system(), t, stored);
  check_race_load();
  adapt_tolerance();
  bool jumped = parts_.prepared.plan.has(scene::Effect::LightLoadBalance) && update_held_elements();
  output([&] { jumped = apply_ring_growth() || jumped; });
  if (parts_.thermal != nullptr && parts_.thermal->due(t)) {
    output([&] { thermal_step(); });
    jumped = true;
  }
  const RunPoint now = point();
  if (jumped) {
    system().check_state(now.time, now.y.data());
    outputs.sample_state_jump(system(), stored);
  }
  if (outputs.life_due()) output([&] { outputs.evaluate_life(system(), now); });
  if (outputs.wants(step_)) output([&] { outputs.store(system(), now, last); });
  outputs.follow(now);
  if (parts_.prepared.user) output([&] { outputs.call_user_routines(system(), now); });
  if (outputs.checkpoint_due()) checkpoint();
  parts_.meter.update(t, step_);
}

void TimeRun::steps() {
  while (parts_.stepper.time() < span_.end && step_ < last_counted_step_) {
    if (!take_counted_step()) {
      status_ = RunStatus::Interrupted;
      return;
    }
    after_counted_step();
  }
}

void TimeRun::fail(const std::string& why) {
  status_ = RunStatus::Failed;
  message_ = why;
  if (parts_.prepared.user) message_ = add_routine_message(*parts_.prepared.user, message_);
}

void TimeRun::close(RunEnd& end) {
  const deck::UnitSystem units = parts_.prepared.input.deck.units();
  end.status = status_;
  end.point = point();
  end.resume = resume(status_ == RunStatus::Failed);
  try {
    output([&] { parts_.outputs.store_last_point(system(), end); });
  } catch (const SolverError& failure) {
    // A user routine rejects a state that it accepted before: the last checkpoint remains.
    if (status_ != RunStatus::Failed) fail(deck::message_in_units(failure.what(), units));
  }
  const results::EnergyJudgment judgement = parts_.outputs.judge_energy();
  if (judgement.trust == results::Trust::None && status_ != RunStatus::Failed) {
    if (status_ == RunStatus::Done) status_ = RunStatus::Untrusted;
    message_ = deck::message_in_units(judgement.text, units);
  } else if (judgement.trust == results::Trust::Warned) {
    add_remark(parts_.prepared, make_finding("end.energy", judgement.text));
  }
  if (MissedTolerance missed = judge_missed_tolerance(parts_.prepared.control, end.resume.counters,
                                                      end.resume.error_sum);
      !missed.trusted && status_ == RunStatus::Done) {
    status_ = RunStatus::Untrusted;
    message_ = std::move(missed.text);
  }
  if (std::string why = parts_.outputs.untrusted_law_reason();
      !why.empty() && status_ == RunStatus::Done) {
    status_ = RunStatus::Untrusted;
    message_ = std::move(why);
  }
  if (parts_.thermal != nullptr && !parts_.thermal->hot().empty()) {
    const std::string hot = "thermal analysis, last thermal step: " + parts_.thermal->hot();
    if (parts_.thermal->has_mean_temperatures() && status_ == RunStatus::Done) {
      status_ = RunStatus::Untrusted;
      message_ = hot;
    } else {
      add_remark(parts_.prepared, make_finding("thermal.hot", hot));
    }
  }
  if (reduced_tolerance_time_ > 0.0 && end.point.time > 0.0)
    parts_.outputs.remark(
        make_finding("end.film_tolerance",
                     film_tolerance_text(parts_.prepared.control.tolerance, smallest_tolerance_,
                                         reduced_tolerance_time_ / end.point.time)));
  if (const std::string text = parts_.outputs.load_warning(); !text.empty())
    add_remark(parts_.prepared, make_finding("end.load", text));
}

double TimeRun::count_loop_time() {
  const double loop = scene::processor_seconds() - loop_start_seconds_;
  double rhs = 0.0;
  for (const auto& row : system().cost().rows())
    if (row.name != "stepper" && row.name != "output") rhs += row.seconds;
  system().cost().add(stepper_cost_entry_, std::max(0.0, loop - rhs - output_seconds_));
  return loop;
}

void TimeRun::fill_outcome(RunOutcome& out, const RunEnd& end) const {
  out.status = status_;
  out.message = message_;
  out.files = parts_.outputs.files();
  out.summary = parts_.outputs.summary();
  out.means = parts_.outputs.means();
  out.steps = step_;
  out.taken = end.resume.counters.steps;
  out.evaluations = end.resume.counters.evaluations;
  out.longest_step = control_.maximum;
  out.time = end.point.time;
  out.speeds_vary = speeds_vary(parts_.prepared);
  out.warnings = parts_.outputs.remarks();
  out.energy_residual = parts_.outputs.energy_residual();
  out.energy_scale = parts_.outputs.energy_scale();
}

RunOutcome TimeRun::run(bool remembers) {
  const integrators::Stepper& stepper = parts_.stepper;
  const deck::UnitSystem units = parts_.prepared.input.deck.units();
  loop_start_seconds_ = scene::processor_seconds();
  try {
    begin(remembers);
    steps();
  } catch (const integrators::StepFailure& failure) {
    std::string why = failure.what();
    const double least = std::max(parts_.prepared.control.step_minimum * system().scales().time,
                                  1e-3 * std::abs(h_));
    const RunPoint here = point();
    if (const std::string beyond = invalid_state_message(system(), here.time, here.y, least);
        !beyond.empty())
      why += " Invalid state ahead: " + deck::message_in_units(beyond, units);
    fail(why);
  } catch (const SolverError& failure) {
    fail(deck::message_in_units(failure.what(), units));
  }
  if (status_ != RunStatus::Failed)
    parts_.meter.finish(stepper.time(), step_, status_ == RunStatus::Done);

  RunEnd end;
  close(end);
  end.status = status_;
  end.message = message_;
  end.loop_seconds = count_loop_time();
  if (parts_.thermal != nullptr && parts_.thermal->steps() == 0)
    parts_.outputs.remark(
        make_finding("thermal.no_step",
                     "thermal analysis: the run ended before its first thermal step (aveTime); "
                     "temperatures are still those of record 9.1.3"));
  parts_.outputs.finish(system(), end);
  RunOutcome out;
  fill_outcome(out, end);
  return out;
}

}  // namespace adore::runs
