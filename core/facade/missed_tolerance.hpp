#pragma once

#include "integrators/stepper.hpp"
#include "setup/run_control.hpp"

#include <string>

/// Steps that were taken at stpMin although their error estimate lies above the tolerance: how much
/// of what was asked for the run still keeps.
///
/// How many they are tells little: half of them may miss by a tenth. What counts is the mean
/// error estimate of all steps over the tolerance, m: the run is about what one of m tol would be.
/// Ball bearing in a heated film under 70 kN, stpMin 0.005 (decision 480): 48 % missed, m = 10,
/// heat 0.02 % off; stpMin 0.02: 99 % missed, m = 89, heat 1.1 % off and its energy without
/// account.
namespace adore::facade {

/// A run is not trusted when m is above the first and m tol above the second: far from what was
/// asked for, and where loads may be some per cent off although the energy closes.
inline constexpr double kMissedTimes = 10.0, kMissedLimit = 1e-4;

struct MissedTolerance {
  bool trusted = true;
  std::string text;  ///< a sentence with the remedy; empty: no step missed it
};

/// @param error_sum of all steps, in tolerances. A run with a constant step (stpMin = stpMax) has
/// asked for steps of any error: it is told, and trusted.
[[nodiscard]] MissedTolerance judge_missed(const setup::RunControl& control,
                                           const integrators::Counters& counters, double error_sum);

}  // namespace adore::facade
