#pragma once

#include "deck/deck.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace adore::deck {

/// The text of a deck with other values, everything else as it stands: remarks behind the values,
/// blanks, spelling of numbers. Values that cannot be exchanged one for one (left out, or repeated
/// by "3*0.0") and changes that add or drop records make the writer's own text instead, which has
/// no remarks.
/// @param text of a deck without errors
/// @throws InputError as Deck::set_all()
struct KeptText {
  std::string text;
  bool kept = true;  ///< false: the writer's own text
};
[[nodiscard]] KeptText with_values(std::string_view text,
                                   std::span<const std::pair<std::string, std::string>> sets);

}  // namespace adore::deck
