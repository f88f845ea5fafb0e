#include "tribology/pocket_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::tribology {

double point_wedge_force(double viscosity, double speed, double along, double across, double gap) {
  constexpr double kMostConforming = 100.0;
  const double a = std::min(across / along, kMostConforming), side = 1.0 / (1.0 + 2.0 / (3.0 * a));
  return viscosity * speed * along * std::sqrt(128.0 * a * along / gap) * side *
         (0.131 * std::atan(0.5 * a) + 1.683);
}

double sphere_squeeze_force(double viscosity, double radius, double gap, double gap_rate) {
  return 6.0 * std::numbers::pi * viscosity * radius * radius * std::max(0.0, -gap_rate) / gap;
}

double line_wedge_force(double viscosity, double speed, double radius, double length, double gap) {
  return 4.896 * viscosity * speed * radius * length / gap;
}

double line_shear_force(double viscosity, double slip, double radius, double length, double gap) {
  return std::numbers::pi * std::numbers::sqrt2 * viscosity * slip * length *
         std::sqrt(radius / gap);
}

double cylinder_squeeze_force(double viscosity, double radius, double length, double gap,
                              double gap_rate) {
  const double ratio = radius / gap;
  return 3.0 * std::numbers::sqrt2 * std::numbers::pi * viscosity * length *
         std::max(0.0, -gap_rate) * ratio * std::sqrt(ratio);
}

}  // namespace adore::tribology
