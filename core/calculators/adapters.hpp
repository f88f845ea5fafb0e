#pragma once

#include "calculators/adapter.hpp"

#include <vector>

namespace adore::calculators {

/// Of every family whose cases one component of a bearing answers by itself.
[[nodiscard]] std::vector<Adapter> component_adapters();

}  // namespace adore::calculators
