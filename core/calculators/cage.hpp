#pragma once

#include "calculators/adapter.hpp"

#include <vector>

namespace adore::calculators {

/// Families cage_pockets, cage_lands, cage_inertia.
std::vector<Adapter> cage_adapters();

}  // namespace adore::calculators
