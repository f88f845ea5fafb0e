#include "facade/stiffness.hpp"

#include "statics/roller_statics.hpp"

namespace adore::facade {

std::vector<statics::StiffnessRow> stiffness_over_speed(const Prepared& prepared) {
  if (!prepared.control.stiffness) return {};
  const statics::StiffnessRequest& request = *prepared.control.stiffness;
  bearing::Bearing bearing = prepared.bearing;
  const auto solve = [&](const std::array<double, 2>& speed, const statics::RaceResult* previous) {
    bearing.speed = speed;
    bearing.constraints = prepared.bearing.constraints;
    if (previous != nullptr) bearing.constraints.displacement = previous->displacement;
    const auto settle = [&](auto options) {
      options.warm_start = previous != nullptr;
      options.difference_share = request.share;
      return options;
    };
    if (bearing.rollers)
      return static_cast<statics::RaceResult>(
          statics::solve_roller_statics(bearing, settle(statics::RollerOptions{})));
    return static_cast<statics::RaceResult>(
        statics::solve_ball_statics(bearing, settle(statics::StaticsOptions{})));
  };
  return statics::stiffness_table(request, solve);
}

}  // namespace adore::facade
