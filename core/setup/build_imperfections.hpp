#pragma once

#include "bearing/bearing.hpp"
#include "deck/deck.hpp"
#include "setup/user_hooks.hpp"

#include <cstdint>

/// Records 5G and 7.4 of a deck: geometric imperfections of rolling elements, races and cage
/// pockets.
namespace adore::setup {

/// The random table of kReGeoImp = 1 without a specified seed.
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
/// normal deviate; neither the mean nor the rms of the elements of one bearing is forced
/// to the record's. The central land of a roller is limited to 0 and the roller's length.
/// Pockets: a quasi-static solution uses only their clearances, which determine the cage's
/// clearance.
/// @throws InputError with the element whose size would not be above 0.
/// Codes that ask for routine ADRX8 get one call of it, inertia of elements included.
void build_imperfections(const deck::Deck& deck, std::uint64_t seed, bearing::Bearing& bearing,
                         const UserHooks* user = nullptr);

}  // namespace adore::setup
