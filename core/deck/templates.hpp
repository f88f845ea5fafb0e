#pragma once

#include "deck/deck.hpp"

#include <span>
#include <string_view>

/// Complete example decks, compiled into the library from resources/decks.
namespace adore::deck {

struct TemplateInfo {
  std::string_view name;         ///< "ball": what `adore new` takes
  std::string_view description;  ///< one line
};

/// The five bearing types first, then variants of the ball deck.
std::span<const TemplateInfo> templates();

/// The example's text with its explanations.
/// @throws InputError naming the valid types.
std::string_view template_text(std::string_view name);

/// The example as data, without warnings or errors.
/// @throws InputError naming the valid types.
Deck new_deck(std::string_view name);

}  // namespace adore::deck
