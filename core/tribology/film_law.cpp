#include "tribology/film_law.hpp"

#include "base/errors.hpp"
#include "tribology/film_thickness.hpp"

#include <algorithm>
#include <cmath>

namespace adore::tribology {

bool has_film_law(const Lubricant& lubricant) {
  return lubricant.model == LubricantModel::NewtonianThermal;
}

HeatedFilm heated_film(const Lubricant& oil, const bearing::Lubrication& lubrication,
                       const FilmSurface& s) {
  demand(has_film_law(oil), "a lubricant with a law for motion");
  const double T = s.wall_temperature, mu = oil.base_viscosity(T), alpha = oil.base_alpha(T),
               K = oil.conductivity.at(T);
  // The powers of speed and load taken out, at 1 m/s and 1 N.
  const FilmThickness unit = point_film({mu, alpha, 1.0, s.modulus}, s.radius, 1.0, s.k);
  HeatedFilm out;
  // point_film itself holds W at 1e-9; at 1 N that can only be reached by bodies of metres.
  out.log_central = std::log(unit.central);
  out.log_minimum = std::log(unit.minimum);
  constexpr double kLeastGroup = 1e-9;  // film_thickness.hpp
  out.least_load = kLeastGroup * s.modulus * s.radius * s.radius;
  constexpr double kLeastShare = 1e-6, kLeastSpeed = 1e-9;  // of the race speed [choice]; m/s
  const double least = std::max(kLeastShare * std::abs(s.race_speed), kLeastSpeed);
  out.least_speed2 = least * least;
  out.log_heating = std::log(std::max(mu * oil.base_beta(T) / K, 1e-30));
  out.pressure_scale = 13.2 / s.modulus;
  constexpr double kDry = 1e-9;  // meniscus at the contact: no film
  out.meniscus = std::max(lubrication.meniscus, kDry);
  out.inverse_diameter = 0.5 / s.radius;
  out.viscosity = oil.pressed_viscosity(0.0, T);
  out.half_alpha = 0.5 * oil.traction_alpha;
  constexpr double kLeastBeta = 1e-9;  // 1/K: no heating to speak of
  out.heating =
      std::sqrt(std::max(oil.pressed_beta(0.0, T), kLeastBeta) * out.viscosity / (8.0 * K));
  out.limit = oil.limiting_ratio;
  out.critical = lubrication.critical_film;
  return out;
}

}  // namespace adore::tribology
