#pragma once

#include "adrinput/document.hpp"

#include <string>
#include <string_view>

/// A sweep as a person writes it.
namespace adore::adrinput {

struct SweepRange {
  std::string set;   ///< as `--set` has it, in the deck's units: "appLoadZ=500:1500:5"
  std::string told;  ///< its meaning: "appLoadZ from 500 N to 1500 N, 5 runs"
};

/// "appLoadZ=0.5 kN:1.5 kN:3", "appLoadZ=0.5:1.5 kN:3", "appLoadZ=0.5:1.5:3 kN". Values mean the
/// same as in the field of the variable (add_display_unit()); a single unit applies to both.
/// @throws InputError with the error and its remedy
[[nodiscard]] SweepRange parse_sweep_range(const Document& document, std::string_view text);

/// Unit of a number without one: "N", or "mm" if millimeters are shown. Empty for a pure number,
/// and for names that are not variables of the deck.
[[nodiscard]] std::string sweep_unit(const Document& document, std::string_view text);

}  // namespace adore::adrinput
