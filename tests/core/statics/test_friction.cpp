#include "ball_bearings.hpp"
#include "base/validity.hpp"
#include "bearing/bearing.hpp"
#include "contact/elliptic.hpp"
#include "deck/reader.hpp"
#include "setup/build_bearing.hpp"
#include "statics/ball_statics.hpp"
#include "statics/friction.hpp"
#include "statics/roller_statics.hpp"
#include "support/paths.hpp"
#include "thermal/operating.hpp"
#include "tribology/lubricant.hpp"
#include "tribology/lubricant_range.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

using namespace adore;
using bearing::Bearing;

namespace {

Bearing from_deck(const std::string& name) {
  const deck::ReadResult read =
      deck::read_deck(adore::test::source_dir().string() + "/resources/decks/" + name + ".txt");
  REQUIRE(read.ok());
  return thermal::operating_bearing(setup::build_bearing(read.deck));
}

bearing::TractionCurve constant(double kappa) {
  return {bearing::TractionCurve::Form::Exponential, 0.0, 0.0, 0.0, kappa, 0.0};
}

}  // namespace

TEST_CASE("friction of spin is that of a sliding ellipse: M = 3/8 kappa Q a E",
          "[physics][statics][analytic]") {
  Bearing b = from_deck("ball-thrust");
  b.lubrication.reset();
  b.race_traction = constant(0.05);
  const auto solution = statics::solve_ball_statics(b);
  const auto friction = statics::friction_estimate(b, solution);
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < solution.balls.size(); ++i) {
      const statics::StaticBall& ball = solution.balls[i];
      if (!(ball.Q[j] > 0.0)) continue;
      const double side = j == 0 ? 1.0 : -1.0;
      const double spin = std::abs((b.speed[j] - ball.omega_x) * side * std::sin(ball.alpha[j]) -
                                   ball.omega_r * side * std::cos(ball.alpha[j]));
      const double k2 = 1.0 - ball.b[j] * ball.b[j] / (ball.a[j] * ball.a[j]);
      const double moment =
          0.375 * 0.05 * ball.Q[j] * ball.a[j] * std::comp_ellint_2(std::sqrt(k2));
      INFO("race " << j << ", ball " << i + 1);
      const double found = friction.race[j][i].spin;
      // The race in control has none to speak of.
      if (moment * spin > 1e-3 * friction.power())
        CHECK(found == Approx(moment * spin).epsilon(5e-3));  // fixed rule of 30 by 8 points
      CHECK(friction.race[j][i].sliding >= 0.0);
      CHECK(friction.race[j][i].rolling == 0.0);  // no oil
    }
  CHECK(friction.torque() == Approx(friction.power() / friction.speed));
}

TEST_CASE("friction grows with the coefficient and is nothing without one or without speed",
          "[physics][statics]") {
  for (const char* name : {"ball", "angular-218", "cylindrical", "tapered", "spherical"}) {
    INFO(name);
    Bearing b = from_deck(name);
    b.lubrication.reset();
    b.churning.reset();
    const auto of = [&](double kappa) {
      b.race_traction = constant(kappa);
      if (b.flange_traction) b.flange_traction = constant(kappa);
      return b.rollers() ? statics::friction_estimate(b, statics::solve_roller_statics(b)).power()
                         : statics::friction_estimate(b, statics::solve_ball_statics(b)).power();
    };
    const double once = of(0.04);
    CHECK(once > 0.0);
    CHECK(of(0.08) == Approx(2.0 * once).epsilon(1e-3));
    CHECK(of(0.0) == 0.0);
    b.speed = {0.0, 0.0};
    CHECK(of(0.04) == 0.0);
    // The whole bearing turns as one body; what is left is rounding of speeds, 1e-7 of them.
    b.speed = {300.0, 300.0};
    CHECK(of(0.04) < 1e-4 * once);
  }
}

