#pragma once

#include "dynamics/bodies.hpp"

namespace adore::dynamics {

/// Specified load of an inner race in force balance (mode 2), and its actual load
/// from the bearing, along the directions whose load is given [N, base axes].
struct RaceLoad {
  Vec3 asked = Vec3::Zero(), carried = Vec3::Zero();
};

}  // namespace adore::dynamics
