#pragma once

#include "calculators/adapter.hpp"

#include <vector>

namespace adore::calculators {

/// Families thermal_lame, thermal_growth, thermal_clearance, thermal_units, thermal_props.
std::vector<Adapter> thermal_adapters();

/// Families thermal_network, thermal_steps.
std::vector<Adapter> network_adapters();

}  // namespace adore::calculators
