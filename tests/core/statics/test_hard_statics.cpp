#include "base/errors.hpp"
#include "core/statics/ball_bearings.hpp"
#include "core/statics/solution_checks.hpp"
#include "statics/ball_statics.hpp"
#include "statics/race_equilibrium.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace adore;
using namespace adore::statics;
using namespace ball_bearings;
using namespace solution_checks;

namespace {

/// Solves and checks what holds for every solution, and that loads and contact states agree.
StaticSolution solved(const Bearing& bearing, const BallStaticsOptions& options = {}) {
  StaticSolution s = solve_ball_statics(bearing, options);
  check_race(bearing, s);
  for (const StaticBall& b : s.balls) {
    for (std::size_t j = 0; j < 2; ++j) {
      REQUIRE(b.Q[j] >= 0.0);
      REQUIRE(std::isfinite(b.alpha[j]) == (b.Q[j] > 0.0));
    }
    REQUIRE(
        std::isfinite(b.x + b.r + b.omega_x + b.omega_r + b.orbital_speed + b.centrifugal_force));
    CHECK(b.inner_contact == (b.Q[1] > 0.0));
  }
  return s;
}

int loaded_balls(const StaticSolution& s) {
  return static_cast<int>(std::count_if(s.balls.begin(), s.balls.end(),
                                        [](const StaticBall& b) { return b.inner_contact; }));
}

}  // namespace

TEST_CASE("without load and speed the race stays where it is, with a note",
          "[physics][statics][hard]") {
  for (Bearing bearing : {angular_contact_218(), deep_groove(1.5e-5), deep_groove(0.0)}) {
    const auto s = solved(bearing);
    CHECK(s.displacement == std::array<double, 5>{});
    CHECK(s.max_load == 0.0);
    CHECK(s.max_stiffness == 0.0);
    CHECK(s.stiffness.isZero());
    CHECK(noted(s, "the inner race has no load and no support along x"));
    CHECK(noted(s, "no load"));
  }
}

TEST_CASE("without load at speed the balls ride on the outer race", "[physics][statics][hard]") {
  const auto s = solved(deep_groove(1.5e-5, 6000.0));
  CHECK(loaded_balls(s) == 0);
  for (const auto& b : s.balls) CHECK(b.Q[0] == Approx(b.centrifugal_force).epsilon(1e-10));
  CHECK(noted(s, "outer race only"));
  // An angular contact bearing lets its race slip back until no ball is touched.
  const auto a = solved(angular_contact_218(6000.0));
  CHECK(a.displacement[0] < 0.0);
}

TEST_CASE("radial load with clearance on a single ball", "[physics][statics][hard]") {
  Bearing bearing = deep_groove(1.5e-5);
  for (double force : {1e-3, 1.0, 5.0}) {
    load(bearing, 0, 0, force);
    const auto s = solved(bearing);
    CHECK(loaded_balls(s) == 1);
    CHECK(s.balls[0].Q[0] == Approx(force).epsilon(1e-7));
    // Clearance and the two approaches add up: u = Pd/2 + (Q/K)^(2/3).
    const double approach = s.balls[0].delta[0] + s.balls[0].delta[1];
    CHECK(s.displacement[2] == Approx(7.5e-6 + approach).epsilon(1e-9));
  }
}

TEST_CASE("a load that just unloads the other balls", "[physics][statics][hard]") {
  // Between one and three loaded balls the solution passes the opening of contacts; it must exist
  // on both sides of it.
  Bearing bearing = deep_groove(1.5e-5);
  int previous = 0;
  for (double force = 1.0; force < 100.0; force *= 1.05) {
    load(bearing, 0, 0, force);
    const int now = loaded_balls(solved(bearing));
    CHECK(now >= previous);
    previous = now;
  }
  CHECK(previous == 3);
  // The same with spinning balls, where a contact that opens changes the ball's speed.
  Bearing spinning = make(16, 0.0127, 0.07, 0.52, 0.52, 15.0, 0.0, 12000.0);
  for (double force = 100.0; force < 1500.0; force *= 1.1) {
    load(spinning, 1000, 0, force);
    CHECK(solved(spinning).residual < 1e-10);
  }
}

TEST_CASE("zero and negative clearance", "[physics][statics][hard]") {
  Bearing bearing = deep_groove(0.0);
  CHECK(loaded_balls(solved(load(bearing, 0, 0, 100))) == 5);
  solved(load(bearing, 1000, 0, 0));
  solved(load(bearing, 1e-3, 0, 0));
  Bearing tight = deep_groove(-2e-5);
  const auto preloaded = solved(tight);
  CHECK(loaded_balls(preloaded) == 9);
  CHECK(preloaded.max_load > 100.0);
  CHECK(preloaded.stiffness(0, 0) > 0.0);
  CHECK(loaded_balls(solved(load(tight, 0, 0, 1000))) == 9);
  tight.speed[1] = 600.0;
  solved(load(tight, 100, 0, 1000));
}

