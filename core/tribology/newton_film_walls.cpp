#include "tribology/newton_film_walls.hpp"

#include "base/gauss.hpp"

#include <algorithm>
#include <cmath>

namespace adore::tribology {
namespace {

/// atanh(c u) where 1 - (c u)² = μ_m/μ_wall is known, without its cancellation near 1.
double half_logarithm(double cu, double middle, double wall) {
  constexpr double kSmall = 0.5;
  if (std::abs(cu) < kSmall) return std::atanh(cu);
  const double outside = 1.0 + std::abs(cu);
  return std::copysign(0.5 * std::log(outside * outside * (wall / middle)), cu);
}

}  // namespace

FilmShear film_shear_between_walls(double viscosity_a, double viscosity_b, double beta,
                                   double conductivity, double thickness, double slip) {
  FilmShear out;
  const double thicker = std::max(viscosity_a, viscosity_b);
  const double difference = 1.0 / viscosity_b - 1.0 / viscosity_a;
  // β (Tb - Ta) = ln(μ_a/μ_b)
  const double warmer = std::log(viscosity_a / viscosity_b);
  constexpr double kNoHeating = 1e-5;
  if (slip * std::sqrt(beta * thicker / (8.0 * conductivity)) < kNoHeating) {
    out.stress = slip / thickness * (difference != 0.0 ? warmer / difference : viscosity_a);
    const double conducted = beta > 0.0 ? conductivity * warmer / (beta * thickness) : 0.0;
    out.heat_a = 0.5 * out.stress * slip + conducted;
    out.heat_b = 0.5 * out.stress * slip - conducted;
    return out;
  }
  const double turning = 0.5 * slip + conductivity / (beta * slip) * difference;
  const double rest = slip - turning;
  const double middle = 1.0 / (1.0 / viscosity_a + beta * turning * turning / (2.0 * conductivity));
  const double c = std::sqrt(beta * middle / (2.0 * conductivity));
  out.stress = middle / (thickness * c) *
               (half_logarithm(c * rest, middle, viscosity_b) +
                half_logarithm(c * turning, middle, viscosity_a));
  out.heat_a = out.stress * turning;
  out.heat_b = out.stress * rest;
  if (difference == 0.0) out.hottest = std::log(viscosity_a / middle) / beta;
  return out;
}

FilmShear film_shear_any_viscosity(const std::function<double(double T)>& viscosity,
                                   double wall_temperature, double conductivity, double thickness,
                                   double slip) {
  const auto fluidity = [&](double from, double to) {
    double sum = 0.0;
    for (const GaussPoint& point : kGauss20)
      sum += point.weight / viscosity(0.5 * (from + to) + 0.5 * (to - from) * point.node);
    return 0.5 * (to - from) * sum;
  };
  FilmShear out;
  const double target = slip * slip / (8.0 * conductivity);
  constexpr double kHottest = 2000.0;
  constexpr int kHalvings = 60;
  double low = 0.0, high = kHottest;
  for (int i = 0; i < kHalvings; ++i) {
    const double rise = 0.5 * (low + high);
    (fluidity(wall_temperature, wall_temperature + rise) > target ? high : low) = rise;
  }
  const double rise = 0.5 * (low + high), top = wall_temperature + rise, end = std::sqrt(rise);
  out.hottest = rise;
  double sum = 0.0;
  for (const GaussPoint& point : kGauss20) {
    const double s = 0.5 * end * (1.0 + point.node);
    const double speed = std::sqrt(2.0 * conductivity * fluidity(top - s * s, top));
    sum += point.weight * 2.0 * s / speed;
  }
  out.stress = slip > 0.0 ? 2.0 / thickness * conductivity * 0.5 * end * sum : 0.0;
  constexpr double kColdRise = 1e-6;  // K: the quadrature has nothing to see
  if (rise < kColdRise) out.stress = viscosity(wall_temperature) * slip / thickness;
  out.heat_a = out.heat_b = 0.5 * out.stress * slip;
  return out;
}

}  // namespace adore::tribology
