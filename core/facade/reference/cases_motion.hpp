#pragma once

#include "facade/reference/adapter.hpp"

#include <vector>

namespace adore::facade::reference {

/// Families motion_frames, motion_excitations (cage start).
std::vector<Adapter> motion_adapters();

}  // namespace adore::facade::reference
