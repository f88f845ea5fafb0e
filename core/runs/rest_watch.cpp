#include "runs/rest_watch.hpp"

#include <algorithm>
#include <cmath>

namespace adore::runs {

RestDetector::RestDetector(const Prepared& prepared) {
  using scene::Effect;
  const auto& plan = prepared.plan;
  const bool varies = plan.has(Effect::RaceExcitation) || plan.has(Effect::FreeRaces) ||
                      plan.has(Effect::RaceBalance) || plan.has(Effect::TurningFrame) ||
                      plan.has(Effect::ThermalSteps) || plan.has(Effect::LightLoadBalance) ||
                      prepared.user;
  is_time_independent_ =
      !varies && prepared.bearing.speed[0] == 0.0 && prepared.bearing.speed[1] == 0.0;
}

double RestDetector::step(const integrators::Stepper& stepper, const integrators::OdeSystem& ode,
                          double tolerance, double usual, double most) const {
  if (!is_time_independent_) return 0.0;
  constexpr double kToleranceShare = 0.1;  // of the tolerance
  const std::span<const double> scale = ode.scales(), rate = stepper.derivative();
  double longest = most;
  for (std::size_t i = 0; i < scale.size(); ++i) {
    const double change = kToleranceShare * tolerance * scale[i];
    if (!(std::abs(rate[i]) * longest <= change)) longest = change / std::abs(rate[i]);
    if (!(longest > usual)) return 0.0;
  }
  return longest;
}

}  // namespace adore::runs
