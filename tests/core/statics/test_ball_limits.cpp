#include "base/errors.hpp"
#include "core/statics/ball_bearings.hpp"
#include "dynamics/race_contacts.hpp"
#include "listing/ball_warnings.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

using namespace adore;
using namespace ball_bearings;
using Catch::Contains;
using listing::ball_warnings;
using results::UnitSystem;
using statics::solve_ball_statics;
using statics::StaticBall;
using statics::StaticSolution;

namespace {

/// Part of a Hertz load beyond ξ on the major axis, by brute force over the ellipse.
double beyond_by_sum(double xi) {
  constexpr int kCells = 400;
  double all = 0.0, part = 0.0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const double x = -1.0 + (2.0 * i + 1.0) / kCells, y = -1.0 + (2.0 * j + 1.0) / kCells;
      const double p = std::sqrt(std::max(1.0 - x * x - y * y, 0.0));
      all += p;
      if (x > xi) part += p;
    }
  return part / all;
}

/// Diameter of a shoulder that cuts the ellipse of `ball` at ξ of its major axis.
double shoulder(const Bearing& bearing, const StaticBall& ball, std::size_t j, double xi) {
  const auto groove = contact::groove_geometry(bearing.balls());
  const double radius = groove.groove_radius[j];
  const double edge = ball.alpha[j] + xi * ball.a[j] / radius;
  return 2.0 * (groove.centre_radius[j] + (j == 0 ? 1.0 : -1.0) * radius * std::cos(edge));
}

}  // namespace

TEST_CASE("the load beyond the shoulder is that part of the pressure", "[physics][statics]") {
  Bearing bearing = angular_contact_218();
  load(bearing, 17800, 0, 0);
  const StaticBall inside = solve_ball_statics(bearing).balls[0];
  for (const double xi : {-0.7, 0.0, 0.4, 0.9}) {
    for (std::size_t j = 0; j < 2; ++j) {
      bearing.balls().shoulder_diameter = {};
      bearing.balls().shoulder_diameter[j] = shoulder(bearing, inside, j, xi);
      const StaticBall b = solve_ball_statics(bearing).balls[0];
      CHECK(b.beyond[j] / b.Q[j] == Approx(beyond_by_sum(xi)).epsilon(5e-3));
      CHECK(b.beyond[1 - j] == 0.0);
      CHECK(b.Q[j] == inside.Q[j]);  // told, not left out
    }
  }
}

TEST_CASE("contacts over the shoulder are warned of in the deck's units", "[unit][statics]") {
  Bearing bearing = angular_contact_218();
  load(bearing, 17800, 0, 0);
  const auto said = [&](UnitSystem units) {
    std::string all;
    for (const auto& text : ball_warnings(bearing, solve_ball_statics(bearing), 1.0, units))
      all += text.message + "\n";
    return all;
  };
  CHECK(said(UnitSystem::SI).empty());
  bearing.balls().shoulder_diameter[0] =
      shoulder(bearing, solve_ball_statics(bearing).balls[0], 0, 0.4);
  const StaticBall b = solve_ball_statics(bearing).balls[0];
  REQUIRE(b.shoulder_depth[0] < 0.0);
  CHECK_THAT(said(UnitSystem::SI), Contains("balls 1-16") &&
                                       Contains("contact ellipse at the outer race") &&
                                       Contains(fmt::format("{:.4g} N", b.beyond[0])) &&
                                       Contains(fmt::format("{:.4g} m", -b.shoulder_depth[0])));
  CHECK_THAT(said(UnitSystem::English),
             Contains(fmt::format("{:.4g} lbf", b.beyond[0] / 4.4482216152605)) &&
                 Contains(fmt::format("{:.4g} in", -b.shoulder_depth[0] / 0.0254)) &&
                 !Contains(" N ") && !Contains(" m."));
}

