#pragma once

#include "deck/deck.hpp"

#include <string>
#include <vector>

/// Options of a deck that a quasi-static solution (mode -1) has no use for: nothing moves there, so
/// traction, lubricant films, the cage's motion, drag, the thermal network and the control of
/// motion play no part. The deck is solved without them and they are named.
namespace adore::setup {

struct IdleOption {
  std::string variable;
  std::string value;     ///< as the deck has it
  std::string asks_for;  ///< what a dynamic run would make of it
};

/// Empty for a dynamic run, and where every option is neutral.
[[nodiscard]] std::vector<IdleOption> idle_options(const deck::Deck& deck);

}  // namespace adore::setup
