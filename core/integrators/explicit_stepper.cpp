#include "integrators/explicit_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace adore::integrators {
namespace {

/// A contact that closes inside a step costs energy as h² to h³.
constexpr double kLossOrder = 3.0;
/// The step after one that lost this share of what it may is not longer.
constexpr double kNearlyTooMuch = 0.3;
/// A loss that is the same in this many shorter trials is not caused by the step length;
/// after this many such steps in a row the next ones are not checked.
constexpr int kStubborn = 3;
constexpr int kUnwatched = 50;

}  // namespace

void ExplicitStepper::attach(OdeSystem& system, double t0, std::span<const double> y0,
                             const StepControl& control) {
  check_start(system, t0, y0, control);
  counters_ = {};
  control_ = control;
  evaluate_.attach(system, counters_);
  size_ = system.size();
  width_ = padded(size_);
  t_ = t0;
  t_rounding_ = 0.0;
  failed_reduction_count_ = 0;
  for (auto* v : {&y_, &f_, &y_new_, &f_new_, &error_, &weights_}) v->assign(width_, 0.0);
  std::copy(y0.begin(), y0.end(), y_.begin());
  error_weights(system, control.tolerance, weights_);
  if (!all_finite(y_.data(), size_)) {
    evaluate_.set_invalid_component(worst_index(y_.data(), weights_.data(), size_));
    give_up(Outcome::NotFinite, 0.0);
  }
}

void ExplicitStepper::start(OdeSystem& system, double t0, std::span<const double> y0,
                            const StepControl& control) {
  attach(system, t0, y0, control);
  system.project(t_, y_.data());
  const Outcome outcome = evaluate_(t_, y_.data(), f_.data());
  if (outcome != Outcome::Ok) give_up(outcome, 0.0);
  kept_ = system.kept().value;
  h_next_ = first_step(evaluate_, t_, y_.data(), f_.data(), weights_.data(), control_,
                       y_new_.data(), f_new_.data());
  prepare();
}

Memory ExplicitStepper::memory() const {
  Memory out{{"next step", h_next_},
             {"time lost by rounding", t_rounding_},
             {"kept", kept_},
             {"steps watched in vain", failed_reduction_count_}};
  // Not computed anew: a method whose last stage is the derivative rounds it in its own way.
  for (int i = 0; i < size_; ++i) out["rate[" + std::to_string(i) + "]"] = f_[i];
  save(out);
  return out;
}

void ExplicitStepper::resume(OdeSystem& system, double t0, std::span<const double> y0,
                             const StepControl& control, const Memory& memory) {
  attach(system, t0, y0, control);
  t_rounding_ = memory.at("time lost by rounding");
  h_next_ = std::clamp(memory.at("next step"), control.minimum, control.maximum);
  for (int i = 0; i < size_; ++i) f_[i] = memory.at("rate[" + std::to_string(i) + "]");
  // Other loads or speeds than before: the past gives no information on what follows.
  double change = 0.0;
  const bool valid = evaluate_(t_, y_.data(), f_new_.data()) == Outcome::Ok;
  for (int i = 0; i < size_; ++i)
    change = std::max(change, std::abs(f_new_[i] - f_[i]) * weights_[i] * h_next_);
  if (!valid || change > 1e-3) {
    StepControl again = control;
    again.initial = h_next_;
    return start(system, t0, y0, again);
  }
  // Runs of before steps were judged by what they lose have no such memory: the account opens here.
  const auto kept = memory.find("kept"), patience = memory.find("steps watched in vain");
  kept_ = kept != memory.end() ? kept->second : system.kept().value;
  if (patience != memory.end())
    failed_reduction_count_ =
        static_cast<int>(std::clamp(patience->second, -1.0 * kUnwatched, 1.0 * kStubborn));
  prepare();
  restore(memory);
}

ExplicitStepper::Trial ExplicitStepper::try_step(double h, double t_new, bool accept_any_error) {
  Trial trial = attempt(h, t_new);
  if (trial.outcome != Outcome::Ok) return trial;
  if (!all_finite(y_new_.data(), size_)) {
    evaluate_.set_invalid_component(worst_index(y_new_.data(), weights_.data(), size_));
    return {Outcome::NotFinite, 0.0};
  }
  if (trial.error > 1.0 && !accept_any_error) return trial;
  const bool moved = evaluate_.system().project(t_new, y_new_.data());
  const double* known = moved ? nullptr : end_derivative();
  if (known) {
    std::copy(known, known + size_, f_new_.begin());
  } else {
    trial.outcome = evaluate_(t_new, y_new_.data(), f_new_.data());
  }
  if (trial.outcome == Outcome::Ok) trial.lost = lost(kept_new_);
  return trial;
}

