#pragma once

#include "statics/ball_forces.hpp"

#include <Eigen/Core>

/// Equilibrium of one ball between two races held in place.
namespace adore::statics {

/// Derivatives over the ball (0: x, 1: rho) and the race (2-6); one unused, so that loops fill
/// vector registers.
using RaceDual = Dual<8>;

/// Where a ball is, and how it moves with the inner race.
struct BallState {
  BallSite site;
  double x = 0.0, rho = 0.0;  ///< centre: axial, and radial minus d_m/2 [m]
  bool known = false;         ///< x, rho come from an earlier equilibrium
  bool idle = false;          ///< still bearing, touches at most one race: carries nothing
  Eigen::Matrix<double, 2, 5> follow =
      Eigen::Matrix<double, 2, 5>::Zero();  ///< d(x, rho)/d(race displacement)
};

/// Share of one ball in the load on the inner race and its exact derivative with the ball kept in
/// equilibrium.
struct BallLoadContribution {
  Eigen::Matrix<double, 5, 1> load = Eigen::Matrix<double, 5, 1>::Zero();
  Eigen::Matrix<double, 5, 5> stiffness = Eigen::Matrix<double, 5, 5>::Zero();
  double largest_load = 0.0;  ///< of its contacts [N]
};

/// Finds the ball's equilibrium for the inner race in a given pose: Newton with backtracking on the
/// residual force, from the given position when known, else from the line of groove centres.
/// Without gyroscopic moment and with fixed K and ω_m the residual is the gradient of a convex
/// potential, so the solution is unique and always found. Returns false when no start leads to an
/// equilibrium (only possible with gyroscopic or angle-dependent terms).
/// @param accuracy residual force over the sum of loads from which one more step, which is left to
/// ball_share(), is enough; 0: down to rounding
[[nodiscard]] bool solve_ball(const BallModel& model, const RacePose<double>& race, BallState& ball,
                              double accuracy = 0.0);

/// Load share and stiffness at the equilibrium found by solve_ball; also refreshes ball.follow.
/// @param last_step takes one more Newton step, in the ball's place and to first order in its load
[[nodiscard]] BallLoadContribution ball_share(const BallModel& model,
                                              const RacePose<RaceDual>& race, BallState& ball,
                                              bool last_step = false);

}  // namespace adore::statics
