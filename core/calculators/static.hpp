#pragma once

#include "calculators/adapter.hpp"

#include <vector>

namespace adore::calculators {

/// Families A_hertz_point, C_ball_bearing, E_kinematics, P_published.
std::vector<Adapter> static_adapters();

}  // namespace adore::calculators
