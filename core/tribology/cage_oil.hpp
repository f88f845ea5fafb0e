#pragma once

#include "bearing/bearing.hpp"

namespace adore::tribology {

/// Viscosity of the oil between the cage and what it meets [Pa s]: the given one (record 10.6), or
/// for 0 that of the lubricant at the cage's temperature and no pressure.
[[nodiscard]] double cage_film_viscosity(const bearing::Bearing& bearing, double given);

}  // namespace adore::tribology
