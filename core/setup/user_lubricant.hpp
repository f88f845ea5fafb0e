#pragma once

#include "bearing/lubrication.hpp"
#include "deck/deck.hpp"

namespace adore::setup {

/// The lubricant of records 10.4.0, 10.4.1 and 10.4.4 (kTrac 9) with all that films and traction
/// ask for; its density and specific heat, for churning and coolant, are left 0.
/// @throws InputError for a value that is not there or no number
[[nodiscard]] bearing::UserLubricant user_lubricant(const deck::Deck& deck);

}  // namespace adore::setup
