#pragma once

#include "runs/prepare.hpp"

#include <string>

namespace adore::runs {

/// Friction coefficients of all codes of the deck's oil at the contact of largest pressure in the
/// quasi-static solution, slip 1 % and 10 % of the rolling speed, and the recommended code. Empty:
/// no oil with several codes, no load or no rolling.
[[nodiscard]] std::string traction_spread(const Prepared& prepared);

}  // namespace adore::runs
