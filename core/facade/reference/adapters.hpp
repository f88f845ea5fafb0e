#pragma once

#include "facade/reference/adapter.hpp"

#include <vector>

namespace adore::facade::reference {

/// The adapters of every family that the program understands.
[[nodiscard]] std::vector<Adapter> all_adapters();

}  // namespace adore::facade::reference