TEST_CASE("from one ball to two hundred", "[physics][statics][hard]") {
  for (int count : {3, 4, 41, 200}) {
    const double dm = count > 40 ? count * 0.0127 * 1.1 / std::numbers::pi : 0.07;
    Bearing bearing = make(count, 0.0127, dm, 0.52, 0.525, 20.0, 0.0, 3000.0);
    solved(load(bearing, 2000, 0, 1000));
    solved(load(bearing, 0, 0, 1000));
  }
  Bearing one = make(1, 0.0127, 0.07, 0.52, 0.525, 20.0, 0.0, 3000.0);
  solved(load(one, 0, 0, 1000));
  // One ball cannot carry thrust without a moment: there is nothing to find, and the message says
  // so.
  CHECK_THROWS_AS(solve_ball_statics(load(one, 2000, 0, 1000)), SolverError);
  CHECK_THROWS_WITH(solve_ball_statics(load(one, 2000, 0, 1000)),
                    Catch::Contains("no ball supports the inner race"));
  // Two balls give no support across their plane.
  Bearing two = make(2, 0.0127, 0.07, 0.52, 0.525, 0.0, 0.0);
  CHECK_THROWS_WITH(solve_ball_statics(load(two, 0, 500, 0)),
                    Catch::Contains("which is outside the grooves"));
}

TEST_CASE("three million n d_m", "[physics][statics][hard]") {
  for (auto rule : {bearing::SpinRule::RaceControl, bearing::SpinRule::MinimumHeat}) {
    Bearing bearing = spindle(3e6 / 54);
    bearing.spin_rule = rule;
    for (double thrust : {50.0, 400.0, 4000.0}) {
      const auto s = solved(load(bearing, thrust, 0, 0));
      CHECK(s.balls[0].alpha[1] >
            s.balls[0].alpha[0]);  // centrifugal force flattens the outer angle
      solved(load(bearing, thrust, 0, 0.8 * thrust));
    }
  }
}

TEST_CASE("reversed thrust gives negative contact angles", "[physics][statics][hard]") {
  for (double angle : {15.0, 25.0, 40.0, 60.0}) {
    Bearing bearing = make(16, 0.0127, 0.07, 0.52, 0.52, angle);
    const auto plus = solved(load(bearing, 5000, 0, 0));
    const auto minus = solved(load(bearing, -5000, 0, 0));
    CHECK(minus.balls[0].alpha[0] == Approx(-plus.balls[0].alpha[0]).epsilon(1e-8));
    CHECK(minus.max_load == Approx(plus.max_load).epsilon(1e-8));
    solved(load(bearing, -500, 0, 2000));
    solved(load(bearing, 0, 0, 2000));
    solved(load(bearing, 0, 0, 0, 50, 0));
  }
  Bearing fast = make(16, 0.0127, 0.07, 0.52, 0.52, 25.0, 0.0, 20000.0);
  solved(load(fast, -500, 0, 2000));
}

TEST_CASE("an equilibrium past the edge of the grooves is named", "[physics][statics][hard]") {
  Bearing bearing = make(16, 0.0127, 0.07, 0.52, 0.52, 60.0, 0.0, 20000.0);
  load(bearing, -500, 0, 2000);
  CHECK_THROWS_WITH(solve_ball_statics(bearing),
                    Catch::Contains("push the balls out of any groove"));
  bearing.speed = {0, 0};
  CHECK(noted(solved(bearing), "exceeds 90 degrees"));
}

TEST_CASE("ball statics: prescribed displacements, with and without loads → equilibrium",
          "[physics][statics][hard]") {
  Bearing bearing = spindle(10000.0);
  hold(bearing, 0, 1.5e-5);
  load(bearing, 0, 0, 200);
  const auto preload = solved(bearing);
  CHECK(preload.load[0] > 500.0);
  // The reaction as a load gives the displacement back.
  Bearing loaded = spindle(10000.0);
  load(loaded, preload.load[0], 0, 200);
  CHECK(solved(loaded).displacement[0] == Approx(1.5e-5).epsilon(1e-7));
  // Pulled apart: nothing touches in the free directions.
  Bearing open = spindle();
  hold(hold(hold(hold(hold(open, 0, -5e-5), 1, 0), 2, 0), 3, 0), 4, 0);
  const auto s = solved(open);
  CHECK(loaded_balls(s) == 0);
  CHECK(s.load == std::array<double, 5>{});
}

TEST_CASE("five milliradians of misalignment", "[physics][statics][hard]") {
  for (double rpm : {0.0, 10000.0}) {
    Bearing bearing = spindle(rpm);
    load(bearing, 300, 0, 200);
    hold(bearing, 3, 5e-3);
    const auto s = solved(bearing);
    CHECK(std::abs(s.load[3]) > 1.0);
    hold(bearing, 0, 0.0);
    solved(bearing);
    bearing.constraints.outer_misalignment = {5e-3, 0.0};
    solved(bearing);
    Bearing follows = spindle(rpm);
    load(follows, 300, 0, 200);
    follows.constraints.outer_misalignment = {5e-3, 0.0};
    const auto f = solved(follows);  // the free race follows the tilted one
    CHECK(f.displacement[3] > 2e-3);
  }
}

