#pragma once

#include "bearing/bearing.hpp"
#include "statics/roller_kernel.hpp"
#include "tribology/film_law.hpp"

#include <cstddef>

/// Laws of the contacts of rollers and races, of motion and of friction equilibria alike.
namespace adore::statics {

/// What films of one race read. Inlets and walls have the mean bulk temperature of race and rollers
/// for the run.
/// @param single films by floats, where they can
[[nodiscard]] tribology::RaceFilmInputs roller_film_surface(const bearing::Bearing& bearing,
                                                            std::size_t race, double E_star,
                                                            bool single);

/// The deck's curve, or its lubricant's film with the curve where it breaks down.
[[nodiscard]] tribology::TractionLaw roller_race_law(const bearing::Bearing& bearing,
                                                     const tribology::RaceFilmInputs& surface);

/// Of the instruction set of this process.
[[nodiscard]] RollerKernel roller_kernel() noexcept;
[[nodiscard]] RollingResistanceKernel rolling_resistance_kernel() noexcept;

}  // namespace adore::statics
