#include "facade/accuracy.hpp"

#include "facade/judge_steps.hpp"
#include "facade/system_ode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace adore::facade {
namespace {

struct EndState {
  std::vector<double> y;
  std::vector<double> loads;  ///< Q of every ball and race [N]
  double energy_residual = 0.0;
  integrators::Counters counters;
  double seconds = 0.0;
};

/// Smallest and longest step, and the order of methods that change theirs.
integrators::StepControl limits_of(const setup::RunControl& control, double time_scale) {
  integrators::StepControl out;
  out.initial = control.step_initial * time_scale;
  out.minimum = control.step_minimum * time_scale;
  out.maximum = control.step_maximum * time_scale;
  return out;
}

/// What a run of the deck with this method is held to: the deck's limits, or those that its
/// stability asks for. @throws InputError when the method is refused.
integrators::StepControl limits_of_run(Prepared prepared, const std::string& method,
                                       double time_scale) {
  prepared.control.integrator = method;
  integrators::StepControl out = limits_of(prepared.control, time_scale);
  const JudgedSteps steps = judge_steps(prepared, time_scale);
  if (steps.limits.action == StepAction::Refused) throw InputError(steps.text);
  if (steps.limits.action != StepAction::Kept) {
    out.minimum = steps.limits.minimum;
    out.maximum = steps.limits.maximum;
    out.highest_order = steps.limits.highest_order;
  }
  return out;
}

/// Integrates the deck's start state over the span with one method, tolerance and step control.
EndState integrate(const Prepared& prepared, const std::string& method, double tolerance,
                   double end, integrators::StepControl control, std::stop_token stop) {
  dynamics::System system = make_system(prepared);
  std::vector<double> start = system.initial_state();
  system.set_start(0.0, start);
  // With qFac: the elements that the start state holds, for the whole span. When a method would
  // hold or release others depends on where its steps end, and that is no error of the method.
  system.between_steps(0.0, start);
  SystemOde ode(system);
  const auto stepper = integrators::make_stepper(method);
  control.tolerance = tolerance;
  const auto begin = std::chrono::steady_clock::now();
  stepper->start(ode, 0.0, start, control);
  while (stepper->time() < end && !stop.stop_requested()) stepper->step(end);
  EndState out;
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  out.y.assign(stepper->state().begin(), stepper->state().end());
  out.counters = stepper->counters();
  const scene::Snapshot snapshot = system.snapshot(stepper->time(), out.y);
  out.energy_residual = std::abs(snapshot.energy.residual());
  for (const scene::ElementSnapshot& element : snapshot.elements)
    for (const scene::RaceContactSnapshot& contact : element.race)
      out.loads.push_back(contact.load);
  return out;
}

double state_difference(const std::vector<double>& a, const std::vector<double>& b,
                        std::span<const double> scales, int controlled) {
  double out = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(controlled); ++i)
    out = std::max(out, std::abs(a[i] - b[i]) / scales[i]);
  return out;
}

double load_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return largest > 0.0 ? difference / largest : difference;
}

}  // namespace

