#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "contact/split_race.hpp"
#include "core/statics/ball_bearings.hpp"
#include "statics/ball_forces.hpp"
#include "statics/ball_model.hpp"
#include "statics/ball_statics.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace adore;
using namespace adore::statics;
using namespace ball_bearings;

namespace {

constexpr double kD = 0.0127, kF = 0.52, kAngle = 25.0, kShim = 1e-4;

Bearing split(double outer, double inner, double rpm = 0.0) {
  Bearing bearing = make(16, kD, 0.07, kF, kF, kAngle, 0.0, rpm);
  bearing.balls().shim = {outer, inner};
  return bearing;
}

double end_play(double shims) {
  return 2.0 * (2.0 * kF - 1.0) * kD * std::sin(kAngle * std::numbers::pi / 180.0) - shims;
}

using Force = Eigen::Vector2d;  // on (e_x, e_r)

/// Force on a ball at rest of one contact, from load, angle, approach and K of the report: -Q n,
/// and of an ellipse that the split cuts the force along c (contact/split_race.hpp).
Force force_of(const Bearing& bearing, std::size_t j, double Q, double alpha, double delta,
               double K) {
  if (!(Q > 0.0)) return Force::Zero();
  const double side = j == 0 ? 1.0 : -1.0;
  const Force n = side * Force(std::sin(alpha), std::cos(alpha));
  const double shim = bearing.balls().shim[j];
  if (!(shim > 0.0)) return -Q * n;
  const auto h = contact::hertz_constants(
      contact::race_curvature(bearing.balls(), static_cast<int>(j), 0.0), 1.0);
  const double r = kF * kD, root = std::sqrt(delta), A = h.a_hat * std::cbrt(h.K);
  const double t = std::min(1.0, (r * std::abs(std::sin(alpha)) - 0.5 * shim) / (A * root));
  const double sigma = n[0] > 0.0 ? 1.0 : -1.0;
  const double M = 0.4 * K * std::pow(delta, 1.5) * root * 0.9375 * std::pow(1.0 - t * t, 2) * r *
                   sigma * n[1] / ((r - 0.5 * kD + delta) * A);
  return -Q * n + M * Force(-n[1], n[0]);
}
/// Of both contacts with one race.
Force force_of_race(const Bearing& bearing, const StaticBall& b, std::size_t j) {
  const SecondContact& s = b.second[j];
  return force_of(bearing, j, b.Q[j], b.alpha[j], b.delta[j], b.K[j]) +
         force_of(bearing, j, s.Q, s.alpha, s.delta, s.K);
}
/// Direction from the center of the displaced inner race to the ball, on (y, z).
Force outward(const StaticSolution& s, const StaticBall& b) {
  return Force(-b.r * std::sin(b.azimuth) - s.displacement[1],
               b.r * std::cos(b.azimuth) - s.displacement[2])
      .normalized();
}
/// Sum of all contacts over their loads; races are not tilted.
double imbalance(const Bearing& bearing, const StaticSolution& s, const StaticBall& b) {
  const Force outer = force_of_race(bearing, b, 0), inner = force_of_race(bearing, b, 1);
  const double along = outward(s, b).dot(Force(-std::sin(b.azimuth), std::cos(b.azimuth)));
  return std::hypot(outer[0] + inner[0], outer[1] + along * inner[1]) / (b.Q[0] + b.Q[1]);
}

}  // namespace

