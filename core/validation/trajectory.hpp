#pragma once

#include "integrators/stepper.hpp"
#include "validation/adapter.hpp"

#include <functional>
#include <span>
#include <utility>
#include <vector>

/// Solves the initial-value problems of the reference cases with the shipped steppers.
namespace adore::validation {

using State = std::vector<double>;

/// y' = f(y) of unit tests of the steppers.
class Rates final : public integrators::OdeSystem {
 public:
  Rates(State scales, std::function<void(const double* y, double* dydt)> rates)
      : scales_(std::move(scales)), rates_(std::move(rates)) {}
  [[nodiscard]] int size() const noexcept override { return static_cast<int>(scales_.size()); }
  [[nodiscard]] int controlled_size() const noexcept override { return size(); }
  [[nodiscard]] std::span<const double> scales() const noexcept override { return scales_; }
  integrators::EvalStatus rhs(double, const double* y, double* dydt) noexcept override {
    rates_(y, dydt);
    return integrators::EvalStatus::Ok;
  }

 private:
  State scales_;
  std::function<void(const double*, double*)> rates_;
};

struct Problem {
  integrators::OdeSystem& system;
  State start;
  double tolerance = 1e-13;   ///< of the local error over OdeSystem::scales()
  double longest_step = 0.0;  ///< [s]; 0: a tenth of the whole time
  const char* stepper = "rkf7";
  /// Functions whose sign changes are located to machine precision; the stepper restarts there, so
  /// that a rate with a kink or jump at an event is integrated piecewise.
  std::vector<std::function<double(double t, const double* y)>> events{};
  /// Returns true to end the solution at this event.
  std::function<bool(int event, double t, const State& y)> at_event{};
};

struct Event {
  int index = 0;  ///< which function
  double t = 0.0;
  bool rising = false;  ///< from negative to positive
  State y;
};

/// Work of the steppers. Of an explicit Runge-Kutta method
/// evaluations = start_evaluations + stages × steps + (stages - 1) × repeated_steps: the first
/// stage of a step that is repeated with another length is known.
struct StepperWork {
  long start_evaluations = 0, steps = 0, repeated_steps = 0, evaluations = 0;
  void add(const StepperWork& other) noexcept {
    start_evaluations += other.start_evaluations;
    steps += other.steps;
    repeated_steps += other.repeated_steps;
    evaluations += other.evaluations;
  }
};

struct Solution {
  std::vector<State> samples;  ///< one per sample time (fewer when an event ended it)
  std::vector<Event> events;   ///< in time order
  StepperWork work;
  [[nodiscard]] Json channel(int component, double factor = 1.0) const;
  [[nodiscard]] Json times_of(int event, bool rising) const;
};

/// Sample times of a case: expected.t, else inputs.times. @throws InputError when there are none.
[[nodiscard]] std::vector<double> sample_times(const Json& the_case);

/// times.front() is the start time.
[[nodiscard]] Solution solve(const Problem& problem, std::span<const double> times);

}  // namespace adore::validation
