#include "../statics/ball_bearings.hpp"
#include "base/errors.hpp"
#include "contact/make_angle_law.hpp"
#include "dynamics/constrained.hpp"
#include "dynamics/excitations.hpp"
#include "dynamics/mode2.hpp"
#include "dynamics/moving_frame.hpp"
#include "statics/ball_statics.hpp"
#include "statics/race_pose.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::dynamics;

namespace {

constexpr double kDiameter = 0.0127, kMass = 8.4e-3;

contact::GrooveGeometry groove() {
  contact::GrooveGeometry g;
  g.ball_radius = 0.5 * kDiameter;
  g.groove_radius = {0.52 * kDiameter, 0.515 * kDiameter};
  g.offset = {0.02 * kDiameter, 0.015 * kDiameter};
  g.centre_radius = {0.03477, 0.03517};
  return g;
}

const ConstrainedBall kBall(groove(), {9.6e9, 9.1e9}, kMass);

/// The same with constants that follow the contact angle, exaggerated by a small pitch circle.
const ConstrainedBall& following_ball() {
  static const ConstrainedBall ball = [] {
    bearing::BallGeometry b;
    b.diameter = kDiameter;
    b.pitch_diameter = 0.035;
    b.groove_factor = {0.52, 0.515};
    const std::array<contact::HertzAngleLaw, 2> law{contact::make_angle_law(b, 0, 1.1e11),
                                                    contact::make_angle_law(b, 1, 1.1e11)};
    return ConstrainedBall(groove(), {1.0, 1.0}, kMass, law);
  }();
  return ball;
}
/// Tilted and displaced, so that no derivative vanishes by symmetry.
const std::array<RacePose, 2> kRaces{
    RacePose{{1e-6, 0.0, 2e-6}, Vec3(1.0, 2e-4, 1e-4).normalized()},
    RacePose{{2.0e-4, 3e-6, -8e-6}, Vec3::UnitX()}};
const Vec2 kGuess(1e-4, 0.03501);

bool positive(const Mat2& m) {
  return Eigen::SelfAdjointEigenSolver<Mat2>(m).eigenvalues().minCoeff() > 0.0;
}

}  // namespace

TEST_CASE("balance: stationary point of its potential", "[physics][constrained]") {
  const bool follows = GENERATE(false, true);
  const ConstrainedBall& ball = follows ? following_ball() : kBall;
  const Vec2 force(1.5, -4.0), place(9e-5, 0.035013);
  for (const Orbit& orbit : {Orbit{Orbit::Kept::Speed, 900.0},
                             Orbit{Orbit::Kept::Momentum, kMass * 0.035 * 0.035 * 900.0}}) {
    const auto at = [&](const Vec2& p, double theta, double value) {
      return ball.evaluate(kRaces, theta, {orbit.kept, value}, force, p);
    };
    const BallBalance b = at(place, 2.6, orbit.value);
    REQUIRE(b.contact[0].load > 0.0);
    REQUIRE(b.contact[1].load > 0.0);
    const double h = 1e-9;  // central differences: h² terms 1e-6 relative at δ of some 1e-6 m
    for (int k = 0; k < 2; ++k) {
      const Vec2 d = h * Vec2::Unit(k);
      const BallBalance up = at(place + d, 2.6, orbit.value),
                        down = at(place - d, 2.6, orbit.value);
      CHECK((down.potential - up.potential) / (2 * h) == Approx(b.residual[k]).epsilon(1e-5));
      const Vec2 slope = (down.residual - up.residual) / (2 * h);
      CHECK((slope - b.stiffness.col(k)).norm() < 1e-5 * b.stiffness.norm());
    }
    const BallBalance left = at(place, 2.6 - 1e-5, orbit.value);
    const BallBalance right = at(place, 2.6 + 1e-5, orbit.value);
    CHECK(((right.residual - left.residual) / 2e-5 - b.per_theta).norm() <
          1e-5 * b.per_theta.norm());
    const double dv = 1e-5 * orbit.value;
    const BallBalance slow = at(place, 2.6, orbit.value - dv);
    const BallBalance fast = at(place, 2.6, orbit.value + dv);
    CHECK(((fast.residual - slow.residual) / (2 * dv) - b.per_orbit).norm() <
          1e-6 * b.per_orbit.norm());
  }
}

TEST_CASE("balance: loaded ball → unique, found from far away", "[physics][constrained]") {
  const Orbit orbit{Orbit::Kept::Momentum, kMass * 0.035 * 0.035 * 420.0};
  const BallBalance near = kBall.solve(kRaces, 2.6, orbit, Vec2::Zero(), kGuess);
  REQUIRE(near.solved);
  CHECK(positive(near.stiffness));
  CHECK(near.contact[0].load > near.contact[1].load);  // the orbit presses outwards
  for (const Vec2& away : {Vec2(0.0, 0.0349), Vec2(2e-4, 0.03506), Vec2(-5e-5, 0.035)}) {
    const BallBalance far = kBall.solve(kRaces, 2.6, orbit, Vec2::Zero(), away);
    REQUIRE(far.solved);
    CHECK((far.place() - near.place()).norm() < 1e-12);  // contact stiffness 1e7 N/m, 1e-6 N left
    CHECK(far.iterations < 60);
  }
}

