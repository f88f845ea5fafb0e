#pragma once

#include "runs/prepare.hpp"
#include "runs/step_limits.hpp"

#include <string>

/// The deck's integrator and step sizes against the contact vibrations of its bearing.
namespace adore::runs {

struct StepJudgment {
  StepRequest request;
  StepLimits limits;
  std::string text;  ///< step_limits_text(); with the methods that need no change when refused
};

/// Bands: both vibrations of every ball between its races (dynamics::ball_vibrations) at the start
/// of the run, widened by kVibrationMargin; without a loaded contact, the one that the time scale
/// stands for. In modes 1 and 2 only the tilting of rollers is left. Growth counts over a turn of
/// inner against outer race, or the deck's whole run when the races do not turn against each other.
/// @param time_scale unit of the deck's step sizes [s]
[[nodiscard]] StepJudgment judge_steps(const Prepared& prepared, double time_scale);

/// Loads on the way differ from those of the quasi-static solution; the frequency follows the load
/// to the power 1/6, so 5 % allow for a third more.
inline constexpr double kVibrationMargin = 1.05;

}  // namespace adore::runs
