#include "runs/judge_steps.hpp"

#include "dynamics/scene_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::runs {
namespace {

void widen(VibrationBand& band, double frequency, double damping) {
  if (!(frequency > 0.0)) return;
  band.damping = std::max(band.damping, damping * kVibrationMargin);
  band.lowest = band.highest > 0.0 ? std::min(band.lowest, frequency) : frequency;
  band.highest = std::max(band.highest, frequency * kVibrationMargin);
}

/// Between undamped and the most damped vibration of a band.
constexpr int kDampingSteps = 4;

std::vector<VibrationBand> bands_of(const Prepared& prepared, double time_scale) {
  // Elements in force balance do not vibrate along their contacts; rollers still tilt on them.
  const bool balanced = prepared.plan.has(scene::Effect::ElementBalance);
  if (balanced && prepared.bearing.rollers() == nullptr) return {};
  VibrationBand along{"elements along the contact normal"},
      across{"elements across the contact normal"};
  for (const auto& ball : dynamics::ball_vibrations(prepared.plan, prepared.bearing,
                                                    prepared.options.system, prepared.start)) {
    if (!balanced) widen(along, ball.along, ball.along_damping);
    widen(across, ball.across, ball.across_damping);
  }
  if (!balanced && !(along.highest > 0.0)) widen(along, 1.0 / time_scale, 0.0);
  std::vector<VibrationBand> out;
  for (const VibrationBand& band : {along, across}) {
    if (!(band.highest > 0.0)) continue;
    // Elements that are hardly loaded are hardly damped.
    const int steps = band.damping > 0.0 ? kDampingSteps : 0;
    for (int k = 0; k <= steps; ++k) {
      out.push_back(band);
      out.back().damping = k == 0 ? 0.0 : band.damping * k / steps;
      if (k > 0) out.back().name += fmt::format(", damping ratio {:.2g}", out.back().damping);
    }
  }
  return out;
}

}  // namespace

StepJudgment judge_steps(const Prepared& prepared, double time_scale) {
  const setup::RunControl& control = prepared.control;
  StepJudgment out;
  out.request.method = control.integrator;
  out.request.minimum = control.step_minimum * time_scale;
  out.request.maximum = control.step_maximum * time_scale;
  const double speed = std::abs(prepared.bearing.speed[1] - prepared.bearing.speed[0]);
  out.request.turn = speed > 0.0 ? 2.0 * std::numbers::pi / speed : control.end_time * time_scale;
  out.request.bands = bands_of(prepared, time_scale);
  out.limits = stable_step_limits(out.request);
  out.text = step_limits_text(out.request, out.limits, time_scale);
  if (out.limits.action == StepAction::Refused) {
    // It splits off the free motion of balls (ready_run.cpp).
    const scene::ScenePlan& plan = prepared.plan;
    const bool splits =
        !plan.rollers && !(plan.light_load_ratio > 0.0) && !plan.has(scene::Effect::ElementBalance);
    std::string others;
    for (const std::string& name : find_stable_methods(out.request))
      if (splits || name != "arkode-imex") others += (others.empty() ? "" : ", ") + name;
    out.text +=
        fmt::format(". {} cannot be used for this deck. {}", out.request.method,
                    others.empty() ? "Decrease stpMax on record 2.1"
                                   : fmt::format("Integrators that allow these steps: {}", others));
  }
  return out;
}

}  // namespace adore::runs
