#pragma once

#include "deck/deck.hpp"

#include <string>

/// Elements of arrays and numbers of bodies by their names.
namespace adore::deck {

/// "cage" for 13 in a deck with 12 elements: rolling elements come first, then cage segments, then
/// the outer and the inner race. Empty for a number that stands for no body.
[[nodiscard]] std::string body_name(const Deck& deck, long long number);

/// Name of an array's element (from 0): "x" of a vector, "about y'" of three angles, "land 2";
/// its number where it has no better one.
[[nodiscard]] std::string array_element_name(const VariableSpec& variable, std::size_t element);

}  // namespace adore::deck
