#pragma once

#include "bearing/bearing.hpp"
#include "tribology/laws/rolling_resistance.hpp"
#include "tribology/lubricant.hpp"
#include "tribology/traction_law.hpp"
#include "tribology/visco_elastic_surface.hpp"

#include <array>
#include <string>

/// From a deck's lubricant to the law of traction of one race.
namespace adore::tribology {

/// Contacts with one race, as far as its film reads them.
struct RaceFilmInputs {
  bool line = false;              ///< slices of rollers
  double radius = 0.0;            ///< of both bodies along rolling, where a contact says none [m]
  double modulus = 0.0;           ///< E' [Pa]
  double wall_temperature = 0.0;  ///< mean of both bodies' bulk temperatures [K]
  double race_speed = 0.0;        ///< scale of the surface speeds [m/s]
  double width_over_pressure = 0.0;  ///< b/p0 of the contacts, read by visco-elastic films [m/Pa]
  std::array<FilmWall, 2> walls{};   ///< race and element, read by films that heat them
  bool single = false;  ///< points by floats, where the film can (laws/film_law_of.hpp)
};
[[nodiscard]] inline FilmWall film_wall(const bearing::Material& m) {
  return {m.conductivity, m.density * m.specific_heat};
}

/// A few molecules: no liquid shears below that, and its traction would grow without bound [m].
/// Critical films of motion are not taken thinner.
inline constexpr double kThinnestFilm = 1e-9;

[[nodiscard]] ContactFilmModel contact_film_model(const Lubricant& lubricant,
                                                  const bearing::Lubrication& lubrication,
                                                  const RaceFilmInputs& surface);

/// Of the oil in the inlets of contacts with one race.
[[nodiscard]] RollingResistance rolling_resistance(const Lubricant& lubricant,
                                                   const bearing::Lubrication& lubrication,
                                                   const RaceFilmInputs& surface);

// The films of the four models at the walls' temperature.
[[nodiscard]] HeatedFilm heated_film(const Lubricant& lubricant, double temperature);
[[nodiscard]] MeasuredViscosityFilm measured_viscosity_film(const Lubricant& lubricant,
                                                            double temperature);
[[nodiscard]] ShearThinningFriction shear_thinning_friction(const Lubricant& lubricant,
                                                            double temperature);

/// @param metal where the film breaks down
[[nodiscard]] TractionLaw film_law(const bearing::TractionCurve& metal, const Lubricant& lubricant,
                                   const bearing::Lubrication& lubrication,
                                   const RaceFilmInputs& surface);
/// How a film has its stress: a visco-elastic or shear-thinning one with the error of its surface,
/// any one that is evaluated by floats; else empty.
[[nodiscard]] std::string describe_film_evaluation(const Lubricant& lubricant,
                                                   const bearing::Lubrication& lubrication,
                                                   const RaceFilmInputs& surface);

}  // namespace adore::tribology
