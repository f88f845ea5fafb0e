#pragma once

#include "reference/adapter.hpp"

#include <vector>

namespace adore::reference {

/// The adapters of every family that the program understands.
[[nodiscard]] std::vector<Adapter> all_adapters();

}  // namespace adore::reference