double ExplicitStepper::lost(double& kept) noexcept {
  const OdeSystem::Kept now = evaluate_.system().kept();
  kept = now.value;
  const double change = std::abs(now.value - kept_);
  if (!(now.scale > 0.0) || change <= now.rounding) return 0.0;
  return change / (control_.tolerance * now.scale);
}

StepInfo ExplicitStepper::step(double t_stop) {
  if (!(t_stop > t_))
    throw std::invalid_argument("the stop time must be later than the current time");
  double planned = std::min(h_next_, longest_step(evaluate_.system(), t_, control_));
  double lost_before = 0.0, h_before = 0.0;  // of the last trial that lost too much
  double h_leaking = 0.0;                    // of the first one
  int stubborn = 0;                          // shorter trials that lost at the same rate
  for (int failures = 0;;) {
    const double left = t_stop - t_;
    const bool last = reaches(t_, planned, t_stop);
    double h = last ? left : planned;
    // Two equal steps to the stop time rather than a long one and a sliver.
    if (!last && !has_constant_step() && 2.0 * planned > left && 0.5 * left >= control_.minimum) {
      h = 0.5 * left;
    }
    const double lossless = h - t_rounding_;
    const double t_new = last ? t_stop : t_ + lossless;
    const bool smallest = h <= control_.minimum * (1.0 + 1e-6);

    const Trial trial = try_step(h, t_new, smallest);
    const bool good = trial.outcome == Outcome::Ok;
    bool leaks = false;
    if (good && trial.error <= 1.0 && trial.lost > 1.0 && !smallest &&
        failed_reduction_count_ >= 0) {
      const double shorter = h_before > 0.0 ? h / h_before : 1.0;
      if (h_before > 0.0)
        stubborn += trial.lost > lost_before * shorter * std::sqrt(shorter);
      else
        h_leaking = h;
      leaks = stubborn < kStubborn;
      lost_before = trial.lost;
      h_before = h;
    }
    if (good && !leaks && (trial.error <= 1.0 || smallest)) {
      const bool at_minimum = trial.error > 1.0;
      t_rounding_ = last ? 0.0 : (t_new - t_) - lossless;
      t_ = t_new;
      y_.swap(y_new_);
      f_.swap(f_new_);
      kept_ = kept_new_;
      ++counters_.steps;
      counters_.at_minimum += at_minimum;
      const double factor = growth(trial.error);
      accepted(h);
      const bool holds =
          failures > 0 || (trial.lost > kNearlyTooMuch && failed_reduction_count_ >= 0);
      double next = h * (holds ? std::min(factor, 1.0) : factor);
      if (h < planned) next = std::max(next, planned);  // only the stop time made it short
      if (stubborn == kStubborn) next = std::max(next, h_leaking);
      count_failed_reduction(stubborn == kStubborn);
      h_next_ = std::clamp(next, control_.minimum, control_.maximum);
      return {t_, h, h_next_, trial.error, at_minimum};
    }

    ++counters_.rejected;
    counters_.repeated_for_energy += leaks;
    rejected(++failures);
    if (trial.outcome == Outcome::Fail || (!good && smallest)) give_up(trial.outcome, h);
    const double factor =
        leaks  ? std::clamp(0.9 * std::pow(trial.lost, -1.0 / kLossOrder), 0.2, 0.8)
        : good ? std::clamp(0.9 * std::pow(trial.error, -1.0 / (order_ + 1)), 0.1, 0.9)
               : 0.25;
    planned = std::max(h * factor, control_.minimum);
    if (planned < 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t_) ||
        planned < std::numeric_limits<double>::min()) {
      give_up(trial.outcome, h);
    }
  }
}

void ExplicitStepper::count_failed_reduction(bool in_vain) noexcept {
  if (failed_reduction_count_ < 0)
    ++failed_reduction_count_;
  else
    failed_reduction_count_ = in_vain ? failed_reduction_count_ + 1 : 0;
  if (failed_reduction_count_ == kStubborn) failed_reduction_count_ = -kUnwatched;
}

void ExplicitStepper::give_up(Outcome outcome, double h) const {
  int component = -1;
  if (outcome == Outcome::NotFinite) component = evaluate_.invalid_component();
  if (outcome == Outcome::Ok) component = worst_index(error_.data(), weights_.data(), size_);
  throw_failure(evaluate_.system(),
                {name_, cause_of(outcome), remedy_of(outcome), t_, h, component});
}

}  // namespace adore::integrators
