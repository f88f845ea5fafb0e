#pragma once

#include "validation/adapter.hpp"

#include <vector>

namespace adore::validation {

/// Families motion_frames, motion_excitations (cage start).
std::vector<Adapter> motion_adapters();

}  // namespace adore::validation
