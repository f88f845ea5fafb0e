#pragma once

#include <optional>
#include <string>

namespace adore::bearing {

/// Records 10.4.1 and 10.4.4, a lubricant of the user's: type II viscosity for the film, type I for
/// the traction, both at T0. SI, kelvin.
struct UserLubricant {
  std::string name;
  double T0 = 0.0, viscosity = 0.0, alpha = 0.0, beta = 0.0;  ///< K, Pa s, 1/Pa, K
  double conductivity = 0.0, density = 0.0, specific_heat = 0.0;
  double traction_viscosity = 0.0, traction_alpha = 0.0, traction_beta = 0.0;  ///< Pa s, 1/Pa, 1/K
  /// Limiting stress over pressure at 40 °C and its fall with temperature [1/K]: run options
  /// lubStressLimit and lubStressSoftening. None: tribology::kUserLimit.
  std::optional<double> limit_ratio;
  double limit_softening = 0.003;
};

/// Data of a deck with kTrac > 0 on the lubricant between elements and races.
struct Lubrication {
  int code = 0;                ///< kTrac
  double critical_film = 0.0;  ///< reRaceFilm: thinner films are metal contacts [m]
  double meniscus = 0.0;       ///< strParam: its distance from the contact over the half width
  std::optional<UserLubricant> user;  ///< kTrac 9
  bool hot_walls = false;             ///< iTherm: walls of visco-elastic films have a flash
  // Run options and tolerance, not the deck.
  bool direct_strips = false;  ///< integrate the stress of every strip, no surface (kTrac 8, 12)
  double tolerance = 1e-6;     ///< of the run, for the error of the surface
  bool stress_limit = true;    ///< filmStressLimit: films have their limiting shear stress
  bool recommended = false;    ///< filmLaw: traction by the recommended law of the code's oil
};

/// Medium that churns in the cavity of the bearing (kChrn, records 10.7A and 10.7B).
struct Churning {
  int code = 0;  ///< kChrn: 1 the lubricant, 2 given, 3 to 14 of the table of fluids
  double density = 0.0, viscosity = 0.0;              ///< code 2 [kg/m³, Pa s]
  double density_ratio = 1.0, viscosity_ratio = 1.0;  ///< other codes: over what the medium has
};

/// Oil films between the cage and what it meets (kPocHydro, kGsHydro, records 9.6 and 10.6).
struct CageFilms {
  bool pockets = false, lands = false;
  /// Given; 0: that of the lubricant at the cage's temperature [Pa s].
  double pocket_viscosity = 0.0, land_viscosity = 0.0;
  double largest_pocket_film = 0.0;  ///< pocLubFilm: farther walls feel none [m]
  double critical_film = 0.0;        ///< thinner films are metal contacts [m]
};

}  // namespace adore::bearing
