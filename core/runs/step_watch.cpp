#include "runs/step_watch.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <vector>

namespace adore::runs {
namespace {

constexpr long kMaxMissedSteps = 10000;  ///< steps

}  // namespace

void StepErrorMonitor::check(const integrators::Stepper& stepper) {
  const integrators::Counters& now = stepper.counters();
  if (now.steps - now.at_minimum != steps_within_tolerance_ || now.steps < last_good_step_) {
    steps_within_tolerance_ = now.steps - now.at_minimum;
    last_good_step_ = now.steps;
  }
  if (is_step_constant_ || now.steps - last_good_step_ < kMaxMissedSteps) return;
  throw SolverError(fmt::format(
      "at t = {:.9g} s: each of the last {} steps of {} missed the tolerance of {:g}, although "
      "each had the smallest size that record 2.1 allows (stpMin {:g}, {:.3g} s). The error is "
      "therefore unknown. A process decays or vibrates faster than this step, often an oil film or "
      "a friction law with a steep slope at high pressure. Decrease stpMin; if that takes too "
      "long, try an implicit method (arkode-dirk, cvode-bdf) or a less steep friction law",
      stepper.time(), now.steps - last_good_step_, control_.integrator, control_.tolerance,
      control_.step_minimum, minimum_step_));
}

std::string invalid_state_message(dynamics::System& system, double t, std::span<const double> y,
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

}  // namespace adore::runs
