#include "life/capacity.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace adore::life {
namespace {

/// D/d_m, for any angle.
double size_ratio(const CapacityGeometry& g) { return g.gamma / g.cos_alpha; }

void check(const CapacityGeometry& g) {
  const auto positive = [](double value, const char* name) {
    if (!(value > 0.0))
      throw InputError(
          fmt::format("load capacity of a race: {} is {}; it must be above 0", name, value));
  };
  positive(g.diameter, "the diameter of the rolling element");
  positive(static_cast<double>(g.count), "the number of rolling elements");
  if (const double ratio = size_ratio(g); !(ratio > 0.0 && ratio < 1.0))
    throw InputError(
        fmt::format("load capacity of a race: the ratio D/d_m is {} (D cos(alpha)/d_m = {}, "
                    "cos(alpha) = {}); it must be between 0 and 1",
                    ratio, g.gamma, g.cos_alpha));
}

/// ∓γ: minus on the inner race.
double signed_gamma(const CapacityGeometry& g) { return g.inner ? g.gamma : -g.gamma; }

}  // namespace

double point_capacity(const CapacityGeometry& g, double factor) {
  check(g);
  if (!(g.profile_radius > 0.0 && g.groove_radius > g.profile_radius))
    throw InputError(
        fmt::format("load capacity of a race: the groove radius {} m must be larger than the "
                    "transverse radius {} m of the rolling element",
                    g.groove_radius, g.profile_radius));
  const double embrace =
      std::isfinite(g.groove_radius) ? g.groove_radius / (g.groove_radius - g.profile_radius) : 1.0;
  const double conformity = 2.0 * g.profile_radius / g.diameter * embrace;
  const double s = signed_gamma(g);
  return factor * constants().point_constant.value * std::pow(conformity, 0.41) *
         std::pow(1.0 - s, 1.39) / std::cbrt(1.0 + s) * std::pow(size_ratio(g), 0.3) *
         std::pow(1e3 * g.diameter, 1.8) / std::cbrt(static_cast<double>(g.count));
}

double line_capacity(const CapacityGeometry& g, double factor) {
  check(g);
  if (!(g.length > 0.0))
    throw InputError(fmt::format(
        "load capacity of a race: the effective length is {} m; it must be above 0", g.length));
  const double s = signed_gamma(g);
  return factor * constants().line_constant.value * std::pow(1.0 - s, 29.0 / 27.0) /
         std::pow(1.0 + s, 0.25) * std::pow(size_ratio(g), 2.0 / 9.0) *
         std::pow(1e3 * g.diameter, 29.0 / 27.0) * std::pow(1e3 * g.length, 7.0 / 9.0) *
         std::pow(static_cast<double>(g.count), -0.25);
}

double lundberg_palmgren_life(double capacity, double load, bool line) {
  if (!(load > 0.0)) return std::numeric_limits<double>::infinity();
  return std::pow(capacity / load, line ? 4.0 : 3.0);
}

}  // namespace adore::life
