#include "statics/cage_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace adore::statics {

double CageOrbit::follow(const std::vector<double>& push, const StaticSolution& solution) {
  double moment = 0.0, radius = 0.0;
  for (std::size_t k = 0; k < push.size(); ++k) {
    radius = std::max(radius, solution.balls[k].r);
    moment += push[k] * solution.balls[k].r;
  }
  const double size = moment / (solution.max_load * radius);
  constexpr double kFirstOrbitStep = 1e-5, kMaxOrbitStep = 1e-2;  // over the orbit
  double step = kFirstOrbitStep * orbit_;
  if (last_step_ != 0.0 && size != last_) step = -size * last_step_ / (size - last_);
  step = std::clamp(step, -kMaxOrbitStep * std::abs(orbit_), kMaxOrbitStep * std::abs(orbit_));
  last_ = size;
  last_step_ = step;
  orbit_ += step;
  return std::abs(size);
}

std::optional<CageOrbit> cage_orbit(const bearing::Bearing& bearing,
                                    const std::vector<BallMotion>& balls,
                                    const StaticSolution& solution) {
  if (!bearing.cage) return std::nullopt;
  const double clearance = bearing.cage->pocket_clearance_1;
  double load = 0.0, heaviest = 0.0, mean = 0.0, radius = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    radius += solution.balls[k].r / static_cast<double>(balls.size());
    if (!balls[k].balanced) continue;
    if (solution.balls[k].Q[1] > load) {
      load = solution.balls[k].Q[1];
      heaviest = balls[k].orbit;
    }
    mean += balls[k].orbit;
    ++count;
  }
  if (count < 2 || heaviest == 0.0) return std::nullopt;
  mean /= count;
  // With one radius the departures add up to nothing around the bearing, so that the variation does
  // not depend on the ball that is counted first.
  std::vector<double> departure(balls.size(), 0.0);
  double place = 0.0, least = 0.0, most = 0.0;  // ahead of the cage [m]
  for (std::size_t k = 0; k < balls.size(); ++k) {
    if (balls[k].balanced) departure[k] = balls[k].orbit - mean;
    place += departure[k] / heaviest * 2.0 * std::numbers::pi / static_cast<double>(balls.size()) *
             radius;
    least = std::min(least, place);
    most = std::max(most, place);
  }
  if (!(most - least > clearance)) return std::nullopt;
  const double share = std::max(0.0, clearance / (most - least));
  for (double& of_ball : departure) of_ball *= share;
  return CageOrbit(heaviest - share * (heaviest - mean), std::move(departure));
}

}  // namespace adore::statics