TEST_CASE(
    "race control: required friction coefficient → reported, with a warning if the law has less",
    "[physics][statics]") {
  Bearing bearing = angular_contact_218();
  load(bearing, 17800, 0, 0);
  bearing.spin_rule = bearing::SpinRule::RaceControl;
  double before = 0.0;
  for (const double rpm : {2000.0, 6000.0, 15000.0}) {
    bearing.speed = {0.0, rpm * std::numbers::pi / 30.0};
    const StaticSolution s = solve_ball_statics(bearing);
    const StaticBall& b = s.balls[0];
    // A couple of 2 M/D: all at the outer race, or half of it at each.
    const double couple = 2.0 * std::abs(b.gyroscopic_moment) / bearing.balls().diameter;
    const double share = b.inner_race_control ? 0.5 : 1.0;
    CHECK(b.friction[0] * b.Q[0] == Approx(share * couple).epsilon(1e-9));
    CHECK(b.friction[1] * b.Q[1] == Approx((1.0 - share) * couple).epsilon(1e-9).margin(1e-12));
    CHECK(b.friction[0] > before);
    before = b.friction[0];
    const auto warns = [&](std::optional<double> law) {
      return ball_warnings(bearing, s, law, UnitSystem::SI);
    };
    const double most = std::max(b.friction[0], b.friction[1]);
    CHECK(warns(1.001 * most).empty());
    const auto texts = warns(0.999 * most);
    REQUIRE(texts.size() == 1);
    CHECK_THAT(texts[0].message,
               Contains("race control") && Contains("balls 1-16") &&
                   Contains(fmt::format("friction coefficient of {:.3g} at the {} race", most,
                                        most == b.friction[0] ? "outer" : "inner")));
    CHECK(warns(std::nullopt).size() == (most > 0.06 ? 1 : 0));
  }
  CHECK(before == Approx(0.084).epsilon(0.05));  // the textbooks' bearing at 15,000 rpm
}

TEST_CASE("ball statics: contact as long as the ball → error with its cause, no NaN at lower loads",
          "[physics][statics]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int refused = 0, solved = 0;
  for (int k = 0; k < 60; ++k) {
    const double f = 0.5 + std::pow(10.0, -4.0 + 2.5 * share(random));
    Bearing bearing = make(16, 0.0127, 0.07, f, f, 25.0, 0.0, k % 3 == 0 ? 0.0 : 9000.0);
    load(bearing, std::pow(10.0, 2.0 + 3.0 * share(random)), 0, 0);
    CAPTURE(f, bearing.constraints.load[0]);
    try {
      const StaticSolution s = solve_ball_statics(bearing);
      ++solved;
      for (const StaticBall& b : s.balls) {
        CHECK(std::isfinite(b.orbital_speed));
        CHECK(std::isfinite(b.spin_speed));
        for (std::size_t j = 0; j < 2; ++j)
          if (b.Q[j] > 0.0) CHECK(b.a[j] < 0.5 * bearing.balls().diameter);
      }
      const bool wide = s.balls[0].a[0] > 0.25 * bearing.balls().diameter;
      const auto texts = ball_warnings(bearing, s, 1e9, UnitSystem::SI);
      CHECK(wide == std::any_of(texts.begin(), texts.end(), [](const Finding& t) {
              return t.message.find("Hertz") != std::string::npos &&
                     t.message.find("outer") != std::string::npos;
            }));
    } catch (const SolverError& error) {
      ++refused;
      CHECK_THAT(error.what(), Contains("reaches the ball radius") && Contains("groove factor"));
    }
  }
  CHECK(refused > 5);
  CHECK(solved > 20);
}

TEST_CASE("a run stops a contact where its ellipse is as long as the ball", "[unit][statics]") {
  Bearing bearing = make(16, 0.0127, 0.07, 0.5005, 0.52, 25.0);
  for (int j = 0; j < 2; ++j) {
    dynamics::RaceContactModel model;
    model.race = j == 0 ? bearing::kOuter : bearing::kInner;
    model.groove = contact::groove_geometry(bearing.balls());
    model.hertz = contact::hertz_constants(
        contact::race_curvature(bearing.balls(), j, 25.0 * std::numbers::pi / 180.0),
        bearing::contact_modulus(bearing.element_material, bearing.race_material[0]));
    const double limit = dynamics::load_limit(model);
    CHECK(model.hertz.a_hat * std::cbrt(limit) <= (1.0 + 1e-12) * model.groove.ball_radius);
    CHECK(limit <= contact::hertz_load(model.hertz.K, model.groove.ball_radius));
  }
}
