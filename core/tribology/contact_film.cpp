#include "tribology/contact_film.hpp"

#include "tribology/film_thickness.hpp"
#include "tribology/starvation.hpp"
#include "tribology/thermal_reduction.hpp"

#include <cmath>

namespace adore::tribology {
namespace {

FilmThickness isothermal(const FilmInlet& inlet, const LubricatedContact& c) {
  if (c.line) return line_film(inlet, c.radius, c.load);
  if (c.k >= 1.0) return point_film(inlet, c.radius, c.load, c.k);
  // Ry/Rx of k = 1.03 (Ry/Rx)^0.64.
  return chittenden_point_film(inlet, c.radius, c.radius * std::pow(c.k / 1.03, 1.0 / 0.64),
                               c.load);
}

}  // namespace

InletOil inlet_oil(const Lubricant& lubricant, double temperature, double meniscus) {
  return {lubricant.base_viscosity(temperature), lubricant.base_alpha(temperature),
          lubricant.base_beta(temperature), lubricant.conductivity.at(temperature), meniscus};
}

ContactFilm contact_film(const InletOil& oil, const LubricatedContact& contact) {
  ContactFilm out;
  const double speed = std::abs(contact.speed);
  if (!(contact.load > 0.0) || !(speed > 0.0)) return out;
  const FilmThickness film =
      isothermal({oil.viscosity, oil.alpha, speed, contact.modulus}, contact);
  out.isothermal = film.central;
  out.thermal = thermal_reduction(thermal_loading(oil.viscosity, oil.beta, speed, oil.conductivity),
                                  contact.slip / speed, contact.peak_pressure / contact.modulus);
  out.starvation = starvation_factor(
      starvation_parameter(oil.meniscus, contact.half_width, contact.radius, film.central));
  out.central = out.thermal * out.starvation * film.central;
  out.minimum = out.thermal * out.starvation * film.minimum;
  return out;
}

}  // namespace adore::tribology
