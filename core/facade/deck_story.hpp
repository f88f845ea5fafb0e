#pragma once

#include "deck/deck.hpp"

#include <string>
#include <vector>

namespace adore::facade {

/// What a deck is and what running it does, in a few lines for people: bearing, operation, kind of
/// run, what comes out, and what a run would refuse. From the deck itself, in its own units.
/// @param deck without errors
[[nodiscard]] std::vector<std::string> deck_story(const deck::Deck& deck);

}  // namespace adore::facade
