#include "life/factors.hpp"

#include "base/errors.hpp"
#include "life/constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::life {
namespace {

/// Half the complementary error function of x/√2: share of a normal distribution beyond x.
double upper_tail(double x) { return 0.5 * std::erfc(x / std::numbers::sqrt2); }

}  // namespace

double hardness_factor(double rockwell_c) { return std::exp(0.1 * (rockwell_c - 60.0)); }

double film_factor(double film_parameter) {
  if (!(film_parameter > 0.0))
    throw InputError(
        fmt::format("film factor: the film parameter is {}; it must be above 0", film_parameter));
  const auto& table = constants().film_table;
  if (film_parameter <= table.front().first) return table.front().second;
  if (film_parameter >= table.back().first) return table.back().second;
  const auto high = std::upper_bound(table.begin(), table.end(), film_parameter,
                                     [](double x, const auto& row) { return x < row.first; });
  const auto low = high - 1;
  const double t = std::log(film_parameter / low->first) / std::log(high->first / low->first);
  return low->second * std::pow(high->second / low->second, t);
}

double filter_factor(double micrometres) {
  if (!(micrometres > 0.0))
    throw InputError(
        fmt::format("filter factor: the filter rating is {} µm; it must be above 0", micrometres));
  return 1.8 * std::pow(micrometres, -0.25);
}

std::optional<double> residual_stress_factor(double max_shear, double compressive,
                                             double exponent) {
  const double rest = max_shear - 0.5 * compressive;
  if (!(rest > 0.0)) return std::nullopt;
  return std::pow(max_shear / rest, exponent);
}

StleResult stle_factor(const StleFactors& f) {
  StleResult out;
  double quality = f.material * f.process * f.hardness;
  if (f.film_parameter) {
    out.film = film_factor(*f.film_parameter);
    out.thin_film = *f.film_parameter < 1.0;
    if (out.thin_film) quality = std::min(quality, 1.0);
  }
  out.factor = quality * out.film * f.filter * f.residual;
  return out;
}

double asperity_hazard(double film_parameter, double slope, double traction) {
  const LifeConstants& c = constants();
  const double C_a =
      (std::pow(c.asperity_life_factor, -c.point_slope.value) - 1.0) / upper_tail(1.0);
  const double q = c.asperity_exponent;
  return 1.0 + C_a * std::pow(slope / c.asperity_slope, q) *
                   std::pow(0.5 * (1.0 + traction / c.asperity_traction), q) *
                   upper_tail(film_parameter);
}

TallianResult tallian_factor(const TallianFactors& f, double slope) {
  TallianResult out;
  out.hazard = f.material * f.process * f.contamination * f.asperity;
  out.factor = std::pow(out.hazard, -1.0 / slope);
  return out;
}

}  // namespace adore::life
