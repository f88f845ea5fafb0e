#pragma once

#include "bearing/bearing.hpp"
#include "tribology/laws/heated_film.hpp"
#include "tribology/lubricant.hpp"

namespace adore::tribology {

/// Contacts with one race, as far as its film reads them.
struct FilmSurface {
  double radius = 0.0;            ///< of both bodies along rolling [m]
  double k = 1.0;                 ///< half axis across over along rolling, >= 1
  double modulus = 0.0;           ///< E' [Pa]
  double wall_temperature = 0.0;  ///< mean of both bodies' bulk temperatures [K]
  double race_speed = 0.0;        ///< scale of the surface speeds [m/s]
};

/// Can the lubricant's traction be computed in motion? So far the Newtonian model with thermal film
/// (kTrac 1 to 7, 9).
[[nodiscard]] bool has_film_law(const Lubricant& lubricant);

/// @pre has_film_law
[[nodiscard]] HeatedFilm heated_film(const Lubricant& lubricant,
                                     const bearing::Lubrication& lubrication,
                                     const FilmSurface& surface);

}  // namespace adore::tribology
