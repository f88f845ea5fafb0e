#pragma once

#include "dynamics/constrained.hpp"

#include <array>
#include <span>
#include <vector>

/// Balls and the inner race in balance (mode 2): load + Σ (force of the balls on the inner race) =
/// 0. The balls of constrained.hpp are an element set of statics/race_equilibrium.hpp, whose Newton
/// solves for the center of the race with its axis held; the race stiffness by the Schur complement
///   K_c = Σ [S_i - S_i J B⁻¹ Jᵀ S_i],  S_i inner contact stiffness, B of the ball, J = (e_x, e_r).
namespace adore::dynamics {

struct Mode2Solution {
  std::vector<BallBalance> balls;
  Vec3 inner_centre = Vec3::Zero();
  Vec3 residual = Vec3::Zero();        ///< [N]
  Vec3 inner_velocity = Vec3::Zero();  ///< when all balls orbit at their θ̇, θ̈ = 0 [m/s]
  std::vector<Vec3> free_directions;   ///< unit vectors without stiffness: held at the guess
  int iterations = 0;
  bool solved = false;
};
/// A direction in which nothing holds the race stays at its guess, unless the load pushes along it:
/// then the race walks until balls touch.
/// @param races the inner center is the first guess
/// @param theta, orbit one per ball
[[nodiscard]] Mode2Solution solve_mode2(const ConstrainedBall& ball,
                                        const std::array<RacePose, 2>& races,
                                        std::span<const double> theta, std::span<const Orbit> orbit,
                                        const Vec3& load);

}  // namespace adore::dynamics
