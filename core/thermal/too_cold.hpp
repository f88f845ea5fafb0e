#pragma once

#include "thermal/bearing_heat.hpp"

#include <string>

namespace adore::thermal {

/// What of the network's nodes is not above 0 K, in words; empty: none. The base temperature fixes
/// one node and the heat the differences, so that too little flow for the heat puts the coolant's
/// inlet there, and a ring that hardly conducts its far side.
[[nodiscard]] std::string too_cold(const BearingHeat& heat);

}  // namespace adore::thermal
