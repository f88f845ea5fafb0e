#pragma once

#include "deck/number.hpp"
#include "deck/schema.hpp"

#include <span>
#include <string>
#include <string_view>

/// Quantities as people write them: "12.7 mm", "1/2 in", "80 °C", "3*0.005". A text without a unit
/// is in the deck's own unit. Units are known by their dimension, so that "0.5 N/mm^2" fits every
/// stress and "3 mm" no force.
namespace adore::deck {

/// The number of the text in a deck in `system`. Sums need a unit in every term or in none;
/// °C and °F are points of the scale and are used alone.
/// @param unit of the variable; one without dimension takes numbers and their arithmetic only
[[nodiscard]] NumberProblem parse_quantity(std::string_view text, const UnitPair& unit,
                                           UnitSystem system, double& value);

/// Units that people use for the quantity, the deck's SI unit first; empty where there is no
/// choice.
[[nodiscard]] std::span<const std::string_view> usual_units(const UnitPair& unit);

/// A deck's value in one of those units, as the shortest text that parse_quantity() takes back to
/// the same value within 1e-15: "12.7". @throws InternalError for a unit of another dimension.
[[nodiscard]] std::string number_in_unit(double value, const UnitPair& unit, UnitSystem system,
                                         std::string_view wanted);

}  // namespace adore::deck
