#pragma once

#include "bearing/bearing.hpp"
#include "deck/deck.hpp"

namespace adore::setup {

/// Valid pockets of a cage, with their deviations (records 7.1, 7.3 and 7.4): a wall remains
/// between two radii above the axis, an element has room in it and it is smaller than the bearing,
/// its middle is in the cage, nearer to its own element than to the next one, and its frame is
/// tilted by less than 45 degrees. Conditions of the motion are checked for mode >= 0 only.
/// @throws InputError naming the variable, with its limit
void check_pockets(const deck::Deck& deck, const bearing::Bearing& bearing);

}  // namespace adore::setup