AccuracyStudy study_accuracy(const AccuracyRequest& request,
                             const std::function<void(const AccuracyRow&)>& row_done,
                             std::stop_token stop) {
  const Prepared prepared = prepare(request);
  if (!prepared.control.dynamic)
    throw InputError(
        "an accuracy study integrates in time, and this deck is quasi-static (mode < 0); set mode "
        "= 0");
  for (const std::string& method : request.methods) {
    try {
      (void)integrators::make_stepper(method);
    } catch (const std::invalid_argument& error) {
      throw InputError(error.what());
    }
  }
  const dynamics::System system = make_system(prepared);
  const auto scales = system.layout().scales();
  const int controlled = system.layout().controlled_size();
  const double scale = system.scales().time;
  const double end = request.span * scale;

  AccuracyStudy study;
  study.span_seconds = end;
  study.span_revolutions =
      (prepared.bearing.speed[1] - prepared.bearing.speed[0]) * end / (2.0 * std::numbers::pi);
  const double tight = std::min(
      1e-11, 1e-2 * *std::min_element(request.tolerances.begin(), request.tolerances.end()));
  study.steps =
      fmt::format("{:.3g} to {:.3g} s (stpMin {:g}, stpMax {:g})",
                  prepared.control.step_minimum * scale, prepared.control.step_maximum * scale,
                  prepared.control.step_minimum, prepared.control.step_maximum);
  study.reference =
      fmt::format("rkf7 at {:.0e}, checked against rkf5 at {:.0e}", tight, 10.0 * tight);
  EndState reference, check;
  try {
    // The reference may take smaller steps than the deck allows, not longer ones.
    integrators::StepControl free = limits_of(prepared.control, scale);
    free.minimum = 0.0;
    reference = integrate(prepared, "rkf7", tight, end, free, stop);
    check = integrate(prepared, "rkf5", 10.0 * tight, end, free, stop);
  } catch (const integrators::StepFailure& failure) {
    throw SolverError(fmt::format("no reference solution: {}", failure.what()));
  }
  study.reference_check = state_difference(check.y, reference.y, scales, controlled);

  for (const std::string& method : request.methods) {
    integrators::StepControl control;
    std::string refusal;
    try {
      control = limits_of_run(prepared, method, scale);
    } catch (const InputError& error) {
      refusal = error.what();
    }
    for (const double tolerance : request.tolerances) {
      if (stop.stop_requested()) return study;
      AccuracyRow row;
      row.method = method;
      row.tolerance = tolerance;
      row.failure = refusal;
      try {
        if (refusal.empty()) {
          const EndState result = integrate(prepared, method, tolerance, end, control, stop);
          row.error = state_difference(result.y, reference.y, scales, controlled);
          row.load_error = load_difference(result.loads, reference.loads);
          row.energy_residual = result.energy_residual;
          row.steps = result.counters.steps;
          row.at_minimum = result.counters.at_minimum;
          row.rejected = result.counters.rejected;
          row.evaluations = result.counters.evaluations;
          row.seconds = result.seconds;
        }
      } catch (const integrators::StepFailure& failure) {
        row.failure = failure.what();
      } catch (const std::invalid_argument& error) {
        row.failure = error.what();
      }
      study.rows.push_back(row);
      if (row_done) row_done(row);
    }
  }
  return study;
}

std::string accuracy_table(const AccuracyStudy& study) {
  std::string out = fmt::format(
      "span {:.4g} s, {:.3g} revolutions; steps as the deck allows them: {}\n"
      "reference: {} (they differ by {:.1e})\n\n"
      "{:<12} {:>8} {:>10} {:>10} {:>12} {:>8} {:>8} {:>10} {:>10} {:>9}\n",
      study.span_seconds, study.span_revolutions, study.steps, study.reference,
      study.reference_check, "method", "tol", "error", "load error", "energy [J]", "steps",
      "rejected", "at stpMin", "rhs calls", "time [s]");
  for (const AccuracyRow& row : study.rows) {
    if (row.failure.empty())
      out += fmt::format(
          "{:<12} {:>8.0e} {:>10.2e} {:>10.2e} {:>12.2e} {:>8} {:>8} {:>10} {:>10} {:>9.3f}\n",
          row.method, row.tolerance, row.error, row.load_error, row.energy_residual, row.steps,
          row.rejected, row.at_minimum, row.evaluations, row.seconds);
    else
      out += fmt::format("{:<12} {:>8.0e} gave up: {}\n", row.method, row.tolerance, row.failure);
  }
  return out;
}

std::string accuracy_csv(const AccuracyStudy& study) {
  std::string out =
      "method,tol,error,load_error,energy_residual_J,steps,rejected,at_minimum,rhs_calls,seconds,"
      "failure\n";
  for (const AccuracyRow& row : study.rows) {
    std::string failure = row.failure;
    std::replace(failure.begin(), failure.end(), '"', '\'');
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},\"{}\"\n", row.method, row.tolerance,
                       row.error, row.load_error, row.energy_residual, row.steps, row.rejected,
                       row.at_minimum, row.evaluations, row.seconds, failure);
  }
  return out;
}

}  // namespace adore::facade
