#pragma once

#include "base/finding.hpp"
#include "statics/contact_films.hpp"

#include <optional>
#include <string>
#include <vector>

/// What of a bearing's oil is beyond what the formulas of films and the laws of viscosity know.
///
/// Hertz's ellipse and the regressions of film_thickness.hpp hold for films that are thin beside
/// the bodies: h/R is some 1e-4 in bearings, and the regressions were fitted up to 1e-3. A film of
/// a tenth of the radius is no film. A liquid of 1e12 Pa s is a glass (viscosity/glass.hpp), and
/// laws of viscosity over temperature are measured up to some 1e3 Pa s. [choice]
/// Decisions 681 and 690.
namespace adore::statics {

/// What films of these temperatures are for.
enum class FilmUse : unsigned char {
  Equilibrium,  ///< mode -1: a race that has no film asks nothing of its oil
  Motion,       ///< a race at rest turns later
  ThermalSteps  ///< a motion whose temperatures are iterates: films that are too thick may thin
};

/// Warnings film.*; empty: nothing to doubt. Where no oil reaches the contacts (meniscus 0)
/// there is none.
/// @throws DeckFault (kTrac) where the oil is a glass, or a film no film (but for thermal steps):
/// nothing that hangs on it could be trusted. Laws of liquids say nothing of a glass.
[[nodiscard]] std::vector<Finding> film_doubts(const LubricantFilms& films, FilmUse use);

/// The same of oil that only flows, such as that between cage and elements; empty: nothing.
/// @param flag the variable of the deck that switches its effect
/// @param place what stands behind "Mobil Jet Oil at 95 K, "
[[nodiscard]] std::optional<Finding> oil_flow_warning(const std::string& flag,
                                                      const std::string& oil, double temperature,
                                                      double viscosity, const std::string& place);

}  // namespace adore::statics
