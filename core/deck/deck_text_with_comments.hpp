#pragma once

#include "deck/deck.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace adore::deck {

/// The text of a deck with other values and everything else unchanged: remarks after the values,
/// blanks, spelling of numbers, a byte-order mark.
struct DeckTextWithComments {
  std::string text;
  bool kept = true;  ///< false: the writer's own text, which has no remarks
  /// Records whose remarks a change of kUnit makes doubtful (deck/remarks.hpp).
  std::vector<std::string> doubtful_units;
};

/// The text of `after` made from that of another deck. A record whose values cannot be exchanged
/// one for one (left out, repeated by "3*0.0", more or fewer of them) is written anew with its
/// remark behind it; records that are new are written where they belong, and those that are gone
/// take their remarks with them. When even that would not read back equal, the writer's own text.
/// @param text of a deck, which may have errors
[[nodiscard]] DeckTextWithComments with_deck(std::string_view text, const Deck& after);

/// The same with some values changed. Changes that need more than exchanging words make the
/// writer's own text.
/// @param text of a deck without errors
/// @throws InputError as Deck::set_all()
[[nodiscard]] DeckTextWithComments with_values(
    std::string_view text, std::span<const std::pair<std::string, std::string>> sets);

}  // namespace adore::deck
