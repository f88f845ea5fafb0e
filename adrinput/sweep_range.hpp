#pragma once

#include "adrinput/document.hpp"

#include <string>
#include <string_view>

/// A sweep as a person writes it.
namespace adore::adrinput {

struct SweepRange {
  std::string set;   ///< as `--set` has it, in the deck's units: "appLoadZ=500:1500:5"
  std::string told;  ///< what it means: "appLoadZ from 500 N to 1500 N, 5 runs"
};

/// "appLoadZ=0.5 kN:1.5 kN:3", "appLoadZ=0.5:1.5 kN:3", "appLoadZ=0.5:1.5:3 kN". Values are what
/// they are in the field of the variable (as_meant()); a unit that stands once is that of both.
/// @throws InputError with what is wrong and what would be right
[[nodiscard]] SweepRange read_sweep(const Document& document, std::string_view text);

/// The unit that a number without one has there: "N", or "mm" where millimeters are shown. Empty
/// for a pure number, and for what is no variable of the deck.
[[nodiscard]] std::string sweep_unit(const Document& document, std::string_view text);

}  // namespace adore::adrinput
