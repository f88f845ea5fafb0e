#include "integrators/sundials_stepper.hpp"

#include <nvector/nvector_serial.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace adore::integrators {
namespace {

// A restart pays when the projected state has left the package's own by this many tolerances.
constexpr double kDriftLimit = 10.0;
// The tolerance of a minimum step is widened by ten at a time, to this at most.
constexpr double kWidest = 1e20;
// Newton's error over that of the step, and over the tolerance at least; what is forgotten of an
// error in each step; and, over the scales, what rounding may leave.
constexpr double kNewtonShare = 0.1, kLeastShare = 1e-4, kForget = 0.5, kRounding = 1e-12;

double maximum_norm(N_Vector values, N_Vector weights) {
  return weighted_maximum(N_VGetArrayPointer(values), N_VGetArrayPointer(weights),
                          static_cast<int>(N_VGetLength(values)));
}

SundialsStepper& stepper(void* self) { return *static_cast<SundialsStepper*>(self); }

}  // namespace

void SundialsStepper::start(OdeSystem& system, double t0, std::span<const double> y0,
                            const StepControl& control) {
  check_start(system, t0, y0, control);
  system_ = &system;
  control_ = control;
  counters_ = {};
  statistics_before_restart_ = {};
  evaluate_.attach(system, counters_);
  t_ = t0;
  tolerance_factor_ = 1.0;
  last_rhs_failure_ = Outcome::Ok;
  message_.clear();
  if (has_constant_step() && !can_hold_constant_step()) {
    throw_setup_failure(
        "this method cannot use a constant step",
        "Give a minimum step below the maximum step, or choose rkf1-rkf7, pece1-pece8 or arkode.");
  }
  const std::size_t n = system.size();
  state_.assign(y0.begin(), y0.end());
  for (auto* v :
       {&derivative_, &scratch_y_, &scratch_f_, &cached_state_, &cached_rhs_, &weights_}) {
    v->assign(n, 0.0);
  }
  has_cached_rhs_ = false;
  integrators::error_weights(system, control.tolerance, weights_);
  if (!all_finite(state_.data(), static_cast<int>(n))) {
    evaluate_.set_invalid_component(
        worst_index(state_.data(), weights_.data(), static_cast<int>(n)));
    last_rhs_failure_ = Outcome::NotFinite;
    give_up(AdvanceResult::Refused, 0.0);
  }
  system.project(t_, state_.data());
  last_rhs_failure_ = evaluate_(t_, state_.data(), derivative_.data());
  if (last_rhs_failure_ != Outcome::Ok) give_up(AdvanceResult::Refused, 0.0);
  derivative_is_current_ = true;

  if (!context_) {
    SUNContext context = nullptr;
    if (SUNContext_Create(nullptr, &context) != 0)
      throw_setup_failure("SUNDIALS could not be set up", "");
    context_.reset(context);
  }
  vector_.reset(N_VNew_Serial(static_cast<sunindextype>(n), context_.get()));
  vector_->ops->nvwrmsnorm = maximum_norm;
  error_.reset(N_VClone(vector_.get()));
  std::copy(state_.begin(), state_.end(), N_VGetArrayPointer(vector_.get()));
  initial_step_ = estimate_first_step();
  create();
  expected_error_ = 0.0;
  update_newton_tolerance(0.0);
}

double SundialsStepper::estimate_first_step() {
  return first_step(evaluate_, t_, state_.data(), derivative_.data(), weights_.data(), control_,
                    scratch_y_.data(), scratch_f_.data());
}

Memory SundialsStepper::memory() const {
  return {{"next step", std::clamp(counters_.steps == 0 ? initial_step_ : next_step(),
                                   control_.minimum, control_.maximum)}};
}

void SundialsStepper::resume(OdeSystem& system, double t0, std::span<const double> y0,
                             const StepControl& control, const Memory& memory) {
  StepControl again = control;
  again.initial = memory.at("next step");
  start(system, t0, y0, again);
}

StepInfo SundialsStepper::step(double t_stop) {
  if (!(t_stop > t_))
    throw std::invalid_argument("the stop time must be later than the current time");
  const double before = t_;
  // The package itself keeps to the longest step; a stop time is for what it cannot know. (A stop
  // time one longest step ahead, set anew for every step, makes it cut its steps in two.)
  const double longest = longest_step(*system_, t_, control_);
  const bool guarded = longest < control_.maximum && !reaches(t_, longest, t_stop);
  const double stop = guarded ? t_ + longest : t_stop;
  bool at_minimum = false;
  advance_or_throw(stop, at_minimum);
  ++counters_.steps;
  counters_.at_minimum += at_minimum;
  derivative_is_current_ = false;

  const double* y = N_VGetArrayPointer(vector_.get());
  const int n = system_->size();
  if (!all_finite(y, n)) {
    evaluate_.set_invalid_component(worst_index(y, weights_.data(), n));
    last_rhs_failure_ = Outcome::NotFinite;
    give_up(AdvanceResult::Refused, t_ - before);
  }
  StepInfo info{t_, t_ - before, 0.0, 0.0, at_minimum};
  if (local_error(error_.get())) {
    info.error = weighted_maximum(N_VGetArrayPointer(error_.get()), weights_.data(), n);
  }
  update_newton_tolerance(info.error);
  gather_statistics();
  std::copy(y, y + n, state_.begin());
  if (at_minimum) {  // the widened tolerance ends with this step
    tolerance_factor_ = 1.0;
    if (system_->project(t_, state_.data())) {
      std::copy(state_.begin(), state_.end(), N_VGetArrayPointer(vector_.get()));
    }
    begin_afresh(control_.minimum);
  } else {
    project_accepted_state();
  }
  info.h_next = std::clamp(next_step(), control_.minimum, control_.maximum);
  return info;
}

