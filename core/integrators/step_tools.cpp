#include "integrators/step_tools.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace adore::integrators {

int worst_index(const double* values, const double* weights, int n) noexcept {
  int worst = 0;
  double most = -1.0;
  for (int i = 0; i < n; ++i) {
    if (!std::isfinite(values[i])) return i;
    const double e = std::abs(values[i]) * weights[i];
    if (e > most) {
      most = e;
      worst = i;
    }
  }
  return worst;
}

std::string text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

void Evaluator::attach(OdeSystem& system, Counters& counters) noexcept {
  system_ = &system;
  counters_ = &counters;
  size_ = system.size();
  invalid_component_ = -1;
}

Outcome Evaluator::operator()(double t, const double* y, double* dydt) noexcept {
  ++counters_->evaluations;
  const EvalStatus status = system_->rhs(t, y, dydt);
  if (status == EvalStatus::Retry) return Outcome::Retry;
  if (status == EvalStatus::Fail) return Outcome::Fail;
  if (all_finite(dydt, size_)) return Outcome::Ok;
  for (invalid_component_ = 0; std::isfinite(dydt[invalid_component_]);) ++invalid_component_;
  return Outcome::NotFinite;
}

void check_start(const OdeSystem& system, double t0, std::span<const double> y0,
                 const StepControl& control) {
  const auto demand = [](bool condition, const char* sentence) {
    if (!condition) throw std::invalid_argument(sentence);
  };
  const auto scales = system.scales();
  const int controlled = system.controlled_size();
  demand(system.size() > 0 && controlled >= 0 && controlled <= system.size(),
         "the number of controlled components must be between 0 and the size of the system");
  demand(y0.size() == static_cast<std::size_t>(system.size()),
         "the start state must have as many values as the system");
  demand(scales.size() >= static_cast<std::size_t>(controlled),
         "every controlled component needs an error scale");
  for (int i = 0; i < controlled; ++i) {
    if (scales[i] == 0.0 || !std::isfinite(scales[i])) {
      throw std::invalid_argument("the error scale of " + system.component_name(i) + " is " +
                                  text(scales[i]) + "; it must be finite and not 0");
    }
  }
  demand(std::isfinite(t0), "the start time must be finite");
  demand(control.maximum > 0.0 && !std::isnan(control.maximum),
         "the maximum step must be positive");
  demand(control.minimum >= 0.0 && control.minimum <= control.maximum,
         "the minimum step must be between 0 and the maximum step");
  demand(control.initial >= 0.0 && std::isfinite(control.initial),
         "the first step must be positive, or 0 to have it chosen");
  demand(control.tolerance > 0.0 && std::isfinite(control.tolerance),
         "the error tolerance must be positive and finite");
}

void error_weights(const OdeSystem& system, double tolerance, std::vector<double>& weights) {
  const auto scales = system.scales();
  std::fill(weights.begin(), weights.end(), 0.0);
  for (int i = 0; i < system.controlled_size(); ++i)
    weights[i] = 1.0 / (std::abs(scales[i]) * tolerance);
}

double longest_step(const OdeSystem& system, double t, const StepControl& control) {
  const double guard = system.step_guard(t);
  return std::max(control.minimum, guard < control.maximum ? guard : control.maximum);
}

double first_step(Evaluator& evaluate, double t0, const double* y0, const double* f0,
                  const double* weights, const StepControl& control, double* y, double* f) {
  const OdeSystem& system = evaluate.system();
  const double longest = longest_step(system, t0, control);
  const auto clamp = [&](double h) { return std::clamp(h, control.minimum, longest); };
  if (control.initial > 0.0) return clamp(control.initial);
  if (control.minimum == control.maximum) return control.maximum;

  const int n = system.size();
  const int nc = system.controlled_size();
  const double smallest = 16.0 * std::numeric_limits<double>::epsilon() * std::abs(t0);
  // In units of tol: velocity d1, acceleration d2. The probing step moves the state by 0.1
  // sqrt(tol) of its scale.
  const double d1 = weighted_maximum(f0, weights, nc);
  double probe = d1 > 0.0 ? 0.1 / (std::sqrt(control.tolerance) * d1) : 1e-6 * longest;
  if (!std::isfinite(probe)) probe = 1.0;
  probe = std::max(std::min(probe, longest), smallest);
  for (int attempt = 0; attempt < 12; ++attempt, probe *= 0.1) {
    for (int i = 0; i < n; ++i) y[i] = y0[i] + probe * f0[i];
    if (evaluate(t0 + probe, y, f) != Outcome::Ok) continue;
    double d2 = 0.0;
    for (int i = 0; i < nc; ++i) d2 = std::max(d2, std::abs(f[i] - f0[i]) * weights[i]);
    d2 /= probe;
    const double by_curvature = d2 > 0.0 ? std::sqrt(2.0 / d2) : 100.0 * probe;
    return clamp(std::max(std::min(by_curvature, 100.0 * probe), smallest));
  }
  return clamp(std::max(probe, smallest));
}

void throw_failure(const OdeSystem& system, const Diagnosis& d) {
  std::string message = std::string(d.method) + " cannot continue at t = " + text(d.t) +
                        " s with step " + text(d.h) + " s: " + d.cause;
  if (d.component >= 0) {
    message += "; the worst component is " + system.component_name(d.component) + " (number " +
               std::to_string(d.component) + ")";
  }
  throw StepFailure(message + ". " + d.remedy);
}

std::string cause_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::Retry:
      return "the model is not valid even within the smallest step";
    case Outcome::Fail:
      return "the right-hand side could not be evaluated";
    case Outcome::NotFinite:
      return "the state or its derivative is not finite";
    case Outcome::Ok:
      break;
  }
  return "the error stays above the tolerance";
}

std::string remedy_of(Outcome outcome) {
  if (outcome == Outcome::Fail)
    return "A smaller step does not help: check the model at this time.";
  return "Allow a smaller minimum step, or check the model and its start state at this time.";
}

}  // namespace adore::integrators
