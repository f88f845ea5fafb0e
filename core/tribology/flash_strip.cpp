#include "tribology/flash_strip.hpp"

#include "tribology/newton_film_walls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace adore::tribology {

FlashResult flash_strip(const FlashStrip& s, int cells) {
  const double pi = std::numbers::pi, slip = std::abs(s.speed_b - s.speed_a);
  const double share_a = 1.0 / std::sqrt(pi * s.effusivity2_a * s.speed_a),
               share_b = 1.0 / std::sqrt(pi * s.effusivity2_b * s.speed_b);
  const auto edge = [&](int i) { return -s.half_length * std::cos(pi * i / cells); };
  std::vector<double> heat_a, heat_b;
  FlashResult out;
  for (int i = 0; i < cells; ++i) {
    const double from = edge(i), length = edge(i + 1) - from, x = from + 0.5 * length;
    double before_a = 0.0, before_b = 0.0;
    for (int j = 0; j < i; ++j) {
      const double weight = 2.0 * (std::sqrt(x - edge(j)) - std::sqrt(x - edge(j + 1)));
      before_a += weight * heat_a[static_cast<std::size_t>(j)];
      before_b += weight * heat_b[static_cast<std::size_t>(j)];
    }
    const double own = 2.0 * std::sqrt(x - from), ratio = x / s.half_length;
    const double p = s.peak_pressure * std::sqrt(std::max(0.0, 1.0 - ratio * ratio));
    double rise_a = share_a * before_a, rise_b = share_b * before_b;
    FilmShear film;
    for (int repeat = 0; repeat < 100; ++repeat) {
      const auto viscosity = [&](double T) {
        return s.viscosity * std::exp(s.alpha * p + s.beta * (s.reference - T));
      };
      film = film_shear_between_walls(viscosity(s.temperature_a + rise_a),
                                      viscosity(s.temperature_b + rise_b), s.beta, s.conductivity,
                                      s.thickness, slip);
      const double change_a = share_a * (before_a + own * film.heat_a) - rise_a,
                   change_b = share_b * (before_b + own * film.heat_b) - rise_b;
      rise_a += 0.5 * change_a;
      rise_b += 0.5 * change_b;
      if (!(std::abs(change_a) + std::abs(change_b) > 1e-10)) break;
    }
    heat_a.push_back(film.heat_a);
    heat_b.push_back(film.heat_b);
    out.force += film.stress * length;
    out.heat_a += film.heat_a * length;
    out.heat_b += film.heat_b * length;
    out.flash_a = std::max(out.flash_a, rise_a);
    out.flash_b = std::max(out.flash_b, rise_b);
  }
  return out;
}

double mean_band_flash(double heat_flux, double half_length, double speed, double effusivity2) {
  return 4.0 / 3.0 * heat_flux *
         std::sqrt(2.0 * half_length / (std::numbers::pi * effusivity2 * speed));
}

double circle_flash(double heat_flux, double radius, double conductivity, double peclet) {
  return 2.0 * heat_flux * radius / (conductivity * std::sqrt(std::numbers::pi * (1.273 + peclet)));
}

}  // namespace adore::tribology
