#pragma once

#include "reference/adapter.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

/// Solves small initial-value problems for the reference scenarios with the library's own steppers.
namespace adore::reference {

using State = std::vector<double>;

struct Problem {
  /// dydt = f(t, y)
  std::function<void(double t, const double* y, double* dydt)> rates;
  State start;
  State scales;  ///< size of each component, its sign aside; the local error of a step is held
                 ///< below tolerance × scale. 0: nothing moves that component, any scale will do
  double tolerance = 1e-13;
  double longest_step = 0.0;  ///< [s]; 0: a tenth of the whole time
  const char* stepper = "rkf7";
  /// Functions whose sign changes are located to machine precision; the stepper restarts there, so
  /// that a rate with a kink or jump at an event is integrated piecewise.
  std::vector<std::function<double(double t, const double* y)>> events;
  /// Returns true to end the solution at this event.
  std::function<bool(int event, double t, const State& y)> at_event;
};

struct Event {
  int index = 0;  ///< which function
  double t = 0.0;
  bool rising = false;  ///< from negative to positive
  State y;
};

struct Solution {
  std::vector<State> samples;  ///< one per sample time (fewer when an event ended it)
  std::vector<Event> events;   ///< in time order
  [[nodiscard]] Json channel(int component) const;
  [[nodiscard]] Json vectors(int first) const;  ///< three components of every sample
  [[nodiscard]] Json times_of(int event, bool rising) const;
};

/// Sample times of a case: expected.t, else inputs.times. @throws InputError when there are none.
[[nodiscard]] std::vector<double> sample_times(const Json& the_case);

/// times.front() is the start time.
[[nodiscard]] Solution solve(const Problem& problem, std::span<const double> times);

}  // namespace adore::reference
