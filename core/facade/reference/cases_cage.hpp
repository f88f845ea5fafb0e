#pragma once

#include "facade/reference/adapter.hpp"

#include <vector>

namespace adore::facade::reference {

/// Families cage_pockets, cage_lands, cage_inertia.
std::vector<Adapter> cage_adapters();

}  // namespace adore::facade::reference