// The packages stop where the methods of this program continue; each case is resumed from the last
// state: an error above the tolerance at the minimum step, with a wider tolerance; a point that the
// model rejected, with a smaller step (ARKODE does not even try one for an explicit stage).
void SundialsStepper::advance_or_throw(double t_stop, bool& at_minimum) {
  const double before = t_;
  const double resolution = 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t_);
  double h = std::min(counters_.steps == 0 ? initial_step_ : next_step(), t_stop - t_);
  for (int attempt = 0;; ++attempt) {
    last_rhs_failure_ = Outcome::Ok;
    const AdvanceResult result = advance(t_stop);
    if (result == AdvanceResult::Done) {
      if (t_ - before > resolution || t_ == t_stop) return;
      give_up(AdvanceResult::Refused, t_ - before);
    }
    t_ = before;
    gather_statistics();
    const bool refused =
        last_rhs_failure_ == Outcome::Retry || last_rhs_failure_ == Outcome::NotFinite;
    if (has_constant_step()) {
      give_up(result, h);
    } else if (result == AdvanceResult::Refused && refused) {
      if (h <= control_.minimum || 0.25 * h <= resolution) give_up(result, h);
      h = std::max(0.25 * h, control_.minimum);
    } else if ((result == AdvanceResult::ErrorTooLarge || result == AdvanceResult::NotConverged) &&
               control_.minimum > 0.0 && tolerance_factor_ < kWidest) {
      // First with the tolerance as it is: the package may have given up at a longer step.
      if (attempt > 0) tolerance_factor_ *= 10.0;
      h = std::min(control_.minimum, t_stop - t_);
    } else {
      give_up(result, h);
    }
    at_minimum = tolerance_factor_ > 1.0;
    std::copy(state_.begin(), state_.end(), N_VGetArrayPointer(vector_.get()));
    begin_afresh(h);
  }
}

void SundialsStepper::begin_afresh(double h) {
  const Statistics now = statistics();
  statistics_before_restart_.rejected += now.rejected;
  statistics_before_restart_.nonlinear_iterations += now.nonlinear_iterations;
  ++counters_.restarts;
  restart(h);
}

// The package continues with its state and returns the projected one, until they differ by a
// few tolerances.
void SundialsStepper::project_accepted_state() {
  if (has_own_projection() || !system_->project(t_, state_.data())) return;
  double* y = N_VGetArrayPointer(vector_.get());
  double drift = 0.0;
  for (std::size_t i = 0; i < state_.size(); ++i) {
    drift = std::max(drift, std::abs(state_[i] - y[i]) * weights_[i]);
  }
  if (drift <= kDriftLimit) return;
  std::copy(state_.begin(), state_.end(), y);
  static_cast<void>(derivative());
  if (!derivative_is_current_)
    return;  // the model rejects the projected point: keep the package's state
  begin_afresh(std::min(estimate_first_step(), next_step()));
}

// The remaining error of Newton's iteration is not reliably seen by an estimate: it is kept below a
// tenth of the estimate of the steps so far, above rounding. A step without an estimate (ARKODE at
// a constant step) counts as one without an error.
void SundialsStepper::update_newton_tolerance(double error) {
  expected_error_ = std::max(error, kForget * expected_error_);
  const double least = std::max(kLeastShare, kRounding / control_.tolerance);
  set_newton_tolerance(
      std::clamp(kNewtonShare * expected_error_, std::min(least, kNewtonShare), kNewtonShare));
}

void SundialsStepper::gather_statistics() {
  const Statistics now = statistics();
  counters_.rejected = statistics_before_restart_.rejected + now.rejected;
  counters_.nonlinear_iterations =
      statistics_before_restart_.nonlinear_iterations + now.nonlinear_iterations;
}

std::span<const double> SundialsStepper::derivative() const noexcept {
  if (!derivative_is_current_ && evaluate_(t_, state_.data(), derivative_.data()) == Outcome::Ok) {
    derivative_is_current_ = true;
  }
  return derivative_;
}

int SundialsStepper::report(Outcome outcome) noexcept {
  if (outcome == Outcome::Ok) return 0;
  last_rhs_failure_ = outcome;
  return outcome == Outcome::Fail ? -1 : 1;
}

int SundialsStepper::full_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept {
  auto& me = stepper(self);
  if (me.last_rhs_failure_ == Outcome::Fail)
    return -1;  // CVODE's fixed-point iteration would try again
  return me.report(me.evaluate_(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dydt)));
}