TEST_CASE("part of an ellipse on one side of a split: exact limits and derivatives",
          "[unit][contact][split]") {
  const contact::SplitRaceHalf half{1.0, 5e-5, 0.0066, 0.0, 0.3};
  const double l = 2.7e-4, delta = 2e-5, K = 1e10;
  const auto at = [&](double angle, double d) {
    const double root = std::sqrt(d);
    return contact::split_load_fractions<double>(half, K * d * root, root, std::sin(angle),
                                                 std::cos(angle), l);
  };
  const double a = 0.3 * std::sqrt(delta);
  const double first = std::asin((5e-5 + a) / 0.0066), last = std::asin((5e-5 - a) / 0.0066);
  CHECK(at(first, delta).load == Approx(1.0).epsilon(1e-12));
  CHECK(std::abs(at(last, delta).load) < 1e-12);
  CHECK(at(std::asin(5e-5 / 0.0066), delta).load == Approx(0.5));
  // Load of a Hertz ellipse: 3/4 (1 - t²) per t, summed from the split on.
  const double t = 0.4;
  double sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double s = -1.0 + (t + 1.0) * (i + 0.5) / 100000;
    sum += 0.75 * (1.0 - s * s) * (t + 1.0) / 100000;
  }
  const double angle = std::asin((5e-5 + t * a) / 0.0066);
  CHECK(at(angle, delta).load == Approx(sum).epsilon(1e-8));
  // Forces are the gradient of φ 0.4 K δ^2.5.
  const auto V = [&](double of_angle, double d) {
    return at(of_angle, d).energy * 0.4 * K * std::pow(d, 2.5);
  };
  const double h = 1e-9, Q = K * std::pow(delta, 1.5);
  CHECK((V(angle, delta + h) - V(angle, delta - h)) / (2 * h) ==
        Approx(at(angle, delta).load * Q).epsilon(1e-7));
  // Along c by ds the angle falls by ds/l on this race.
  const double e = 1e-6;
  CHECK((V(angle + e, delta) - V(angle - e, delta)) / (2 * e * l) ==
        Approx(at(angle, delta).turned).epsilon(1e-7));
}

TEST_CASE("split races: axial clearance → 2 A sin a - g, reversed thrust is the mirror image",
          "[physics][statics][split]") {
  for (const auto& [outer, inner] :
       {std::pair{0.0, kShim}, std::pair{kShim, 0.0}, std::pair{kShim, 8e-5}})
    for (const double rpm : {0.0, 9000.0}) {
      CAPTURE(outer, inner, rpm);
      Bearing bearing = split(outer, inner, rpm);
      const auto fore = solve_ball_statics(load(bearing, 1500, 0, 0));
      const auto back = solve_ball_statics(load(bearing, -1500, 0, 0));
      CHECK(fore.displacement[0] + back.displacement[0] ==
            Approx(-end_play(outer + inner)).margin(1e-13));
      for (std::size_t j = 0; j < 2; ++j) {
        CHECK(back.balls[0].Q[j] == Approx(fore.balls[0].Q[j]).epsilon(1e-9));
        CHECK(back.balls[0].alpha[j] == Approx(-fore.balls[0].alpha[j]).epsilon(1e-9));
        CHECK(fore.balls[0].second[j].Q == 0.0);
        CHECK(fore.balls[0].share[j] == 1.0);
      }
      CHECK(back.balls[0].orbital_speed == Approx(fore.balls[0].orbital_speed).epsilon(1e-9));
    }
}

TEST_CASE("split races: forward thrust is that of the undivided race",
          "[physics][statics][split]") {
  Bearing bearing = split(0.0, kShim, 9000.0), whole = split(0.0, 0.0, 9000.0);
  const auto a = solve_ball_statics(load(bearing, 1500, 0, 0)),
             b = solve_ball_statics(load(whole, 1500, 0, 0));
  CHECK(a.displacement[0] == Approx(b.displacement[0]).epsilon(1e-12));
  CHECK(a.balls[0].Q[0] == Approx(b.balls[0].Q[0]).epsilon(1e-12));
}

TEST_CASE("split races: three and four contacts of a ball under radial load",
          "[physics][statics][split]") {
  for (const double outer : {0.0, kShim}) {
    CAPTURE(outer);
    Bearing bearing = split(outer, kShim);
    hold(hold(bearing, 3, 0.0), 4, 0.0);
    const auto s = solve_ball_statics(load(bearing, 0, 0, 2000));
    double carried = 0.0;
    int loaded = 0;
    for (const StaticBall& b : s.balls) {
      if (!(b.Q[1] > 0.0)) continue;
      ++loaded;
      CHECK(b.second[1].Q == Approx(b.Q[1]).epsilon(1e-6));
      CHECK(b.second[1].alpha == Approx(-b.alpha[1]).epsilon(1e-6));
      CHECK((b.second[0].Q > 0.0) == (outer > 0.0));
      // Both halves hold the ball at the angle of its rest, less what it sinks in.
      CHECK(std::abs(b.alpha[1]) > std::asin(0.5 * kShim / (0.02 * kD + b.delta[1])) - 1e-9);
      CHECK(imbalance(bearing, s, b) < 1e-9);
      carried += force_of_race(bearing, b, 1)[1] * outward(s, b)[1];
    }
    CHECK(loaded >= 3);
    CHECK(std::abs(carried) == Approx(2000.0).epsilon(1e-7));
    // By symmetry the race is in the middle of its play.
    CHECK(s.displacement[0] == Approx(-0.5 * end_play(outer + kShim)).margin(1e-9));
  }
}

