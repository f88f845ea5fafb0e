#pragma once

#include "facade/reference/adapter.hpp"

#include <vector>

namespace adore::facade::reference {

/// Families thermal_lame, thermal_growth, thermal_clearance, thermal_units, thermal_props.
std::vector<Adapter> thermal_adapters();

}  // namespace adore::facade::reference
