#pragma once

#include "base/finding.hpp"
#include "statics/ball_race.hpp"

/// From the solved problem to what the outputs and the dynamic start read.
namespace adore::statics {

/// Everything about one ball at its equilibrium.
///
/// Speeds: the force balance uses undeformed radii (spin.hpp). With linear kinematics the same
/// speeds are reported. With exact kinematics the reported ω_m and ω satisfy zero slip at both
/// contact centres of the DEFORMED geometry, with the race poses and the curved contact surface of
/// the dynamic model (height of the contact centre over the ball centre h = ρ - sqrt(ρ²-a²) +
/// sqrt(D²/4-a²)), so that a dynamic run starts without creep; the two differ by about δ/D.
[[nodiscard]] StaticBall report_ball(const BallModel& model, const std::array<double, 5>& q,
                                     const BallState& ball);

/// Largest load, deflection and stiffness, and what the most loaded ball gives.
void fill_summary(const BallModel& model, StaticSolution& solution);

/// Notes about the whole solution: balls without inner contact or load, contact angles beyond 90
/// degrees, ellipses over a shoulder or across a split.
[[nodiscard]] std::vector<Finding> ball_notes(const BallModel& model,
                                              const std::vector<StaticBall>& balls);

}  // namespace adore::statics
