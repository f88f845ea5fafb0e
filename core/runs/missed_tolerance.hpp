#pragma once

#include "integrators/stepper.hpp"
#include "setup/run_control.hpp"

#include <string>

/// Steps taken at stpMin although their error estimate exceeds the tolerance: which part
/// of the specified accuracy the run still has.
///
/// The number of such steps says little: half of them may miss by a tenth. Decisive is the mean
/// error estimate of all steps over the tolerance, m: the run is about as accurate as one with m
/// tol. Ball bearing in a heated film under 70 kN, stpMin 0.005 (decision 480): 48 % missed, m =
/// 10, heat 0.02 % off; stpMin 0.02: 99 % missed, m = 89, heat 1.1 % off and a large energy
/// residual.
namespace adore::runs {

/// A run is not trusted when m is above the first and m tol above the second: far from the
/// specified accuracy, where loads may be some per cent off although the energy balance closes.
inline constexpr double kMissedTimes = 10.0, kMissedLimit = 1e-4;

struct MissedTolerance {
  bool trusted = true;
  std::string text;  ///< a sentence with the remedy; empty: no step missed it
};

/// @param error_sum of all steps, in tolerances. A run with a constant step (stpMin = stpMax) has
/// specified steps of any error: this is reported, and the run is trusted.
[[nodiscard]] MissedTolerance judge_missed_tolerance(const setup::RunControl& control,
                                                     const integrators::Counters& counters,
                                                     double error_sum);

}  // namespace adore::runs
