#pragma once

#include "facade/reference/adapter.hpp"

#include <vector>

namespace adore::facade::reference {

/// Family D: quasi-static roller bearings.
[[nodiscard]] std::vector<Adapter> roller_static_adapters();

}  // namespace adore::facade::reference
