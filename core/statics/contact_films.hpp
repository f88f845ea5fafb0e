#pragma once

#include "bearing/bearing.hpp"
#include "tribology/contact_film.hpp"

#include <array>
#include <string>
#include <vector>

/// Lubricant films of a quasi-static solution. The oil of the inlet has the mean of the bulk
/// temperatures of race and element; the surfaces roll with the speed of the race against the
/// orbiting contact; slip is that of the spin, 3/8 a ω_s in the mean over the load (rollers: none).
/// [choice]
namespace adore::statics {

struct StaticSolution;
struct RollerSolution;

struct ElementFilm {
  tribology::ContactFilm film;
  double speed = 0.0;   ///< of both surfaces in the contact [m/s]
  double lambda = 0.0;  ///< minimum film over the composite roughness; NaN: no load, no roughness
};

struct LubricantFilms {
  std::string lubricant;                         ///< its name
  std::string provenance;                        ///< weakest word for its constants
  std::array<double, 2> temperature{};           ///< of the inlets by race [K]
  std::array<double, 2> viscosity{}, alpha{};    ///< there [Pa s], [1/Pa]
  double critical_film = 0.0;                    ///< reRaceFilm [m]
  double meniscus = 0.0;                         ///< strParam
  std::array<std::vector<ElementFilm>, 2> race;  ///< by race and element
  /// Λ of the most loaded contact of each race; NaN: none.
  std::array<double, 2> lambda{};
  /// Largest film in the middle of a loaded contact over the radius of both bodies along rolling,
  /// by race.
  std::array<double, 2> thickest{};
  /// Contacts with load whose minimum film is below the critical one.
  std::array<int, 2> metal{};
};

/// Needs bearing.lubrication.
[[nodiscard]] LubricantFilms contact_films(const bearing::Bearing& bearing,
                                           const StaticSolution& solution);
[[nodiscard]] LubricantFilms contact_films(const bearing::Bearing& bearing,
                                           const RollerSolution& solution);

}  // namespace adore::statics