TEST_CASE("oil resists rolling more when it is thick, and starves away", "[physics][statics]") {
  for (const char* name : {"deep-groove-6205", "cylindrical-nu209"}) {
    INFO(name);
    Bearing b = from_deck(name);
    b.lubrication = bearing::Lubrication{1, 1e-8, 10.0, {}};
    const auto rolling = [&](double T, double meniscus) {
      b.race_temperature = {T, T};
      b.element_temperature = T;
      b.lubrication->meniscus = meniscus;
      const auto f = b.rollers() ? statics::friction_estimate(b, statics::solve_roller_statics(b))
                                 : statics::friction_estimate(b, statics::solve_ball_statics(b));
      return f.of_race(0).rolling + f.of_race(1).rolling;
    };
    const double cold = rolling(300.0, 10.0), hot = rolling(380.0, 10.0);
    CHECK(hot > 0.0);
    CHECK(cold > 2.0 * hot);
    CHECK(rolling(380.0, 0.1) < 0.9 * hot);
  }
}

TEST_CASE("the rib slides by its height above the raceway, about which a tapered roller rolls",
          "[physics][statics][rollers]") {
  Bearing b = from_deck("tapered");
  constexpr double kKappa = 0.05;
  b.flange_traction = constant(kKappa);
  const statics::RollerSolution solution = statics::solve_roller_statics(b);
  // Spins of race and roller against the row add up, their axes a few degrees apart; the roller
  // rolls about its line on the race, and the face of the rib stands across that line.
  const double race = std::abs(b.speed[1] - solution.orbital_speed);
  const double spin = std::abs(solution.spin_speed);
  const double rolling =
      std::sqrt(race * race + spin * spin + 2.0 * race * spin * std::cos(b.rollers()->axis_angle));
  double expected = 0.0;
  for (const statics::StaticRoller& roller : solution.rollers)
    for (const statics::RollerFlangeContact& rib : roller.flange[1])
      if (rib.load > 0.0) expected += kKappa * rib.load * rolling * rib.height;
  REQUIRE(expected > 0.0);
  CHECK(statics::friction_estimate(b, solution).flange[1] == Approx(expected).epsilon(0.03));
}

TEST_CASE(
    "rolling resistance of balls: ratio to the line-contact law → grows with viscosity and speed",
    "[physics][statics][film]") {
  Bearing b = from_deck("deep-groove-6205");
  const auto ratio = [&](double T, double share_of_speed) {
    Bearing at = b;
    at.race_temperature = {T, T};
    at.element_temperature = T;
    for (double& speed : at.speed) speed *= share_of_speed;
    return statics::rolling_point_strip_ratio(at, statics::solve_ball_statics(at));
  };
  CHECK(ratio(350.0, 1.0) == 0.0);  // no oil
  b.lubrication = bearing::Lubrication{1, 1e-8, 10.0, {}};
  // Thin and slow: where the law agrees with measured torques (theory/tribology.md 2a).
  CHECK(ratio(400.0, 0.05) > 0.9);
  CHECK(ratio(400.0, 0.05) < 1.7);
  CHECK(ratio(290.0, 1.0) > validity::range("rolling.strips").bounds.most);
  CHECK(ratio(290.0, 1.0) < 4.0);
  CHECK(ratio(350.0, 1.0) > ratio(350.0, 0.1));
  CHECK(ratio(330.0, 1.0) > ratio(380.0, 1.0));
}

TEST_CASE("rolling_resistance_excess(): ratios of solved contacts → excess bounds them",
          "[unit][friction]") {
  // Strips and solution over the law, theory/tribology.md 2a; test "rolling resistance of points is
  // that of Reynolds' equation": a grid of twice the cells lowers the solution by 2 %.
  constexpr std::array<std::array<double, 2>, 6> kSolved{
      {{0.71, 0.97}, {0.59, 0.93}, {0.49, 0.865}, {0.40, 0.76}, {0.45, 0.88}, {0.51, 0.88}}};
  for (const auto& [strips, solution] : kSolved) {
    CAPTURE(strips);
    CHECK(statics::rolling_resistance_excess(1.0 / strips) >= 1.02 / solution);
    CHECK(statics::rolling_resistance_excess(1.0 / strips) < 1.2 / solution);
  }
  CHECK(statics::rolling_resistance_excess(0.5) == 1.0);
}
