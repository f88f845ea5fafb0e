#pragma once

#include "bearing/bearing.hpp"
#include "statics/ball_statics.hpp"
#include "statics/friction_balance.hpp"

#include <optional>
#include <vector>

/// Orbit of balls that their cage carries (ball_friction.hpp). SI.
namespace adore::statics {

/// Balls that their cage carries along. Its pockets let the angle of a ball vary by their clearance
/// only, so that its speed departs from that of the cage by a share of what it does alone. The
/// cage orbits where it pushes the balls with no moment in sum.
class CageOrbit {
 public:
  CageOrbit(double orbit, std::vector<double> departure)
      : orbit_(orbit), speed_deviations_(std::move(departure)) {}
  [[nodiscard]] double of(std::size_t k) const { return orbit_ + speed_deviations_[k]; }

  /// Secant step of the cage. @return its moment over the largest load and the orbit's radius
  double follow(const std::vector<double>& push, const StaticSolution& solution);

 private:
  double orbit_, last_ = 0.0, last_step_ = 0.0;
  std::vector<double> speed_deviations_;
};

/// Of balls in balance; empty: no cage, or its pockets let each of them orbit alone.
[[nodiscard]] std::optional<CageOrbit> cage_orbit(const bearing::Bearing& bearing,
                                                  const std::vector<BallMotion>& balls,
                                                  const StaticSolution& solution);

}  // namespace adore::statics
