#pragma once

#include "validation/adapter.hpp"

#include <vector>

namespace adore::validation {

/// Families F_dynamics and dynamics_impact, _plates, _pocket, _rigid_whirl, _ball_vibration,
/// _ball_thrust, _ball_radial, _roller.
std::vector<Adapter> dynamics_adapters();

}  // namespace adore::validation
