#include "tribology/thinning_surface.hpp"

#include "tribology/spline_axes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

namespace adore::tribology {
namespace {

constexpr double kLeast = -8.0, kMostRate = 40.0, kMostHeat = 16.0;

struct Sizes {
  std::size_t rates, heats;
};
constexpr Sizes kLevels[] = {{97, 49}, {193, 97}, {385, 193}};

/// ln(1 + e^x).
double softplus(double x) { return std::max(x, 0.0) + std::log1p(std::exp(-std::abs(x))); }

/// ln of asinh(S)/(S √(1 + S²)), S = e^y, and its slope.
std::pair<double, double> log_heating(double y) {
  const double S = std::exp(y);
  if (S < 1e-4) return {-2.0 / 3.0 * S * S, -4.0 / 3.0 * S * S};
  const double asinh = std::asinh(S), root = std::hypot(1.0, S);
  return {std::log(asinh) - y - std::log(root), S / (root * asinh) - 1.0 - (S / root) * (S / root)};
}

ThinningSurface make(double half_power, const Sizes& n) {
  ThinningSurface out;
  out.size = {n.rates, n.heats};
  out.log_rate = spline_axis(kLeast, kMostRate, n.rates);
  out.log_heat = spline_axis(kLeast, kMostHeat, n.heats);
  const std::size_t line = n.heats + 2;
  auto table = std::make_shared<std::vector<double>>((n.rates + 2) * line);
  for (std::size_t i = 0; i < n.rates; ++i) {
    for (std::size_t j = 0; j < n.heats; ++j)
      (*table)[(i + 1) * line + j + 1] = log_stress_ratio(
          half_power, spline_abscissa(out.log_rate, i), spline_abscissa(out.log_heat, j));
    values_to_spline_coefficients(*table, (i + 1) * line, 1, n.heats);
  }
  for (std::size_t j = 0; j < line; ++j) values_to_spline_coefficients(*table, j, line, n.rates);
  out.tiles = std::make_shared<const Tiles>(make_tiles(table->data(), n.rates + 2, line));
  out.table = std::move(table);
  return out;
}

/// Errors on two places in each cell, those of Weyl's sequence.
void measure(ThinningSurface& surface, double half_power) {
  ShearThinningFriction film;
  film.modulus = 1.0;
  film.half_power = half_power;
  surface.give(film);
  const auto here = film.at(ContactConditions<double>{}, 1.0);
  double squares = 0.0;
  const auto weyl = [&](double irrational) {
    const double x = irrational * (surface.held_out + 1);
    return x - std::floor(x);
  };
  for (std::size_t i = 0; i + 1 < surface.size[0]; ++i)
    for (std::size_t j = 0; j + 1 < surface.size[1]; ++j)
      for (int k = 0; k < 2; ++k) {
        const double rate = spline_abscissa(surface.log_rate, i, weyl(0.7548776662466927)),
                     heat = spline_abscissa(surface.log_heat, j, weyl(0.5698402909980532));
        const double miss = here.read(rate, heat) - log_stress_ratio(half_power, rate, heat);
        surface.error[0] = std::max(surface.error[0], std::abs(miss));
        squares += miss * miss;
        ++surface.held_out;
      }
  surface.error[1] = std::sqrt(squares / surface.held_out);
}

}  // namespace

double log_stress_ratio(double half_power, double rate, double heat) noexcept {
  // x = ln r: x - rate - ln f(heat + half/2 softplus(2x)) rises with a slope between 1 - (1-n)/2
  // and 1.
  double x = rate;
  constexpr int kMost = 60;
  for (int step = 0; step < kMost; ++step) {
    const auto [log_f, slope] = log_heating(heat + 0.5 * half_power * softplus(2.0 * x));
    const double share = 1.0 / (1.0 + std::exp(-2.0 * x));
    const double change = (x - rate - log_f) / (1.0 - slope * half_power * share);
    x -= change;
    if (std::abs(change) < 1e-13 * (1.0 + std::abs(x))) break;
  }
  return x - rate + half_power * softplus(2.0 * x);
}

void ThinningSurface::give(ShearThinningFriction& film) const {
  film.surface = table->data();
  film.tiles = tiles->data()->power;
  film.log_rate = log_rate;
  film.log_heat = log_heat;
  film.most_rate = kMostRate;
  film.most_heat = kMostHeat;
}

double target_thinning_error(double tolerance) {
  return std::clamp(0.6 * std::sqrt(tolerance), 5e-5, 7e-4);
}

ThinningSurface thinning_surface(double half_power, double wanted) {
  static std::mutex mutex;
  static std::map<std::pair<double, double>, ThinningSurface> kept;
  const std::lock_guard lock(mutex);
  const std::pair key{half_power, wanted};
  if (const auto known = kept.find(key); known != kept.end()) return known->second;
  ThinningSurface out;
  for (const Sizes& n : kLevels) {
    out = make(half_power, n);
    measure(out, half_power);
    if (out.error[0] <= wanted) break;
  }
  out.wanted = wanted;
  return kept[key] = std::move(out);
}

}  // namespace adore::tribology