TEST_CASE("balance: unloaded ball → idle position as its orbit slows down",
          "[physics][constrained]") {
  std::array<RacePose, 2> races = kRaces;
  races[1].centre = {1.68e-4, 0.0, -6e-5};  // opens the inner contact
  const BallBalance idle = kBall.solve(races, 0.3, {}, Vec2::Zero(), kGuess);
  REQUIRE(idle.solved);
  CHECK(idle.contact[1].approach < 0.0);
  CHECK(std::abs(idle.contact[0].approach) < 1e-16);
  double last = 1.0;
  for (const double speed : {300.0, 30.0, 3.0}) {
    const BallBalance b =
        kBall.solve(races, 0.3, {Orbit::Kept::Speed, speed}, Vec2::Zero(), kGuess);
    REQUIRE(b.solved);
    const double distance = (b.place() - idle.place()).norm();
    // Q = m r θ̇² pushes by (Q/K)^(2/3): ten times slower, 10^(4/3) = 21.5 times nearer.
    if (last < 1.0) CHECK(last / distance == Approx(std::pow(10.0, 4.0 / 3.0)).epsilon(0.02));
    last = distance;
  }
}

TEST_CASE("balance: ball without orbit pressed inwards → rests on the inner race",
          "[physics][constrained]") {
  std::array<RacePose, 2> races = kRaces;
  races[1].centre = {1e-5, 0.0, -6e-5};
  const BallBalance b = kBall.solve(races, 0.3, {}, Vec2(0.0, -5.0), kGuess);
  REQUIRE(b.solved);
  CHECK(b.contact[0].load == 0.0);
  CHECK(b.x == Approx(1e-5).margin(1e-12));  // groove bottom of the untilted inner race
  // n points at the race axis, e_r at the base axis: cosine differs from 1 by (6e-5/0.035)²/2.
  CHECK(b.contact[1].load == Approx(5.0).epsilon(1e-5));
}

TEST_CASE("balance: implicit rates are its time derivatives", "[physics][constrained]") {
  const double theta = 0.7, speed = 420.0;
  const Orbit orbit{Orbit::Kept::Momentum, kMass * 0.035 * 0.035 * speed};
  const BallBalance b = kBall.solve(kRaces, theta, orbit, Vec2::Zero(), kGuess);
  const double orbit_rate = b.r * b.force_theta;
  const Vec2 rates = implicit_rates(sensitivity(b, theta), b.speed, orbit_rate);
  const auto at = [&](double t) {
    return kBall.solve(kRaces, theta + b.speed * t, {orbit.kept, orbit.value + orbit_rate * t},
                       Vec2::Zero(), b.place());
  };
  // Nothing outside acts, so L²/(2mr²) + V stays although ẋ and ṙ are dropped: what the parts
  // exchange in 2t, F_θ r θ̇ 2t, cancels up to the third order, a quarter of it at half the time.
  const auto relative_gain = [&](double t) {
    return (at(t).potential - at(-t).potential) / (b.force_theta * b.r * b.speed * 2.0 * t);
  };
  const BallBalance before = at(-1e-5), after = at(1e-5);
  CHECK(((after.place() - before.place()) / 2e-5 - rates).norm() < 1e-4 * rates.norm());
  CHECK(std::abs(relative_gain(1e-5)) < 1e-4);
  CHECK(relative_gain(1e-4) / relative_gain(5e-5) == Approx(4.0).epsilon(0.05));
}

TEST_CASE("mode 2: direction without stiffness → position kept", "[physics][constrained]") {
  const std::vector<double> theta{0.1, 2.2, 4.3};
  const std::vector<Orbit> orbit(3, Orbit{Orbit::Kept::Speed, 300.0});
  std::array<RacePose, 2> races = kRaces;
  races[0] = {};
  races[1].centre = {0.0, 0.0, 0.0};  // ample clearance: no inner contact at all
  auto loose = groove();
  loose.centre_radius[1] -= 2e-4;
  const Mode2Solution open =
      solve_mode2(ConstrainedBall(loose, {9.6e9, 9.1e9}, kMass), races, theta, orbit, Vec3::Zero());
  CHECK(open.free_directions.size() == 3);
  CHECK(open.inner_centre == races[1].centre);
  CHECK(open.solved);

  races[1].centre = {2e-4, 0.0, 0.0};
  const Vec3 load(900.0, 150.0, -400.0);
  const Mode2Solution closed = solve_mode2(kBall, races, theta, orbit, load);
  REQUIRE(closed.solved);
  CHECK(closed.free_directions.empty());
  CHECK(closed.residual.norm() < 1e-6);
}

