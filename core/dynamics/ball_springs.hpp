#pragma once

#include "contact/angle_law.hpp"

#include <cstddef>

/// Boundary between held_balls.cpp and the translation units that are compiled once per
/// instruction set (reason in race_kernel.hpp): contact/groove_spring.hpp for balls that are held,
/// all identical, on a round race.
namespace adore::dynamics {

struct BallSpringsInput {
  double centre[3], axis[3];             ///< P_j and the axis of the race, base axes
  double centre_radius, offset, K;       ///< as groove_spring() has them
  const contact::HertzAngleLaw* follow;  ///< null: K is that of every angle
  std::size_t n;                         ///< number of held balls, at least 1
  const std::size_t* ball;               ///< their numbers in what follows
  const double *x, *r, *sin_theta, *cos_theta;
};

/// One ball on (e_x, e_r, e_θ) of its azimuth.
struct BallSpring {
  double force[3];                ///< on the ball [N]
  double normal[2];               ///< n_x, n_r
  double xx, xy, xz, yy, yz, zz;  ///< -∂force over the place of the ball [N/m]
};

using BallSpringsKernel = void (*)(const BallSpringsInput& in, BallSpring* out) noexcept;

void ball_springs_baseline(const BallSpringsInput& in, BallSpring* out) noexcept;
#if defined(__x86_64__)
void ball_springs_avx2(const BallSpringsInput& in, BallSpring* out) noexcept;
void ball_springs_avx512(const BallSpringsInput& in, BallSpring* out) noexcept;
#endif

}  // namespace adore::dynamics
