#pragma once

#include "adrinput/document.hpp"

#include <QString>

/// Display in the other unit system: values next to their fields in the units that the deck does
/// not use.
namespace adore::adrinput {

/// "2.3622 in" for a field that shows 0.06 m, to six digits; empty for values without another unit
/// and for texts that are not numbers.
[[nodiscard]] QString value_in_other_units(const Document& document, const Cell& cell);

/// "English units" for a deck in SI units, and vice versa.
[[nodiscard]] QString other_unit_system_name(const deck::Deck& deck);

}  // namespace adore::adrinput
