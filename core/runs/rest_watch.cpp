#include "runs/rest_watch.hpp"

#include "dynamics/rest_equilibrium.hpp"

#include <algorithm>
#include <cmath>

namespace adore::runs {
namespace {

/// Films of a cage and drag of the medium resist a motion, but do not stop it.
bool does_friction_hold(const Prepared& prepared) {
  using scene::Effect;
  const auto& plan = prepared.plan;
  return plan.has(Effect::RaceTraction) && !plan.has(Effect::PocketFilm) &&
         !plan.has(Effect::LandFilm) && !plan.has(Effect::ElementDrag) &&
         !plan.has(Effect::CageDrag);
}

}  // namespace

bool is_time_independent(const Prepared& prepared) {
  using scene::Effect;
  const auto& plan = prepared.plan;
  const bool varies = plan.race_motions.has_excitation() || plan.has(Effect::FreeRaces) ||
                      plan.has(Effect::RaceBalance) || plan.has(Effect::TurningFrame) ||
                      plan.has(Effect::ThermalSteps) || plan.has(Effect::LightLoadBalance) ||
                      prepared.user;
  return !varies && prepared.bearing.speed[0] == 0.0 && prepared.bearing.speed[1] == 0.0;
}

bool may_start_at_rest(const Prepared& prepared) {
  if (!is_time_independent(prepared) || prepared.plan.has(scene::Effect::ElementBalance) ||
      !prepared.plan.has(scene::Effect::RaceTraction))
    return false;
  const auto option = prepared.input.option_values.find("startAtRest");
  return option == prepared.input.option_values.end() || option->second != "off";
}

bool start_at_rest(const Prepared& prepared, dynamics::System& system, std::vector<double>& y) {
  constexpr int kMaxSteps = 300;
  return dynamics::find_rest(system, y, {kMaxSteps, does_friction_hold(prepared)}).found;
}

RestDetector::RestDetector(const Prepared& prepared)
    : is_time_independent_(is_time_independent(prepared)),
      friction_holds_(does_friction_hold(prepared)) {}

void RestDetector::examine(dynamics::System& system, std::span<const double> y) {
  if (!is_time_independent_) return;
  const dynamics::StateLayout& layout = system.layout();
  const auto controlled = static_cast<std::size_t>(layout.controlled_size());
  position_scale_.assign(controlled, 0.0);
  for (const auto& group : layout.groups()) {
    const double scale = group.unit == "m/s"     ? system.scales().length
                         : group.unit == "rad/s" ? 1.0
                                                 : 0.0;
    for (int k = group.slice.first; k < group.slice.first + group.slice.count; ++k)
      if (static_cast<std::size_t>(k) < controlled)
        position_scale_[static_cast<std::size_t>(k)] = scale;
  }
  std::vector<double> state(y.begin(), y.end());
  rest_position_.clear();
  if (dynamics::find_rest(system, state, {0, friction_holds_}).found)
    rest_position_.assign(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(controlled));
}

bool RestDetector::is_rest_position(std::span<const double> y,
                                    std::span<const double> scales) const {
  constexpr double kRounding = 1e-12;  // of normalized quaternions
  if (rest_position_.empty()) return false;
  for (std::size_t i = 0; i < rest_position_.size(); ++i)
    if (!(std::abs(y[i] - rest_position_[i]) <= kRounding * scales[i])) return false;
  return true;
}

double RestDetector::step(const integrators::Stepper& stepper, const integrators::OdeSystem& ode,
                          double tolerance, double usual, double most, double end) const {
  if (!is_time_independent_) return 0.0;
  if (is_rest_position(stepper.state(), ode.scales())) return std::max(most, usual);
  const double left = end - stepper.time();
  if (!(most > usual) || !(left >= most)) return 0.0;
  constexpr double kToleranceShare = 0.1;  // of the tolerance
  const double allowed = kToleranceShare * tolerance;
  const std::span<const double> scale = ode.scales(), rate = stepper.derivative();
  for (std::size_t i = 0; i < scale.size(); ++i) {
    const double change = std::abs(rate[i]) * left;
    if (!(change <= allowed * scale[i])) return 0.0;
    if (position_scale_[i] > 0.0 && !(0.5 * change * left <= allowed * position_scale_[i]))
      return 0.0;
  }
  return most;
}

}  // namespace adore::runs
