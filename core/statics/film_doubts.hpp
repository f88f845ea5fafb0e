#pragma once

#include "statics/contact_films.hpp"

#include <string>
#include <vector>

/// What of a solution's films is beyond what their formulas and laws know.
///
/// Hertz's ellipse and the regressions of film_thickness.hpp hold for films that are thin beside
/// the bodies: h/R is some 1e-4 in bearings, and the regressions were fitted up to 1e-3. A film of
/// a tenth of the radius is no film. A liquid of 1e12 Pa s is a glass (viscosity/glass.hpp), and
/// laws of viscosity over temperature are measured up to some 1e3 Pa s. [choice]
/// Decision 681.
namespace adore::statics {

inline constexpr double kThickFilm = 3e-3, kNoFilmAnyMore = 0.1;  ///< h/R
inline constexpr double kThickOil = 1e3;                          ///< [Pa s]

/// Sentences to warn of; empty: nothing to doubt.
/// @throws SolverError where the oil is a glass, or a film no film: nothing that hangs on it could
/// be trusted
[[nodiscard]] std::vector<std::string> film_doubts(const LubricantFilms& films);

}  // namespace adore::statics
