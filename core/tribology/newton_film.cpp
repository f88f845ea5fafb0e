#include "tribology/newton_film.hpp"

#include <cmath>

namespace adore::tribology {

double film_shear_stress(const NewtonFilm& film, double slip, double pressure) noexcept {
  const double viscosity = film.viscosity * std::exp(film.pressure_exponent * pressure);
  const double S =
      slip * std::sqrt(film.temperature_exponent * viscosity / (8.0 * film.conductivity));
  const double S2 = S * S;
  // Below 1e-4 the series is exact to 1e-24; asinh(S)/S would be 0/0 at rest.
  const double thinning = S < 1e-4 ? 1.0 - 2.0 / 3.0 * S2 + 8.0 / 15.0 * S2 * S2
                                   : std::asinh(S) / (S * std::sqrt(1.0 + S2));
  return viscosity * slip / film.thickness * thinning;
}

}  // namespace adore::tribology