TEST_CASE("split races: with small thrust the halves share unequally and balance",
          "[physics][statics][split]") {
  Bearing bearing = split(0.0, kShim);
  hold(hold(bearing, 3, 0.0), 4, 0.0);
  const auto s = solve_ball_statics(load(bearing, 150, 0, 3000));
  double axial = 0.0;
  int dual = 0;
  for (const StaticBall& b : s.balls) {
    if (!(b.Q[1] > 0.0)) continue;
    dual += b.second[1].Q > 0.0 ? 1 : 0;
    CHECK(imbalance(bearing, s, b) < 1e-9);
    axial += force_of_race(bearing, b, 1)[0];
  }
  CHECK(dual > 0);
  CHECK(axial == Approx(150.0).epsilon(1e-8));
}

TEST_CASE("split races: thin shim → result without shim", "[physics][statics][split]") {
  for (const double rpm : {0.0, 9000.0})
    for (const double thrust : {0.0, 500.0}) {
      CAPTURE(rpm, thrust);
      Bearing whole = split(0.0, 0.0, rpm);
      const auto b = solve_ball_statics(load(whole, thrust, 0, 3000));
      double last = 1.0;
      for (const double shim : {1e-7, 1e-8}) {
        Bearing bearing = split(0.0, shim, rpm);
        const auto a = solve_ball_statics(load(bearing, thrust, 0, 3000));
        double worst = 0.0;
        for (std::size_t k = 0; k < a.balls.size(); ++k)
          worst =
              std::max(worst, std::abs(a.balls[k].Q[1] + a.balls[k].second[1].Q - b.balls[k].Q[1]) /
                                  b.max_load);
        CHECK(worst < 0.2 * last);
        last = worst;
      }
      CHECK(last < 1e-3);
    }
}

TEST_CASE("split races: ball forces have exact derivatives", "[unit][statics][split]") {
  Bearing bearing = split(kShim, kShim, 9000.0);
  for (const auto curvature : {Curvature::Actual, Curvature::Potential}) {
    BallStaticsOptions options;
    options.curvature = curvature;
    const BallModel m = make_ball_model(bearing, options);
    BallSite site;
    site.law = first_spin_law(bearing, options);
    // A ball on both halves of each race, one ellipse cut by its split.
    for (const double aside : {0.0, 2e-5}) {
      std::array<double, 7> at{};
      at[2] = -0.5 * end_play(2 * kShim);
      at[4] = 6e-5;
      at[0] = m.groove.centre_x[0] + 0.5 * kShim + aside;
      const auto forces = [&](const std::array<double, 7>& v) {
        const auto f = ball_forces<double>(
            m, site, v[0], v[1], inner_race_pose<double>(m, {v[2], v[3], v[4], v[5], v[6]}));
        return std::array<double, 7>{f.axial,   f.radial,  f.race[0], f.race[1],
                                     f.race[2], f.race[3], f.race[4]};
      };
      using D = Dual<7>;
      std::array<D, 5> q;
      for (int k = 0; k < 5; ++k)
        q[static_cast<std::size_t>(k)] = D::variable(at[static_cast<std::size_t>(k) + 2], k + 2);
      const auto f = ball_forces<D>(m, site, D::variable(at[0], 0), D::variable(at[1], 1),
                                    inner_race_pose<D>(m, q));
      const std::array<D, 7> exact{f.axial,   f.radial,  f.race[0], f.race[1],
                                   f.race[2], f.race[3], f.race[4]};
      for (std::size_t k = 0; k < 7; ++k) {
        const double h = k < 5 ? 1e-10 : 1e-9;
        auto high = at, low = at;
        high[k] += h;
        low[k] -= h;
        const auto above = forces(high), below = forces(low);
        for (std::size_t row = 0; row < 7; ++row) {
          CAPTURE(k, row, aside);
          const double scale = k < 5 ? 1e8 : 3e6;
          CHECK(exact[row].d[k] ==
                Approx((above[row] - below[row]) / (2 * h)).epsilon(1e-4).margin(1e-5 * scale));
        }
      }
    }
  }
}
