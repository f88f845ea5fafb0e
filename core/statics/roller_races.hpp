#pragma once

#include "bearing/bearing.hpp"
#include "contact/race_growth.hpp"
#include "contact/race_surface.hpp"

#include <array>

/// The races of a roller bearing as surfaces, at zero displacement in the base frame: outer and
/// inner race coaxial, rollers at x = 0. On the bench mid planes coincide (cylinders, barrels) or
/// both cones just touch; in operation the races have grown from there (contact/race_growth.hpp).
/// All @throw InputError when the values make no race.
namespace adore::statics {

using RollerRaces = std::array<contact::RaceSurface, 2>;

/// Without what deviates (imperfections), and as the bearing is now: on the bench or in operation.
[[nodiscard]] RollerRaces race_surfaces(const bearing::Bearing& b);

/// @param rollers not in operation (RollerGeometry::unmounted_geometry)
[[nodiscard]] RollerRaces bench_races(bearing::Type type, const bearing::RollerGeometry& rollers);

/// How both races have grown; nothing when the rollers are on the bench.
[[nodiscard]] std::array<contact::RaceGrowth, 2> race_growths(
    bearing::Type type, const bearing::RollerGeometry& rollers);

}  // namespace adore::statics
