#pragma once

#include "statics/ball_equilibrium.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

/// Equilibrium of the inner race on its balls.
namespace adore::statics {

using Vec5 = Eigen::Matrix<double, 5, 1>;
using Mat5 = Eigen::Matrix<double, 5, 5>;

/// What is asked of the inner race.
struct RaceTask {
  std::array<bool, 5> given{};  ///< displacement given (else the load is)
  Vec5 load = Vec5::Zero();     ///< where not given [N, N m]
};

/// The race at one displacement with every ball in equilibrium.
struct RaceState {
  Vec5 q = Vec5::Zero();          ///< displacement [m, rad]
  Vec5 load = Vec5::Zero();       ///< carried by the balls [N, N m]
  Mat5 stiffness = Mat5::Zero();  ///< d load / d q
  std::vector<BallState> balls;
  double largest_contact = 0.0;  ///< [N]
};

struct RaceSolve {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;     ///< largest force residual over the force scale
  bool ball_failed = false;  ///< some ball had no equilibrium on the way
  bool ran_away = false;     ///< the race left the space in which balls could hold it
  std::vector<int> held;     ///< free directions without stiffness and load, left where they were
};

/// Re-solves every ball for displacement q. False when a ball has no equilibrium.
[[nodiscard]] bool update_race(const BallModel& model, const Vec5& q, RaceState& state);

/// Largest force that the problem speaks of: applied loads (moments over the groove-centre radius),
/// else contact loads.
[[nodiscard]] double force_scale(const BallModel& model, const RaceTask& task,
                                 const RaceState& state);

/// Newton on the free directions from state.q. With the conservative model (own_speed_share = 0)
/// the race load is the gradient of a convex potential: a line search on the directional derivative
/// converges from anywhere. With the full model steps must reduce the residual. Directions without
/// stiffness are left alone when unloaded and walked along the load, a quarter of the groove
/// offsets at a time, until balls touch.
[[nodiscard]] RaceSolve solve_race(const BallModel& model, const RaceTask& task, RaceState& state,
                                   double target = 1e-12);

/// Cold start: thrust and radial load brought to first contact plus an estimate of the deflection.
[[nodiscard]] Vec5 first_guess(const BallModel& model, const RaceTask& task, const Vec5& given);

}  // namespace adore::statics
