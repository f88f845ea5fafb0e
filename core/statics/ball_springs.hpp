#pragma once

#include "statics/ball_model.hpp"
#include "statics/race_equilibrium.hpp"

/// The inner race on springs in the place of balls, as a start for the race on balls.
///
/// Spring of a ball: both contacts in series between the groove centres of its azimuth, where no
/// force acts on the ball itself: with A from the outer to the inner groove centre and S the sum of
/// the offsets (groove radii minus ball radii)
///   δ = |A| - S,  Q = K δ^1.5,  K^(-2/3) = K_o^(-2/3) + K_i^(-2/3)
/// [harris2006], constants of the free angle. A is linear in the displacement q of the race
/// (small tilts), so that V = Σ 0.4 K δ^2.5 is convex. Left out: centrifugal force, gyroscopic
/// moment, K over the angle, balls of their own size.
namespace adore::statics {

struct BallSprings {
  const BallModel& model;
};
/// Of the azimuth of a ball.
struct BallSpring {
  double sin = 0.0, cos = 1.0;
};

[[nodiscard]] RaceScales race_scales(const BallSprings& springs);
[[nodiscard]] double reference_stiffness(const BallSprings& springs, double load);
[[nodiscard]] inline bool is_conservative(const BallSprings&) { return true; }
[[nodiscard]] inline double initial_accuracy(const BallSprings&) { return 0.0; }
bool update_race(const BallSprings& springs, const Vec5& q, RaceState<BallSpring>& state,
                 double accuracy = 0.0);

/// Equilibrium on the springs to a hundredth of the load, from q; q where there is none.
[[nodiscard]] Vec5 guess_by_springs(const BallModel& model, const RaceLoadCase& task,
                                    const Vec5& q);

}  // namespace adore::statics
