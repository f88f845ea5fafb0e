#pragma once

#include "base/finding.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

/// Motion of balls whose friction is in balance (ball_friction.hpp).
namespace adore::statics {

struct StaticBall;
struct StaticSolution;

struct BallMotion {
  Eigen::Vector3d omega =
      Eigen::Vector3d::Zero();    ///< on (e_x, e_r, e_θ), in the base frame [rad/s]
  double orbit = 0.0;             ///< ω_m [rad/s]
  std::array<double, 2> along{};  ///< traction on the ball along the major axis, by race [N]
  std::array<double, 2> into{};   ///< the same along the normal of both halves of a split race [N]
  bool balanced = false;          ///< false: no slip at the contact centres, spin by kAngVel
};

struct FrictionBalance {
  std::vector<BallMotion> balls;  ///< empty: not computed
  std::string failure;            ///< why it was given up for the whole bearing; empty: it was not
  std::vector<std::size_t> left;  ///< loaded balls without a balance, from 0
  std::string without_cage;  ///< why balls that need their cage orbit without it; empty: they do
                             ///< not (decision 881)
  /// Largest moment that turns a spin axis along the orbit, over the friction moment
  /// (spin_lag.hpp).
  double turning = 0.0;
  std::size_t turning_ball = 0;  ///< of that moment, from 0
  std::string without_turning;   ///< why that moment was left out; empty: it was not

  /// Stiffness without the slopes of the tractions, because no equilibrium was found with them.
  bool plain_stiffness = false;

  /// Of ball k: in balance, or that of the solution.
  [[nodiscard]] BallMotion motion_of(std::size_t k, const StaticBall& ball) const;
  /// Orbit and angular velocity of the balls in balance, which start a motion.
  void copy_speeds_to(StaticSolution& solution) const;
  /// Equilibria that were not found, and those used instead. Empty: none, or nothing was computed.
  [[nodiscard]] std::vector<Finding> findings() const;
};

}  // namespace adore::statics
