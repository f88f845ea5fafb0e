#pragma once

#include "thermal/bearing_heat.hpp"

#include <string>

namespace adore::thermal {

/// Nodes of the network that are not above 0 K, in words; empty: none. The base temperature fixes
/// one node and the heat the differences, so with too little flow for the heat the coolant's
/// inlet may be there, or the far side of a ring with low conductivity.
[[nodiscard]] std::string describe_too_cold_nodes(const BearingHeat& heat);

}  // namespace adore::thermal
