#pragma once

#include "deck/deck.hpp"

namespace adore::setup {

/// Is there a lubricant (kTrac > 0)? A deck without one has not had its kTrac read by this.
[[nodiscard]] inline bool is_lubricated(const deck::Deck& deck) {
  const bool lubricant = [&] {
    const deck::ReportOnly quiet(deck);
    return deck.integer("kTrac") > 0;
  }();
  return lubricant && deck.integer("kTrac") > 0;
}

}  // namespace adore::setup
