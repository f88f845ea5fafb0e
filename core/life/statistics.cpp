#include "life/statistics.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::life {
namespace {

void check_survival(double survival) {
  if (!(survival > 0.0 && survival < 1.0))
    throw InputError(fmt::format(
        "the survival probability is {}; it must be between 0 and 1, e.g. 0.9", survival));
}

void check_slope(double slope) {
  if (!(slope > 0.0 && std::isfinite(slope)))
    throw InputError(fmt::format("the Weibull slope is {}; it must be above 0, e.g. 1.111", slope));
}

double shortest(std::span<const double> lives) {
  if (lives.empty()) throw InputError("there is no life to combine");
  for (const double life : lives) check_life(life);
  return *std::min_element(lives.begin(), lives.end());
}

}  // namespace

void check_life(double life) {
  if (!(life > 0.0))
    throw InputError(
        fmt::format("the computed life is {} million revolutions, which is not a valid number. "
                    "Check loads, residual stresses and life factors",
                    life));
}

double race_life(std::span<const double> lives, bool rotating, double slope) {
  check_slope(slope);
  const double least = shortest(lives);
  if (!std::isfinite(least)) return kInfinity;
  // Scaled by the shortest life, so that no power overflows.
  const double exponent = rotating ? 1.0 : slope;
  double sum = 0.0;
  for (const double life : lives) sum += rotating ? least / life : std::pow(least / life, exponent);
  return least * std::pow(static_cast<double>(lives.size()) / sum, 1.0 / exponent);
}

double combined_life(std::span<const double> lives, std::span<const double> slopes,
                     double survival) {
  demand(lives.size() == slopes.size(),
         "the number of Weibull slopes differs from the number of lives");
  check_survival(survival);
  for (const double slope : slopes) check_slope(slope);
  const double least = shortest(lives);
  if (!std::isfinite(least)) return kInfinity;
  const double target = std::log(survival) / std::log(0.9);
  const bool equal = std::all_of(slopes.begin(), slopes.end(),
                                 [&](double slope) { return slope == slopes.front(); });
  if (equal) {
    double sum = 0.0;
    for (const double life : lives) sum += std::pow(least / life, slopes.front());
    return least * std::pow(target / sum, 1.0 / slopes.front());
  }
  // g(x) = ln Σ exp(e_i (x - ln L_i)) - ln target increases with x = ln L and is convex with slopes
  // between the smallest and the largest e: Newton from the right end descends without overshoot.
  const auto [low, high] = std::minmax_element(slopes.begin(), slopes.end());
  double x =
      std::log(least) + std::max(std::log(target) / *low, std::log(target) / *high);  // here g >= 0
  for (int n = 0; n < 100; ++n) {
    double sum = 0.0, slope = 0.0;
    for (std::size_t i = 0; i < lives.size(); ++i) {
      if (!std::isfinite(lives[i])) continue;
      const double term = std::exp(slopes[i] * (x - std::log(lives[i])));
      sum += term;
      slope += slopes[i] * term;
    }
    const double step = (std::log(sum) - std::log(target)) * sum / slope;
    x -= step;
    if (std::abs(step) <= 1e-15 * std::max(1.0, std::abs(x))) break;
  }
  return std::exp(x);
}

double survival_factor(double survival, double slope) {
  check_survival(survival);
  check_slope(slope);
  return std::pow(std::log(survival) / std::log(0.9), 1.0 / slope);
}

double life_hours(double mega_revolutions, double relative_speed) {
  if (relative_speed == 0.0) return kInfinity;
  const double turns_per_hour = std::abs(relative_speed) / (2.0 * std::numbers::pi) * 3600.0;
  return mega_revolutions * 1e6 / turns_per_hour;
}

}  // namespace adore::life
