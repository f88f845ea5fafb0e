#pragma once

#include "bearing/bearing.hpp"
#include "deck/deck.hpp"
#include "setup/user_hooks.hpp"

#include <cstdint>

/// Records 5G and 7.4 of a deck: geometric imperfections of rolling elements, races and cage
/// pockets.
namespace adore::setup {

/// The random table that kReGeoImp = 1 uses when no other seed is asked for.
inline constexpr std::uint64_t kDefaultSeed = 1;

/// Columns of the random table (base/random_table.hpp); its rows are the rolling elements from 0.
enum class RandomColumn : unsigned char {
  Diameter = 0,
  CrownRadius = 1,
  Length = 2,
  CentralLength = 3,
  LandOffset = 4,
  PocketClearance1 = 5,  ///< rows: pockets
  PocketClearance2 = 6,
  PocketThickness = 7,
  PocketAxial = 8,
  PocketAngular = 9,
  PocketTilt1 = 10,
  PocketTilt2 = 11,
  PocketTilt3 = 12
};

/// Fills bearing.imperfections, and the deviations of rollers; rolling elements and their count are
/// already built. kReGeoImp = 1: deviation = rms value of record 5G.1A, B or C times a standard
/// normal deviate of its own; neither the mean nor the rms of the elements of one bearing is forced
/// to the record's. The central land of a roller stays between nothing and the roller's length.
/// Pockets: a quasi-static solution uses their clearances only, which the cage's play follows from.
/// @throws InputError naming the element that the deviations leave without size.
/// Codes that ask for routine ADRX8 get one call of it, inertia of elements included.
void build_imperfections(const deck::Deck& deck, std::uint64_t seed, bearing::Bearing& bearing,
                         const UserHooks* user = nullptr);

}  // namespace adore::setup
