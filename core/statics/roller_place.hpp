#pragma once

#include "statics/roller_pose.hpp"

#include <Eigen/Core>

/// Where the search for a roller's equilibrium begins: RollerState::e.
namespace adore::statics {

/// In the middle between both races.
[[nodiscard]] Eigen::Vector3d middle_roller_position(const RollerModel& m, const RollerState& state,
                                                     const Vec5& q);

/// Where a roller stands when nothing is known: at speed on the outer race, about as deep as its
/// centrifugal force presses it, if the inner race does not touch it there; else in the middle.
[[nodiscard]] Eigen::Vector3d initial_roller_position(const RollerModel& m,
                                                      const RollerState& state, const Vec5& q);

/// Pose of a roller relative to race j where the inner race is at q: p of slice_potential.hpp.
[[nodiscard]] Vec4 relative_pose(const RollerModel& m, const RollerState& at, std::size_t j,
                                 const Vec5& q);

}  // namespace adore::statics
