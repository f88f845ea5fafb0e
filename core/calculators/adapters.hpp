#pragma once

#include "calculators/adapter.hpp"

#include <vector>

namespace adore::calculators {

/// Families whose cases need only one component of a bearing.
[[nodiscard]] std::vector<Adapter> component_adapters();

}  // namespace adore::calculators
