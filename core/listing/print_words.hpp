#pragma once

#include "deck/units.hpp"

#include <array>
#include <cstddef>

/// Words and units that several sections of PRINT share.
namespace adore::listing {

inline constexpr std::array<const char*, 2> kRaceName{"outer", "inner"};
inline constexpr std::array<const char*, 2> kRaceTitle{"outer race", "inner race"};

/// @param k index of a load on a race: three forces, then two moments
[[nodiscard]] inline const UnitPair& load_unit(std::size_t k) {
  return k < 3 ? deck::unit::kForce : deck::unit::kMoment;
}

}  // namespace adore::listing
