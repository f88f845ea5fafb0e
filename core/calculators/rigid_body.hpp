#pragma once

#include "calculators/adapter.hpp"
#include "dynamics/rigid_body.hpp"

#include <vector>

namespace adore::calculators {

/// From mass, principal moments, the angles of their frame and the place of the geometric center.
[[nodiscard]] dynamics::RigidBody rigid_body(const Json& inputs);

/// Family motion_frames, kind rigid_body: accelerations of a rigid body under a force and a moment.
[[nodiscard]] std::vector<Adapter> rigid_body_adapters();

}  // namespace adore::calculators
