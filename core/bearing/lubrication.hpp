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
};

/// What a deck with kTrac > 0 says of the lubricant between elements and races.
struct Lubrication {
  int code = 0;                ///< kTrac
  double critical_film = 0.0;  ///< reRaceFilm: thinner films are metal contacts [m]
  double meniscus = 0.0;       ///< strParam: its distance from the contact over the half width
  std::optional<UserLubricant> user;  ///< kTrac 9
};

}  // namespace adore::bearing
