#pragma once

#include "facade/reference/adapter.hpp"

#include <vector>

namespace adore::facade::reference {

/// Families A_hertz_point, C_ball_bearing, E_kinematics, P_published.
std::vector<Adapter> static_adapters();

}  // namespace adore::facade::reference
