#pragma once

#include "deck/schema.hpp"

#include <string>
#include <string_view>

/// The library writes its messages in SI; their reader may have an English deck.
namespace adore::deck {

/// A message in the deck's units: every number directly before an SI unit ("4.2 GPa",
/// "0.0127 m", "3 N m") is converted, with at least three significant digits. SI texts stay as they
/// are. A list needs the unit after each of its numbers.
[[nodiscard]] std::string message_in_units(std::string_view text, UnitSystem units);

}  // namespace adore::deck