int SundialsStepper::update_cached_rhs(double t, const double* y) noexcept {
  if (has_cached_rhs_ && cached_time_ == t &&
      std::equal(cached_state_.begin(), cached_state_.end(), y))
    return 0;
  has_cached_rhs_ = false;
  if (last_rhs_failure_ == Outcome::Fail) return -1;
  std::copy_n(y, cached_state_.size(), cached_state_.begin());
  const int status = report(evaluate_(t, y, cached_rhs_.data()));
  cached_time_ = t;
  has_cached_rhs_ = status == 0;
  return status;
}

int SundialsStepper::cached_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept {
  auto& me = stepper(self);
  const int status = me.update_cached_rhs(t, N_VGetArrayPointer(y));
  if (status == 0)
    std::copy(me.cached_rhs_.begin(), me.cached_rhs_.end(), N_VGetArrayPointer(dydt));
  return status;
}

int SundialsStepper::controlled_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept {
  const int status = cached_rhs(t, y, dydt, self);
  double* out = N_VGetArrayPointer(dydt);
  const OdeSystem& system = *stepper(self).system_;
  std::fill(out + system.controlled_size(), out + system.size(), 0.0);
  return status;
}

int SundialsStepper::quadrature_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept {
  const int status = cached_rhs(t, y, dydt, self);
  std::fill_n(N_VGetArrayPointer(dydt), stepper(self).system_->controlled_size(), 0.0);
  return status;
}

int SundialsStepper::stiff_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept {
  auto& me = stepper(self);
  double* out = N_VGetArrayPointer(dydt);
  switch (me.system_->rhs_stiff(t, N_VGetArrayPointer(y), out)) {
    case EvalStatus::Retry:
      return me.report(Outcome::Retry);
    case EvalStatus::Fail:
      return me.report(Outcome::Fail);
    case EvalStatus::Ok:
      break;
  }
  const int controlled = me.system_->controlled_size();
  std::fill(out + controlled, out + me.system_->size(), 0.0);  // quadratures go with the rest
  if (all_finite(out, controlled)) return 0;
  me.evaluate_.set_invalid_component(worst_index(out, me.weights_.data(), controlled));
  return me.report(Outcome::NotFinite);
}

int SundialsStepper::nonstiff_rhs(double t, N_Vector y, N_Vector dydt, void* self) noexcept {
  auto& me = stepper(self);
  if (const int status = me.update_cached_rhs(t, N_VGetArrayPointer(y)); status != 0) return status;
  if (const int status = stiff_rhs(t, y, dydt, self); status != 0) return status;
  double* out = N_VGetArrayPointer(dydt);
  for (std::size_t i = 0; i < me.cached_rhs_.size(); ++i) out[i] = me.cached_rhs_[i] - out[i];
  return 0;
}

int SundialsStepper::error_weights(N_Vector, N_Vector weights, void* self) noexcept {
  const auto& me = stepper(self);
  double* w = N_VGetArrayPointer(weights);
  for (std::size_t i = 0; i < me.weights_.size(); ++i) w[i] = me.weights_[i] / me.tolerance_factor_;
  return 0;
}

int SundialsStepper::project_vector(double t, N_Vector y, void* self) noexcept {
  stepper(self).system_->project(t, N_VGetArrayPointer(y));
  return 0;
}

void SundialsStepper::keep_message(int, const char*, const char*, char* message,
                                   void* self) noexcept {
  stepper(self).message_ = message;
}

void SundialsStepper::check(int status, std::string_view call) const {
  if (status != 0) {
    throw_setup_failure(std::string(call) + " returned " + std::to_string(status) +
                            (message_.empty() ? std::string() : " (" + message_ + ")"),
                        "Choose another integrator.");
  }
}

void SundialsStepper::throw_setup_failure(std::string cause, std::string remedy) const {
  throw_failure(*system_, {name_, std::move(cause), std::move(remedy), t_, control_.maximum, -1});
}

void SundialsStepper::give_up(AdvanceResult advance, double h) const {
  Diagnosis d{name_, cause_of(last_rhs_failure_), remedy_of(last_rhs_failure_), t_, h, -1};
  if (last_rhs_failure_ == Outcome::NotFinite) {
    d.component = evaluate_.invalid_component();
  } else if (last_rhs_failure_ == Outcome::Ok && advance == AdvanceResult::ErrorTooLarge) {
    d.component = worst_index(N_VGetArrayPointer(error_.get()), weights_.data(), system_->size());
  } else if (last_rhs_failure_ == Outcome::Ok && advance == AdvanceResult::NotConverged) {
    d.cause = "the implicit equations of the step did not converge";
    d.remedy = "Allow a smaller minimum step, or choose an explicit method.";
  } else if (last_rhs_failure_ == Outcome::Ok) {
    d.cause = message_.empty() ? "the SUNDIALS library stopped without a message" : message_;
  }
  throw_failure(*system_, d);
}

}  // namespace adore::integrators
