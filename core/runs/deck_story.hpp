#pragma once

#include "deck/deck.hpp"

#include <string>
#include <vector>

namespace adore::runs {

/// Description of a deck and its run in a few lines: bearing, operation, kind of
/// run, outputs, and reasons why a run would be rejected. From the deck itself, in its own units.
/// @param deck without errors
[[nodiscard]] std::vector<std::string> deck_story(const deck::Deck& deck);

}  // namespace adore::runs
