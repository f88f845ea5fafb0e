#pragma once

#include "dynamics/bodies.hpp"

namespace adore::dynamics {

/// What an inner race in force balance (mode 2) is asked to carry, and what the bearing carries of
/// it, along the directions whose load is given [N, base axes].
struct RaceLoad {
  Vec3 asked = Vec3::Zero(), carried = Vec3::Zero();
};

}  // namespace adore::dynamics
