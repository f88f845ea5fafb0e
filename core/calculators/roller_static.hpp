#pragma once

#include "calculators/adapter.hpp"

#include <vector>

namespace adore::calculators {

/// Family D: quasi-static roller bearings.
[[nodiscard]] std::vector<Adapter> roller_static_adapters();

}  // namespace adore::calculators