TEST_CASE("grooves of factor 0.5005", "[physics][statics][hard]") {
  for (double rpm : {0.0, 12000.0}) {
    Bearing bearing = make(16, 0.0127, 0.07, 0.5005, 0.5005, 40.0, 0.0, rpm);
    solved(load(bearing, 5000, 0, 2000));
    Bearing radial = make(16, 0.0127, 0.07, 0.5005, 0.5005, 0.0, 5e-6, rpm);
    solved(load(radial, 0, 0, 2000));
  }
}

TEST_CASE("any pair of race speeds", "[physics][statics][hard]") {
  for (auto rule : {bearing::SpinRule::RaceControl, bearing::SpinRule::MinimumHeat,
                    bearing::SpinRule::Prescribed})
    for (auto speed :
         {std::array<double, 2>{0, -1500}, {1000, 1000}, {1000, 0}, {500, -500}, {-900, 1400}}) {
      Bearing bearing = make(24, 0.012, 0.13, 0.52, 0.52, 15.0);
      bearing.spin_rule = rule;
      bearing.spin_angle = 0.26;
      bearing.speed = speed;
      solved(load(bearing, 2000, 0, 500));
    }
}

TEST_CASE("ball statics: loads too small, invalid values → error", "[unit][statics][hard]") {
  Bearing bearing = deep_groove(1.5e-5);
  CHECK_THROWS_WITH(solve_ball_statics(load(bearing, 0, 1e-9, 0)),
                    Catch::Contains("Set this load to zero"));
  CHECK_THROWS_WITH(solve_ball_statics(load(bearing, 0, std::nan(""), 0)),
                    Catch::Contains("not a finite number"));
  load(bearing, 0, 0, 100);
  bearing.element_material.elastic_modulus = 0.0;
  CHECK_THROWS_WITH(solve_ball_statics(bearing), Catch::Contains("elastic modulus is 0"));
  bearing.element_material = steel();
  bearing.balls().count = 0;
  CHECK_THROWS_AS(solve_ball_statics(bearing), InputError);
  bearing.balls().count = 9;
  bearing.speed = {0.0, 500.0};
  bearing.spin_rule = bearing::SpinRule::Prescribed;
  bearing.spin_angle = 1.57;
  CHECK_THROWS_WITH(solve_ball_statics(bearing), Catch::Contains("cannot roll on both races"));
}

TEST_CASE("radial load on a free race with clearance is an inverted pendulum",
          "[physics][statics][hard]") {
  // The race stands on its lowest balls. The load makes it tilt and shift aside until the grooves
  // hold it: the upright equilibrium is unstable, two mirror images beside it are stable.
  Bearing bearing = deep_groove(1.5e-5);
  const auto upright = solved(load(bearing, 0, 100, 300));
  CHECK(upright.displacement[3] == Approx(0.0).margin(1e-12));
  CHECK(noted(upright, "not stable"));
  REQUIRE(upright.other_equilibria.size() == 2);
  const auto& a = upright.other_equilibria[0];
  const auto& b = upright.other_equilibria[1];
  CHECK(a[0] == Approx(-b[0]).epsilon(1e-6));
  CHECK(a[3] == Approx(-b[3]).epsilon(1e-6));
  CHECK(a[2] == Approx(b[2]).epsilon(1e-6));
  CHECK(std::abs(a[3]) > 1e-4);
  BallStaticsOptions warm;
  warm.warm_start = true;
  bearing.constraints.displacement = a;
  const auto tilted = solved(bearing, warm);
  CHECK(tilted.displacement[3] == Approx(a[3]).epsilon(1e-6));
  CHECK_FALSE(noted(tilted, "not stable"));
  // A shaft that holds the tilts makes the upright one stable.
  bearing.constraints.displacement = {};
  CHECK_FALSE(noted(solved(hold(hold(bearing, 3, 0.0), 4, 0.0)), "not stable"));
}

TEST_CASE("unstable_mode(): negative stiffness → unstable equilibrium", "[unit][statics][hard]") {
  const RaceScales scales{0.03, 1e-5, 1e-3, 0.1, 0.0};
  RaceLoadCase task;
  Mat5 K = 1e8 * Mat5::Identity();
  K(3, 3) = K(4, 4) = 1e5;
  CHECK_FALSE(unstable_mode(scales, task, K, 1e8));
  K(1, 2) = 3e8;  // not symmetric: the symmetric part has the eigenvalue 1e8 - 1.5e8
  CHECK(unstable_mode(scales, task, K, 1e8).stiffness == Approx(-0.5e8));
  K(1, 2) = 0.0;
  K(4, 4) = -1e4;
  const adore::Finding note = instability_note(unstable_mode(scales, task, K, 1e8), {});
  CHECK_THAT(note.message, Catch::Contains("mainly about z"));
  CHECK(note.code == "statics.unstable");
  CHECK(note.measured.value_or(0.0) < 0.0);
  CHECK(note.unit == "N.m/rad");
  task.given[4] = true;  // held: harmless
  CHECK_FALSE(unstable_mode(scales, task, K, 1e8));
}
