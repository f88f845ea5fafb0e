#pragma once

#include "reference/adapter.hpp"

#include <vector>

namespace adore::reference {

/// Families motion_frames, motion_excitations (cage start).
std::vector<Adapter> motion_adapters();

}  // namespace adore::reference
