#include "runs/missed_tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::runs {

MissedTolerance judge_missed_tolerance(const setup::RunControl& control,
                                       const integrators::Counters& counters, double error_sum) {
  MissedTolerance out;
  if (counters.at_minimum <= 0) return out;
  const auto steps = static_cast<double>(std::max(1L, counters.steps));
  const double mean = error_sum / steps;
  const bool constant = control.step_minimum == control.step_maximum;
  out.trusted = constant || mean <= kMissedTimes || mean * control.tolerance <= kMissedLimit;
  out.text = fmt::format(
      "{} of {} steps ({:.2g} %) missed the tolerance of {:g}: the smallest step of record 2.1 "
      "(stpMin) is too long. The mean error of all steps is {:.2g} times the tolerance",
      counters.at_minimum, counters.steps, 100.0 * static_cast<double>(counters.at_minimum) / steps,
      control.tolerance, mean);
  if (mean > 1.0)
    out.text += fmt::format(": the results are about as accurate as with tol = {:.1g}",
                            mean * control.tolerance);
  out.text += out.trusted ? "; decrease stpMin, or increase tol"
                          : ". The results of this run cannot be trusted. Decrease stpMin; if that "
                            "takes too long, try an implicit method (arkode-dirk, cvode-bdf)";
  return out;
}

}  // namespace adore::runs
