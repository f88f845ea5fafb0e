#include "life/minimum_load.hpp"

#include <algorithm>
#include <cmath>

namespace adore::life {
namespace {

constexpr double kKilonewton = 1e3;

double size_square(double mean_mm) { return std::pow(mean_mm / 100.0, 2.0); }

}  // namespace

double minimum_load_of_balls(double kr, double viscosity, double rpm, double mean_mm) {
  return kKilonewton * kr * std::pow(viscosity * rpm / 1000.0, 2.0 / 3.0) * size_square(mean_mm);
}

double minimum_load_of_rollers(double kr, double speed_ratio, double mean_mm) {
  return kKilonewton * kr * (6.0 + 4.0 * speed_ratio) * size_square(mean_mm);
}

double minimum_load_of_spherical_rollers(double static_rating, double speed_ratio) {
  constexpr double kThresholdSpeedRatio = 0.3, kRatingShare = 0.003;
  return kRatingShare * static_rating *
         (1.0 + 2.0 * std::sqrt(std::max(speed_ratio - kThresholdSpeedRatio, 0.0)));
}

double minimum_thrust(double A, double rpm, double static_rating) {
  return 0.0005 * static_rating + kKilonewton * A * std::pow(rpm / 1000.0, 2.0);
}

}  // namespace adore::life
