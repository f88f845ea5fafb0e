#include "dynamics/mode2.hpp"

#include "base/errors.hpp"
#include "dynamics/stiff_inverse.hpp"
#include "statics/race_equilibrium.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {
namespace {

using statics::RaceScales;
using statics::Vec5;

struct Mode2Balls {
  const ConstrainedBall& ball;
  const std::array<RacePose, 2>& races;  ///< the inner one at displacement 0
  std::span<const double> theta;
  std::span<const Orbit> orbit;

  [[nodiscard]] double play() const { return ball.groove().offset[0] + ball.groove().offset[1]; }
};
struct Mode2Ball {
  std::size_t number = 0;
  bool known = false;
  BallBalance balance;
};
using Mode2Race = statics::RaceState<Mode2Ball>;

// Interface of an element set for race_equilibrium.hpp.
RaceScales race_scales(const Mode2Balls& set) {
  const double radius = set.ball.mid_radius();
  return {radius, 0.25 * set.play(), set.ball.groove().ball_radius + 4.0 * set.play(), 2.0 * radius,
          0.0};
}

double reference_stiffness(const Mode2Balls& set, double load) {
  const double K = std::max(set.ball.hertz_constants()[0], set.ball.hertz_constants()[1]);
  return 1.5 * std::cbrt(K * K * load);
}

bool is_conservative(const Mode2Balls&) { return true; }
double initial_accuracy(const Mode2Balls&) { return 0.0; }

bool update_race(const Mode2Balls& set, const Vec5& q, Mode2Race& state, double = 0.0) {
  std::array<RacePose, 2> at = set.races;
  at[1].centre += q.head<3>();
  state.load.setZero();
  state.stiffness.setZero();
  state.largest_contact = 0.0;
  for (Mode2Ball& element : state.elements) {
    const double theta = set.theta[element.number];
    BallBalance& b = element.balance;
    // First guess: half way between the two groove-center circles' unloaded places.
    const Vec2 from =
        element.known
            ? b.place()
            : set.ball
                  .solve(at, theta, {Orbit::Kept::Speed, 0.0}, Vec2::Zero(),
                         Vec2(0.5 * (at[0].centre[0] + at[1].centre[0]), set.ball.mid_radius()))
                  .place();
    b = set.ball.solve(at, theta, set.orbit[element.number], Vec2::Zero(), from);
    if (!b.solved) return false;
    element.known = true;
    const GrooveContact& inner = b.contact[1];
    const Mat3 frame = azimuth_frame(theta);
    state.load.head<3>() += frame.transpose() * inner.force;
    state.stiffness.topLeftCorner<3, 3>() +=
        frame.transpose() * (inner.stiffness * frame - inner.stiffness.leftCols<2>() *
                                                           sensitivity(b, theta).per_inner_centre);
    state.largest_contact = std::max({state.largest_contact, b.contact[0].load, inner.load});
  }
  state.q = q;
  return true;
}

}  // namespace

Mode2Solution solve_mode2(const ConstrainedBall& ball, const std::array<RacePose, 2>& races,
                          std::span<const double> theta, std::span<const Orbit> orbit,
                          const Vec3& load) {
  demand(theta.size() == orbit.size() && !theta.empty(),
         "mode 2 needs the orbital motion of each ball");
  const Mode2Balls set{ball, races, theta, orbit};
  statics::RaceLoadCase task;
  task.given = {false, false, false, true, true};
  task.load.head<3>() = load;
  Mode2Race state;
  state.elements.resize(theta.size());
  for (std::size_t i = 0; i < theta.size(); ++i) state.elements[i].number = i;

  Mode2Solution result;
  const statics::RaceSolveResult race = statics::solve_race(set, task, state);
  result.solved = race.converged;
  result.iterations = race.iterations;
  result.inner_centre = races[1].centre + state.q.head<3>();
  result.residual = load - state.load.head<3>();
  const Mat3 stiffness = state.stiffness.topLeftCorner<3, 3>();
  const double smallest = std::max(kNoStiffness, 1e-12 * stiffness.trace());
  const Mat3 inverse = stiff_inverse<3>(stiffness, smallest, &result.free_directions);
  Vec3 drift = Vec3::Zero();  // ∂(residual)/∂θ θ̇
  for (const Mode2Ball& element : state.elements) {
    const BallBalance& b = element.balance;
    const double angle = theta[element.number];
    Vec3 per_theta(0.0, 0.0, b.r);
    per_theta.head<2>() = sensitivity(b, angle).per_theta;
    drift += azimuth_frame(angle).transpose() * (b.contact[1].stiffness * per_theta * b.speed);
    result.balls.push_back(b);
  }
  result.inner_velocity = inverse * drift;
  return result;
}

}  // namespace adore::dynamics
