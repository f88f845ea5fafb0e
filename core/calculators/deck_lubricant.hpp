#pragma once

#include "calculators/lubricant_curves.hpp"
#include "deck/deck.hpp"

#include <optional>

namespace adore::calculators {

/// The lubricant of record 10.0 in a contact of usual size, at the deck's temperatures, roughness
/// and records 10.1 and 10.3; nothing without a lubricant (kTrac < 1).
/// @throws InputError for a value of the user's lubricant (records 10.4) that is not there
[[nodiscard]] std::optional<LubricantContact> lubricant_contact(const deck::Deck& deck);

}  // namespace adore::calculators