TEST_CASE("mode 2: unloaded race → moves until balls carry its load", "[physics][constrained]") {
  const std::vector<double> theta{0.1, 2.2, 4.3};
  const std::vector<Orbit> orbit(3, Orbit{Orbit::Kept::Speed, 300.0});
  auto loose = groove();
  loose.centre_radius[1] -= 2e-4;
  const Vec3 load(20.0, 5.0, -10.0);
  const Mode2Solution s =
      solve_mode2(ConstrainedBall(loose, {9.6e9, 9.1e9}, kMass), {}, theta, orbit, load);
  REQUIRE(s.solved);
  CHECK(s.residual.norm() < 1e-9);
  CHECK(s.inner_centre[0] > 1e-4);
}

TEST_CASE("motion: loads of statics at the positions of statics", "[physics][constrained]") {
  auto bearing = ball_bearings::spindle(20000.0);
  ball_bearings::load(bearing, 300.0, 40.0, 100.0, 1.5, -0.5);
  const auto s = statics::solve_ball_statics(bearing);
  const auto groove = contact::groove_geometry(bearing.balls());
  const auto& q = s.displacement;
  const auto axis = statics::tilted_axis(q[3], q[4]);
  const std::array<RacePose, 2> races{
      RacePose{{groove.centre_x[0], 0.0, 0.0}, Vec3::UnitX()},
      RacePose{{q[0] + groove.centre_x[1], q[1], q[2]}, {axis.x, axis.y, axis.z}}};
  for (const statics::StaticBall& b : s.balls) {
    const ConstrainedBall ball(groove, {b.K[0], b.K[1]}, bearing.element_inertia.mass);
    const BallBalance at = ball.evaluate(races, b.azimuth, {}, Vec2::Zero(), Vec2(b.x, b.r));
    for (std::size_t j = 0; j < 2; ++j) {
      REQUIRE(b.Q[j] > 0.0);
      // Rounding of 27 mm, 4e-18 m, over approaches of some 1e-6 m.
      CHECK(at.contact[j].load == Approx(b.Q[j]).epsilon(1e-11));
      CHECK(at.contact[j].angle == Approx(b.alpha[j]).epsilon(1e-11));
    }
  }
}

TEST_CASE("light-load balance: hysteresis of the switches, and kDOF by code",
          "[unit][constrained]") {
  CHECK(is_quasi_static_next(false, 10.0, 10.0));
  CHECK_FALSE(is_quasi_static_next(false, 10.5, 10.0));
  CHECK(is_quasi_static_next(true, 10.5, 10.0));
  CHECK_FALSE(is_quasi_static_next(true, 11.1, 10.0));
  CHECK_FALSE(is_quasi_static_next(true, 0.0, 0.0));
  std::array<double, 6> element{1, 2, 3, 4, 5, 6}, cage = element;
  suppress_accelerations(3, element, cage);
  CHECK(element == std::array<double, 6>{0, 2, 3, 4, 5, 6});
  CHECK(cage == std::array<double, 6>{1, 2, 3, 4, 5, 6});
  CHECK_THROWS_AS(suppress_accelerations(6, element, cage), InputError);
}

TEST_CASE("prescribed motions: consistent in time", "[physics][excitations]") {
  const RotatingLoad load({Vec3(0, 1e-6, 0), Vec3(1.2e-5, 3e-6, -1.9e-5)}, {0.2, 0.7},
                          {-300.0, 600.0});
  const double h = 1e-6;
  for (int race = 0; race < 2; ++race) {
    const auto before = load.at(race, 0.011 - h), now = load.at(race, 0.011),
               after = load.at(race, 0.011 + h);
    CHECK(((after.position - before.position) / (2 * h) - now.velocity).norm() <
          1e-6 * now.velocity.norm());
    CHECK(((after.velocity - before.velocity) / (2 * h) - now.acceleration).norm() <
          1e-6 * now.acceleration.norm());
  }
  const SpeedRamp ramp{2e4, 0.01, 0.03};
  for (const double t : {0.005, 0.02, 0.05}) {
    CHECK((ramped_rotation(600.0, ramp, t + h).angle - ramped_rotation(600.0, ramp, t - h).angle) /
              (2 * h) ==
          Approx(ramped_rotation(600.0, ramp, t).speed));
    CHECK((varying_rotation(600.0, 60.0, 25.0, t + h).angle -
           varying_rotation(600.0, 60.0, 25.0, t - h).angle) /
              (2 * h) ==
          Approx(varying_rotation(600.0, 60.0, 25.0, t).speed));
  }
}

TEST_CASE("moving frame: body at rest in space turns backwards", "[physics][frames]") {
  const MovingFrame frame{120.0, 0.085, 0.4};
  const Vec3 at(0.001, -0.012, 0.019);
  const Vec3 arm = frame.orbit_radius * radial_direction(frame.orbit_angle) + at;
  const Vec3 velocity = -frame.speed * Vec3::UnitX().cross(arm);
  // Seen from the frame it circles the fixed axis: centripetal acceleration -Ω² arm.
  const Vec3 needed = -frame.speed * frame.speed * Vec3(0.0, arm[1], arm[2]);
  CHECK((frame.inertial_force(1.0, at, velocity) - needed).norm() < 1e-12 * needed.norm());
}
