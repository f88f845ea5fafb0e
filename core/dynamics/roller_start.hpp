#pragma once

#include "base/rotation.hpp"
#include "dynamics/effects/rigid_elements.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"

#include <vector>

/// Start of rollers: at the positions of the equilibrium (statics/roller_statics.hpp), with skew
/// and speeds of its balance of friction; rollers without one without skew and with the speeds of
/// pure rolling at nominal geometry. friction_start.hpp then balances all effects of the run.
namespace adore::dynamics {

/// A roller bearing's equilibrium, and the options that it was found with.
struct RollerStaticResult {
  statics::RollerOptions options;
  statics::RollerSolution solution;
};

/// Mass center, speeds and attitude of every roller: C from StaticRoller, G = C + s_G a; ω = ω_m
/// e_x
/// + ω_s a; body x along a, body z outwards.
[[nodiscard]] std::vector<ElementStartState> start_poses(const RollerStaticResult& scene,
                                                         const bearing::Bearing& bearing);

/// The same as a scene's static solution, which knows places, speeds and loads of elements only.
[[nodiscard]] statics::StaticSolution static_start(const RollerStaticResult& scene,
                                                   const bearing::Bearing& bearing);

}  // namespace adore::dynamics
