#include "tribology/thermal_reduction.hpp"

#include <algorithm>
#include <cmath>

namespace adore::tribology {
namespace {

double sliding(double S) { return std::pow(S, 0.83); }

}  // namespace

double thermal_reduction_raw(double L, double S, double pressure_over_modulus) {
  return (1.0 - 13.2 * pressure_over_modulus * std::pow(L, 0.42)) /
         (1.0 + 0.213 * (1.0 + 2.23 * sliding(S)) * std::pow(L, 0.64));
}

double thermal_reduction(double L, double S, double pressure_over_modulus, double floor) {
  const double above = thermal_reduction_raw(L, S, pressure_over_modulus) - floor;
  const double width = 0.5 * floor;
  if (!(width > 0.0)) return floor + std::max(above, 0.0);
  const double inside = std::clamp(above, -width, width) + width;
  return floor + std::max(above - width, 0.0) + inside * inside / (4.0 * width);
}

double thermal_reduction_rolling(double L) { return 3.94 / (3.94 + std::pow(L, 0.62)); }

double thermal_reduction_sliding(double L, double S) {
  return 1.0 / (1.0 + 0.241 * (1.0 + 14.8 * sliding(S)) * std::pow(L, 0.64));
}

}  // namespace adore::tribology
