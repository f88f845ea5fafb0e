#pragma once

#include "statics/ball_equilibrium.hpp"
#include "statics/race_equilibrium.hpp"

/// The inner race on balls: what race_equilibrium.hpp asks of an element set.
namespace adore::statics {

using BallRace = RaceState<BallState>;

/// Rotations are measured on the groove-centre circle.
[[nodiscard]] RaceScales race_scales(const BallModel& model);

/// Stiffness of one contact under the load: the measure of "no stiffness".
[[nodiscard]] double reference_stiffness(const BallModel& model, double load);

/// With fixed K and speeds (own_speed_share = 0, or a bearing at rest at fixed curvatures) the race
/// load is the gradient of a convex potential.
[[nodiscard]] bool is_conservative(const BallModel& model);

[[nodiscard]] inline double initial_accuracy(const BallModel&) { return 1e-3; }

/// Re-solves every ball for displacement q. False when a ball has no equilibrium.
[[nodiscard]] bool update_race(const BallModel& model, const Vec5& q, BallRace& state,
                               double accuracy = 0.0);

/// Cold start: thrust and radial load brought to first contact plus an estimate of the deflection.
[[nodiscard]] Vec5 first_guess(const BallModel& model, const RaceLoadCase& task, const Vec5& given);

}  // namespace adore::statics
