#pragma once

#include "deck/deck.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Inputs of the design page: which variables of the deck they are, and in which unit people enter
/// them. The deck keeps its own units and digits.
namespace adore::design {

struct DesignInput {
  std::string group;                   ///< "Operation", "Geometry"
  std::string label;                   ///< "Radial load"
  std::vector<std::string> variables;  ///< one, or several that have the same value
  std::string unit;                    ///< "mm", "N", "rpm", "°C"; empty: a pure number
  std::string why_fixed;  ///< a clause: why a value would have no effect; empty: it acts
};

/// Inputs that this deck has, in the order of the page.
[[nodiscard]] std::vector<DesignInput> design_inputs(const deck::Deck& deck);

/// The number in its unit, at most nine digits if it has more than ten; empty: variables with
/// different values.
[[nodiscard]] std::string input_text(const deck::Deck& deck, const DesignInput& input);

/// An oil that the page offers, and what it changes.
struct DesignOil {
  std::string name;
  std::vector<std::pair<std::string, std::string>> sets;  ///< of the deck, as for Deck::set_all()
};

/// Dry friction, mineral oils by viscosity grade (record X2), then the oils of the manual. An oil
/// replaces all values of another oil in record X2.
[[nodiscard]] std::vector<DesignOil> design_oils(const deck::Deck& deck);
/// Position in design_oils() of the oil that the deck has; nothing: one that the page does not
/// offer.
[[nodiscard]] std::optional<std::size_t> design_oil_index(const deck::Deck& deck);

/// The deck of another bearing of the catalogue with the operation of this one: loads, speeds,
/// temperatures and oil stay. Loads that only the example of the catalogue scaled are the new
/// bearing's: see `keep`.
/// @param keep operation of `deck`; else that of the catalogue
/// @throws InputError for an unknown designation
[[nodiscard]] deck::Deck replace_bearing(const deck::Deck& deck, std::string_view designation,
                                         bool keep);

}  // namespace adore::design
