#include "core/statics/ball_bearings.hpp"
#include "statics/ball_statics.hpp"
#include "statics/friction.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

// The spin axis of least heat by the traction law of the deck (statics/least_heat.hpp).

using namespace adore;
using namespace adore::statics;
using namespace ball_bearings;

namespace {

Bearing thrust_bearing(const bearing::TractionCurve& curve) {
  Bearing b = angular_contact_218(3000.0);
  load(b, 20000.0, 0.0, 0.0);
  b.spin_rule = bearing::SpinRule::MinimumHeat;
  b.race_traction = curve;
  return b;
}

double heat_at(Bearing bearing, double angle) {
  bearing.spin_rule = bearing::SpinRule::Prescribed;
  bearing.spin_angle = angle;
  return friction_estimate(bearing, solve_ball_statics(bearing)).power();
}

}  // namespace

TEST_CASE("least heat: curve of the deck → no angle near it has less heat", "[statics]") {
  bearing::TractionCurve rising, falling;
  rising.A = -0.06, rising.C = 40.0, rising.D = 0.06;                    // sticks at small slip
  falling.A = 0.05, falling.B = 0.3, falling.C = 6.0, falling.D = 0.02;  // less at large slip
  for (const bearing::TractionCurve& curve : {rising, falling}) {
    const Bearing bearing = thrust_bearing(curve);
    const StaticSolution solution = solve_ball_statics(bearing);
    const double beta = solution.balls.front().pitch_angle;
    const double least = friction_estimate(bearing, solution).power();
    CHECK(heat_at(bearing, beta) == Approx(least).epsilon(1e-6));
    for (const double step : {-0.02, -0.005, 0.005, 0.02}) {
      CAPTURE(curve.A, beta, step);
      CHECK(heat_at(bearing, beta + step) > least);
    }
  }
}

TEST_CASE("least heat: any constant coefficient → the axis of spin.hpp", "[statics]") {
  bearing::TractionCurve curve;
  curve.D = 0.05;
  const Bearing bearing = thrust_bearing(curve);
  Bearing other = bearing, none = bearing;
  other.race_traction.D = 0.005;
  none.race_traction.D = 0.0;
  const double beta = solve_ball_statics(bearing).balls.front().pitch_angle;
  CHECK(solve_ball_statics(other).balls.front().pitch_angle == Approx(beta).margin(1e-6));
  // spin.hpp replaces the slip across the narrow axis by its mean.
  CHECK(solve_ball_statics(none).balls.front().pitch_angle == Approx(beta).margin(0.01));
}
