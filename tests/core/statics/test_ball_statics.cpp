#include "base/constants.hpp"
#include "base/errors.hpp"
#include "core/statics/ball_bearings.hpp"
#include "statics/ball_forces.hpp"
#include "statics/ball_model.hpp"
#include "statics/ball_race.hpp"
#include "statics/ball_springs.hpp"
#include "statics/ball_statics.hpp"
#include "statics/kinematics.hpp"
#include "statics/race_text.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <cmath>

using namespace adore;
using namespace adore::statics;
using namespace ball_bearings;

namespace {

std::vector<BallStaticsOptions> all_options() {
  std::vector<BallStaticsOptions> list;
  for (auto kinematics : {RingKinematics::Exact, RingKinematics::Linear})
    for (auto curvature : {Curvature::Actual, Curvature::Free, Curvature::Fixed})
      for (auto control : {Control::Outer, Control::Inner, Control::Equal, Control::None})
        for (auto orbit : {Orbit::PerBall, Orbit::Nominal}) {
          BallStaticsOptions o;
          o.kinematics = kinematics;
          o.curvature = curvature;
          o.control = control;
          o.orbit = orbit;
          o.fixed_angle = {0.5, 0.6};
          list.push_back(o);
        }
  return list;
}

/// Residual of the ball equations of family C with the reported contact loads, angles and forces.
double ball_imbalance(const StaticBall& b, double D, double share_o, double share_i) {
  const double f_o = share_o * b.gyroscopic_moment / D;
  const double f_i = share_i * b.gyroscopic_moment / D;
  const double so = std::sin(b.alpha[0]), co = std::cos(b.alpha[0]);
  const double si = std::sin(b.alpha[1]), ci = std::cos(b.alpha[1]);
  const double axial = b.Q[1] * si - b.Q[0] * so + f_i * ci - f_o * co;
  const double radial = b.Q[1] * ci - b.Q[0] * co - f_i * si + f_o * so + b.centrifugal_force;
  return std::hypot(axial, radial) / b.Q[0];
}

}  // namespace

TEST_CASE("ball forces have exact derivatives for every option", "[unit][statics]") {
  Bearing bearing = angular_contact_218(9000.0);
  bearing.constraints.outer_misalignment = {4e-4, -3e-4};
  bearing.spin_angle = 0.6;
  const std::array<double, 7> at{2e-6, 8e-6, 2e-5, 3e-6, -5e-6, 4e-4, -2e-4};
  for (auto rule : {bearing::SpinRule::RaceControl, bearing::SpinRule::MinimumHeat,
                    bearing::SpinRule::Prescribed}) {
    bearing.spin_rule = rule;
    for (BallStaticsOptions options : all_options()) {
      if (rule != bearing::SpinRule::RaceControl) options.control = Control::FromBearing;
      const BallModel model = make_ball_model(bearing, options);
      BallSite site;
      site.sin = std::sin(0.7);
      site.cos = std::cos(0.7);
      site.law = first_spin_law(bearing, options);
      const auto evaluate = [&](const std::array<double, 7>& u) {
        const auto f =
            ball_forces<double>(model, site, u[0], u[1],
                                inner_race_pose<double>(model, {u[2], u[3], u[4], u[5], u[6]}));
        return std::array<double, 7>{f.axial,   f.radial,  f.race[0], f.race[1],
                                     f.race[2], f.race[3], f.race[4]};
      };
      std::array<Dual<8>, 7> u;
      for (std::size_t k = 0; k < 7; ++k) u[k] = Dual<8>::variable(at[k], static_cast<int>(k));
      const auto f = ball_forces<Dual<8>>(
          model, site, u[0], u[1], inner_race_pose<Dual<8>>(model, {u[2], u[3], u[4], u[5], u[6]}));
      REQUIRE(f.contact[0].load.v > 100.0);
      REQUIRE(f.contact[1].load.v > 100.0);
      const std::array<Dual<8>, 7> exact{f.axial,   f.radial,  f.race[0], f.race[1],
                                         f.race[2], f.race[3], f.race[4]};
      for (std::size_t k = 0; k < 7; ++k) {
        const double h = k < 5 ? 2e-9 : 4e-8;
        auto plus = at, minus = at;
        plus[k] += h;
        minus[k] -= h;
        const auto up = evaluate(plus);
        const auto down = evaluate(minus);
        for (std::size_t i = 0; i < 7; ++i) {
          const double scale = (k < 5 ? 3e8 : 3e7) * (i < 5 ? 1.0 : 0.1);  // N/m, N/rad, N, N m/rad
          // Differences over a step of 2e-4 of the approach: truncation a few 1e-8 of the scale,
          // rounding less.
          CHECK(exact[i].d[k] == Approx((up[i] - down[i]) / (2 * h)).margin(3e-7 * scale));
        }
      }
    }
  }
}

TEST_CASE("balls and inner race are in equilibrium for every option", "[physics][statics]") {
  Bearing bearing = angular_contact_218(8000.0);
  load(bearing, 17800, 500, 6000, 20, -10);
  for (const BallStaticsOptions& options : all_options()) {
    const auto s = solve_ball_statics(bearing, options);
    const double share_o = options.orbit == Orbit::Nominal || options.control == Control::None ? 0.0
                           : options.control == Control::Outer                                 ? 2.0
                                                               : 1.0;
    const double share_i = share_o == 0.0 || options.control == Control::Outer ? 0.0 : 1.0;
    for (std::size_t k = 0; k < 5; ++k) {
      // Newton stops at 1e-12 of the largest load component.
      CHECK(s.load[k] == Approx(bearing.constraints.load[k]).margin(1e-7));
    }
    for (const StaticBall& b : s.balls) {
      REQUIRE(b.inner_contact);
      // The exact kinematics measure angles in each race's own meridional plane: tilts of 1e-3 and
      // offsets u/d_m enter.
      CHECK(ball_imbalance(b, bearing.balls().diameter, share_o, share_i) <
            (options.kinematics == RingKinematics::Linear ? 1e-12 : 5e-3));
    }
    CHECK(s.residual < 1e-11);
  }
}

TEST_CASE("the stiffness matrix matches differences of re-solved states", "[physics][statics]") {
  for (auto rule : {bearing::SpinRule::RaceControl, bearing::SpinRule::MinimumHeat}) {
    Bearing bearing = spindle(20000.0);
    bearing.spin_rule = rule;
    load(bearing, 900, 50, 300, 2, 1);
    BallStaticsOptions options;
    if (rule == bearing::SpinRule::RaceControl)
      options.control = Control::Outer;  // no switching between states
    const auto s = solve_ball_statics(bearing, options);
    for (std::size_t k = 0; k < 5; ++k) {
      const double h = k < 3 ? 2e-9 : 1e-7;
      std::array<std::array<double, 5>, 2> loads{};
      for (int side = 0; side < 2; ++side) {
        Bearing held = bearing;
        for (std::size_t l = 0; l < 5; ++l)
          hold(held, l, s.displacement[l] + (l == k ? (side == 0 ? h : -h) : 0.0));
        loads[static_cast<std::size_t>(side)] = solve_ball_statics(held, options).load;
      }
      for (std::size_t i = 0; i < 5; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const auto column = static_cast<Eigen::Index>(k);
        const double difference = (loads[0][i] - loads[1][i]) / (2 * h);
        const double scale =
            std::sqrt(std::abs(s.stiffness(row, row) * s.stiffness(column, column)));
        // A step of 2e-9 m against approaches of 3e-6 m: truncation 1e-7; rounding of 1e-9 N over
        // the step 1e-8.
        CHECK(s.stiffness(row, column) == Approx(difference).margin(1e-6 * scale));
      }
    }
  }
}

TEST_CASE("a conservative problem has a symmetric stiffness", "[physics][statics]") {
  Bearing bearing = angular_contact_218(10000.0);
  load(bearing, 17800, 1000, 5000);
  BallStaticsOptions options;
  options.orbit = Orbit::Nominal;
  options.curvature = Curvature::Free;
  options.kinematics = RingKinematics::Linear;
  const auto s = solve_ball_statics(bearing, options);
  const Eigen::Matrix<double, 5, 5> skew = s.stiffness - s.stiffness.transpose();
  CHECK(skew.cwiseAbs().maxCoeff() < 1e-12 * s.stiffness.cwiseAbs().maxCoeff());
  // In exact kinematics the rotation about z follows the rotation about y: asymmetry of the order
  // of tilt times moment.
  options.kinematics = RingKinematics::Exact;
  const auto e = solve_ball_statics(bearing, options);
  CHECK((e.stiffness - e.stiffness.transpose()).cwiseAbs().maxCoeff() <
        1e-3 * e.stiffness.cwiseAbs().maxCoeff());
  Bearing slow = bearing;
  slow.speed = {0.0, 0.0};
  CHECK(std::abs(solve_ball_statics(slow).stiffness(0, 2)) > 0.0);
}

TEST_CASE("springs hold a race at rest where its balls hold it", "[physics][statics]") {
  // At rest with constants of the free angle and linear kinematics both problems are the same one.
  BallStaticsOptions options;
  options.curvature = Curvature::Free;
  options.kinematics = RingKinematics::Linear;
  for (const bool tilted : {false, true})
    for (const auto& [x, y, z, about_y] : {std::array{17800.0, 0.0, 0.0, 0.0},
                                           {17800.0, 1000.0, 8900.0, 0.0},
                                           {9000.0, -2000.0, 3000.0, 120.0},
                                           {20000.0, 0.0, -15000.0, -50.0}}) {
      CAPTURE(x, y, z, about_y, tilted);
      Bearing bearing = angular_contact_218();
      load(bearing, x, y, z, about_y);
      if (tilted) bearing.constraints.outer_misalignment = {3e-4, -2e-4};
      const BallModel model = make_ball_model(bearing, options);
      const RaceLoadCase task = race_load_case(bearing.constraints);
      const Vec5 q = guess_by_springs(model, task, first_guess(model, task, Vec5::Zero()));
      const auto s = solve_ball_statics(bearing, options);
      double reach = 0.0;
      for (const double d : s.displacement) reach = std::max(reach, std::abs(d));
      RaceState<BallSpring> springs;
      for (const double azimuth : model.azimuth)
        springs.elements.push_back({std::sin(azimuth), std::cos(azimuth)});
      Vec5 exact;
      for (Eigen::Index k = 0; k < 5; ++k) exact(k) = s.displacement[static_cast<std::size_t>(k)];
      REQUIRE(update_race(BallSprings{model}, exact, springs));
      const RaceScales scales = race_scales(model);
      for (Eigen::Index k = 0; k < 5; ++k) {
        const auto n = static_cast<std::size_t>(k);
        CHECK(springs.load(k) == Approx(s.load[n]).epsilon(1e-9).margin(1e-6));
        for (Eigen::Index l = 0; l < 5; ++l)
          CHECK(springs.stiffness(k, l) ==
                Approx(s.stiffness(k, l)).epsilon(1e-7).margin(1e-9 * s.stiffness.norm()));
        CHECK(std::abs(q(k) - exact(k)) * lever_of(scales, k) < 0.02 * reach);
      }
    }
}

TEST_CASE("thrust load follows the closed form of one ball", "[physics][statics]") {
  Bearing bearing = angular_contact_218();
  load(bearing, 17800, 0, 0);
  BallStaticsOptions options;
  options.curvature = Curvature::Free;
  const auto s = solve_ball_statics(bearing, options);
  const auto& b = s.balls[3];
  // Q = Fx/(Z sin α); cos α = cos α0 B D/(B D + δ_o + δ_i) [harris2006].
  CHECK(b.Q[0] == Approx(17800 / (16 * std::sin(b.alpha[0]))).epsilon(1e-11));
  const double S = 2 * 0.0232 * 0.022225;
  CHECK(std::cos(b.alpha[1]) ==
        Approx(std::cos(40 * kPi / 180) * S / (S + b.delta[0] + b.delta[1])).epsilon(1e-12));
  CHECK(b.Q[0] == Approx(s.hertz[0].K * std::pow(b.delta[0], 1.5)).epsilon(1e-12));
  CHECK(s.max_load == Approx(b.Q[0]).epsilon(1e-9));
  CHECK(s.max_stiffness == Approx(1.5 * b.Q[0] / std::min(b.delta[0], b.delta[1])).epsilon(1e-9));
}

TEST_CASE("rigid bodies keep the free contact angle", "[physics][statics]") {
  Bearing bearing = angular_contact_218();
  bearing.element_material.elastic_modulus = 206e18;
  for (auto& race : bearing.race_material) race.elastic_modulus = 206e18;
  load(bearing, 17800, 0, 0);
  const auto s = solve_ball_statics(bearing);
  CHECK(s.balls[0].alpha[0] == Approx(40 * kPi / 180).epsilon(1e-7));
  CHECK(std::abs(s.displacement[0]) < 1e-10);
}

TEST_CASE("many balls under radial load give the radial integral 0.2288", "[physics][statics]") {
  Bearing bearing = make(4000, 0.0005, 1.0, 0.52, 0.52, 0.0, 0.0);
  load(bearing, 0, 0, 100);
  BallStaticsOptions options;
  options.kinematics = RingKinematics::Linear;
  options.curvature = Curvature::Free;
  hold(hold(hold(bearing, 0, 0.0), 3, 0.0), 4, 0.0);
  const auto s = solve_ball_statics(bearing, options);
  // Jr(1/2) = (1/2π) ∫ cos^2.5 ψ dψ = 0.2288 = Γ(1.75)/(2 √π Γ(2.25)).
  const double Jr = std::tgamma(1.75) / (2 * std::sqrt(kPi) * std::tgamma(2.25));
  CHECK(100.0 / (4000 * s.max_load) == Approx(Jr).epsilon(1e-5));
  CHECK(Jr == Approx(0.2288).margin(5e-5));  // four printed digits
}

TEST_CASE("turning load and balls by one pitch turns the answer", "[physics][statics]") {
  Bearing bearing = spindle(15000.0);
  load(bearing, 600, 0, 200, 0, 3);
  hold(hold(bearing, 3, 1e-4), 4, -5e-5);
  const double pitch = 2 * kPi / 18;
  const auto turn = [&](const std::array<double, 5>& v) {
    const double c = std::cos(pitch),
                 s = std::sin(pitch);  // right-handed about x: y' = c y - s z, z' = s y + c z
    return std::array<double, 5>{v[0], c * v[1] - s * v[2], s * v[1] + c * v[2],
                                 c * v[3] - s * v[4], s * v[3] + c * v[4]};
  };
  BallStaticsOptions linear;
  linear.kinematics =
      RingKinematics::Linear;  // tilts as vectors; the exact tilt angles are not vectors
  const auto first = solve_ball_statics(bearing, linear);
  Bearing turned = bearing;
  turned.constraints.load = turn(bearing.constraints.load);
  turned.constraints.displacement = turn(bearing.constraints.displacement);
  const auto second = solve_ball_statics(turned, linear);
  const auto expected = turn(first.displacement);
  for (std::size_t k = 0; k < 5; ++k)
    CHECK(second.displacement[k] == Approx(expected[k]).margin(k < 3 ? 1e-14 : 1e-12));
  for (std::size_t j = 0; j < 18; ++j)
    CHECK(second.balls[(j + 1) % 18].Q[0] == Approx(first.balls[j].Q[0]).epsilon(1e-9));
}

TEST_CASE("mirrored thrust mirrors the answer", "[physics][statics]") {
  Bearing bearing = deep_groove(2e-5, 8000.0);
  load(bearing, 1500, 0, 700);
  const auto plus = solve_ball_statics(bearing);
  load(bearing, -1500, 0, 700);
  const auto minus = solve_ball_statics(bearing);
  CHECK(minus.displacement[0] == Approx(-plus.displacement[0]).epsilon(1e-9));
  CHECK(minus.displacement[2] == Approx(plus.displacement[2]).epsilon(1e-9));
  CHECK(minus.displacement[3] == Approx(-plus.displacement[3]).epsilon(1e-8));
  for (std::size_t j = 0; j < 9; ++j) {
    CHECK(minus.balls[j].Q[1] == Approx(plus.balls[j].Q[1]).epsilon(1e-8));
    CHECK(minus.balls[j].omega_r ==
          Approx(-plus.balls[j].omega_r).margin(1e-6 * std::abs(plus.balls[j].omega_x)));
  }
}

TEST_CASE("lengths times s, forces times s², speeds over s leave angles alone",
          "[physics][statics]") {
  Bearing small = spindle(20000.0);
  load(small, 500, 0, 150, 2, 0);
  const double scale = 3.0;  // stress, angles and mass density stay: F ~ s², M ~ s³, ω ~ 1/s
  Bearing big =
      make(18, 0.00873125 * scale, 0.054 * scale, 0.525, 0.515, 25.0, 0.0, 20000.0 / scale);
  load(big, 500 * scale * scale, 0, 150 * scale * scale, 2 * scale * scale * scale, 0);
  const auto a = solve_ball_statics(small);
  const auto b = solve_ball_statics(big);
  CHECK(b.displacement[0] == Approx(scale * a.displacement[0]).epsilon(1e-8));
  CHECK(b.displacement[3] == Approx(a.displacement[3]).epsilon(1e-8));
  CHECK(b.balls[2].alpha[1] == Approx(a.balls[2].alpha[1]).epsilon(1e-9));
  CHECK(b.balls[2].p_max[0] == Approx(a.balls[2].p_max[0]).epsilon(1e-9));
  CHECK(b.stiffness(0, 0) == Approx(scale * a.stiffness(0, 0)).epsilon(1e-8));
}

TEST_CASE("linear and exact kinematics agree to the square of the tilt", "[physics][statics]") {
  for (double tilt : {1e-4, 1e-3}) {
    Bearing bearing = spindle(0.0);
    load(bearing, 500, 0, 100);
    hold(hold(bearing, 3, tilt), 4, 0.0);
    BallStaticsOptions linear;
    linear.kinematics = RingKinematics::Linear;
    const auto a = solve_ball_statics(bearing);
    const auto b = solve_ball_statics(bearing, linear);
    // Neglected: u²/(2 r), tilt² r/2 ~ 1e-8 m at 1e-3 rad, against approaches of 5e-6 m.
    CHECK(a.load[3] == Approx(b.load[3]).epsilon(tilt < 5e-4 ? 2e-3 : 1e-2));
    CHECK(a.max_load == Approx(b.max_load).epsilon(tilt < 5e-4 ? 2e-3 : 1e-2));
  }
}

TEST_CASE("tilting both races together is a rotation of the bearing", "[physics][statics]") {
  // Same tilt of both races about the same point: only the loads turn with them.
  Bearing straight = spindle();
  hold(hold(hold(hold(hold(straight, 0, 2e-5), 1, 0), 2, 0), 3, 0), 4, 0);
  Bearing tilted = straight;
  const double tilt = 2e-3;
  const auto groove = contact::groove_geometry(straight.balls());
  // P_inner stays on the outer axis, at its distance from P_outer: axis = (cos, 0, -sin) for a tilt
  // about y.
  const double distance = groove.centre_x[1] - groove.centre_x[0] + 2e-5;
  hold(tilted, 0, 2e-5 - distance * (1 - std::cos(tilt)));
  hold(tilted, 2, -distance * std::sin(tilt));
  hold(tilted, 3, tilt);
  tilted.constraints.outer_misalignment = {tilt, 0};
  const auto a = solve_ball_statics(straight);
  const auto b = solve_ball_statics(tilted);
  CHECK(b.load[0] == Approx(a.load[0] * std::cos(tilt)).epsilon(1e-5));
  CHECK(b.load[2] == Approx(-a.load[0] * std::sin(tilt)).epsilon(1e-2));
  CHECK(std::abs(b.load[3]) < 1e-4 * a.load[0] * straight.balls().pitch_diameter);
}

TEST_CASE("the start speeds of the balls have no slip at either contact center",
          "[physics][statics][spin]") {
  for (auto rule : {bearing::SpinRule::RaceControl, bearing::SpinRule::MinimumHeat,
                    bearing::SpinRule::Prescribed})
    for (double outer_rpm : {0.0, -7000.0, 3000.0}) {
      Bearing bearing = spindle(15000.0);
      bearing.speed[0] = outer_rpm * kPi / 30;
      bearing.spin_rule = rule;
      bearing.spin_angle = 0.4;
      load(bearing, 800, 30, 250);
      bearing.constraints.outer_misalignment = {2e-4, 1e-4};
      const auto s = solve_ball_statics(bearing);
      const auto groove = contact::groove_geometry(bearing.balls());
      for (const StaticBall& b : s.balls) {
        REQUIRE(b.inner_contact);
        const bearing::Vec3 radial(0, -std::sin(b.azimuth), std::cos(b.azimuth));
        const bearing::Vec3 around = bearing::Vec3::UnitX().cross(radial);
        const bearing::Vec3 centre = bearing::Vec3::UnitX() * b.x + radial * b.r;
        const bearing::Vec3 velocity = around * (b.r * b.orbital_speed);
        const bearing::Vec3 omega =
            bearing::Vec3::UnitX() * b.omega_x + radial * b.omega_r + around * b.omega_theta;
        std::array<double, 2> spin{};
        for (std::size_t j = 0; j < 2; ++j) {
          const double ty = j == 0 ? 2e-4 : s.displacement[3];
          const double tz = j == 0 ? 1e-4 : s.displacement[4];
          const bearing::Vec3 axis(std::cos(ty) * std::cos(tz), std::sin(tz),
                                   -std::sin(ty) * std::cos(tz));
          bearing::Vec3 P = bearing::Vec3::UnitX() * groove.centre_x[j];
          if (j == 1) P += bearing::Vec3(s.displacement[0], s.displacement[1], s.displacement[2]);
          const bearing::Vec3 d = centre - P;
          const bearing::Vec3 e = (d - axis * d.dot(axis)).normalized();
          const bearing::Vec3 v = d - e * groove.centre_radius[j];
          CHECK(v.norm() - groove.offset[j] == Approx(b.delta[j]).epsilon(1e-9));
          const bearing::Vec3 n = v.normalized();
          const double f = bearing.balls().groove_factor[j];
          const double D = bearing.balls().diameter;
          const double rho = 2 * f * D / (2 * f + 1);
          const double h =
              rho - std::sqrt(rho * rho - b.a[j] * b.a[j]) + std::sqrt(D * D / 4 - b.a[j] * b.a[j]);
          const bearing::Vec3 at = n * h;
          const bearing::Vec3 slip =
              (axis * bearing.speed[j]).cross(d + at) - velocity - omega.cross(at);
          const double surface_speed = std::abs(b.spin_speed) * 0.5 * D;
          // Along the rolling direction exactly zero: only rounding of speeds of 1e3 rad/s remains.
          CHECK(std::abs(slip.dot(axis.cross(e))) < 1e-12 * surface_speed);
          spin[j] = (axis * bearing.speed[j] - omega).dot(n) / b.spin_speed;
        }
        if (rule == bearing::SpinRule::RaceControl)
          CHECK(std::abs(spin[b.inner_race_control ? 1 : 0]) < 1e-12);
        if (rule == bearing::SpinRule::Prescribed)
          CHECK(std::atan2(b.omega_r, b.orbital_speed - b.omega_x) == Approx(0.4).epsilon(1e-10));
      }
    }
}

TEST_CASE("least heat: spin axis → minimum of the heat, between both race-control axes",
          "[physics][statics][spin]") {
  const double gamma = 0.18;
  for (double ratio : {0.2, 0.9, 1.5, 6.0}) {
    std::array<HeatContact, 2> c;
    c[0] = {
        {std::sin(0.5), std::cos(0.5)}, 100.0 * ratio, 1e-3 * std::cbrt(ratio), 0.0, 7.0, 0.011};
    c[1] = {{std::sin(0.75), std::cos(0.75)}, 100.0, 1e-3, 0.0, 8.0, 0.011};
    const auto axis = least_heat_axis(c, gamma);
    const double at = heat_of_axis(c, gamma, axis.beta).heat;
    CHECK(heat_of_axis(c, gamma, axis.beta + 0.01).heat > at);
    CHECK(heat_of_axis(c, gamma, axis.beta - 0.01).heat > at);
    const double outer = std::atan2(std::sin(0.5), std::cos(0.5) + gamma);
    const double inner = std::atan2(std::sin(0.75), std::cos(0.75) - gamma);
    CHECK(axis.beta > outer - 0.05);
    CHECK(axis.beta < inner + 0.05);
    // The heavier contact pulls the axis to its own.
    if (ratio > 5) CHECK(axis.beta - outer < 0.3 * (inner - outer));
    if (ratio < 0.3) CHECK(inner - axis.beta < 0.3 * (inner - outer));
  }
}

TEST_CASE("the least-heat axis moves with angles and loads as its derivatives say",
          "[physics][statics][spin]") {
  const double gamma = 0.18;
  const auto axis = [&](const std::array<double, 4>& v) {  // α_o, α_i, Q_o, Q_i
    std::array<HeatContact, 2> c;
    for (std::size_t j = 0; j < 2; ++j) {
      // a grows with exp(0.3 α) and Q^(1/3).
      const double a = 2e-4 * std::exp(0.3 * v[j]) * std::cbrt(v[j + 2]);
      c[j] = {{std::sin(v[j]), std::cos(v[j])}, v[j + 2], a, 0.3, 7.0 + double(j), 0.011};
    }
    return least_heat_axis(c, gamma);
  };
  for (const double outer_load : {60.0, 100.0, 300.0}) {
    const std::array<double, 4> at{0.5, 0.75, outer_load, 100.0};
    const auto here = axis(at);
    for (std::size_t k = 0; k < 4; ++k) {
      const double h = 1e-5 * at[k];
      auto up = at;
      auto down = at;
      up[k] += h;
      down[k] -= h;
      const double difference = (axis(up).beta - axis(down).beta) / (2 * h);
      const double exact = k < 2 ? here.over_angle[k] : here.over_load[k - 2];
      // Central differences: error of the order of 1e-7 with this step, rounding 1e-15/1e-5.
      CHECK(exact == Approx(difference).epsilon(1e-6));
    }
  }
}

TEST_CASE("pure radial load has one spin axis under every rule", "[physics][statics][spin]") {
  std::array<double, 3> spin{};
  std::size_t k = 0;
  for (auto rule : {bearing::SpinRule::RaceControl, bearing::SpinRule::MinimumHeat,
                    bearing::SpinRule::Prescribed}) {
    Bearing bearing = deep_groove(1e-5, 6000.0);
    bearing.spin_rule = rule;
    load(bearing, 0, 0, 2000);
    const auto s = solve_ball_statics(bearing);
    CHECK(std::abs(s.balls[0].omega_r) < 1e-9 * std::abs(s.balls[0].omega_x));
    spin[k++] = s.balls[0].omega_x;
    const auto epicyclic = epicyclic_speeds(9, 0.0127, 0.065, 0.0, 0.0, bearing.speed[1]);
    CHECK(s.balls[0].orbital_speed ==
          Approx(epicyclic.cage_speed).epsilon(2e-3));  // elastic approach over d_m
    CHECK(std::abs(s.balls[0].spin_speed) == Approx(epicyclic.element_spin).epsilon(2e-3));
  }
  CHECK(spin[0] == Approx(spin[1]).epsilon(1e-9));
  CHECK(spin[0] == Approx(spin[2]).epsilon(1e-9));
}

TEST_CASE("turning both races by the same speed only adds a rotation", "[physics][statics][spin]") {
  Bearing bearing = spindle(10000.0);
  load(bearing, 800, 0, 0);
  bearing.element_inertia = {};  // no inertia: the speeds are pure kinematics
  BallStaticsOptions options;
  options.control = Control::Outer;
  const auto a = solve_ball_statics(bearing, options);
  const double extra = 250.0;
  bearing.speed[0] += extra;
  bearing.speed[1] += extra;
  const auto b = solve_ball_statics(bearing, options);
  CHECK(b.balls[0].orbital_speed == Approx(a.balls[0].orbital_speed + extra).epsilon(1e-10));
  CHECK(b.balls[0].omega_x == Approx(a.balls[0].omega_x + extra).epsilon(1e-10));
  CHECK(b.balls[0].omega_r == Approx(a.balls[0].omega_r).epsilon(1e-10));
}

TEST_CASE("the race that spins less reluctantly controls", "[physics][statics][spin]") {
  Bearing slow = spindle(
      100.0);  // f_i < f_o: the inner contact is the longer one, so it controls at low speed
  load(slow, 800, 0, 0);
  const auto a = solve_ball_statics(slow);
  CHECK(a.race_control_ratio < 1.0);
  CHECK(a.balls[0].inner_race_control);
  CHECK(std::abs(a.balls[0].spin_roll[1]) < 1e-12);
  Bearing fast = spindle(40000.0);
  load(fast, 800, 0, 0);
  const auto b = solve_ball_statics(fast);
  CHECK(b.race_control_ratio > 1.0);
  CHECK_FALSE(b.balls[0].inner_race_control);
  CHECK(std::abs(b.balls[0].spin_roll[0]) < 1e-12);
}

TEST_CASE("Newton's iteration ends in few steps from a cold and at once from a warm start",
          "[unit][statics]") {
  Bearing bearing = angular_contact_218(6000.0);
  load(bearing, 17800, 0, 8900);
  const auto cold = solve_ball_statics(bearing);
  CHECK(cold.iterations <= 20);
  bearing.constraints.displacement = cold.displacement;
  BallStaticsOptions options;
  options.warm_start = true;
  const auto warm = solve_ball_statics(bearing, options);
  CHECK(warm.iterations <=
        10);  // the conservative first stage moves away from the given point and comes back
  for (std::size_t k = 0; k < 5; ++k)
    CHECK(warm.displacement[k] == Approx(cold.displacement[k]).margin(1e-13));
}

TEST_CASE("contact edges follow groove, shoulder and split", "[unit][statics]") {
  Bearing bearing = angular_contact_218();
  bearing.balls().shoulder_diameter = {0.1385, 0.1125};
  bearing.balls().shim = {0.0, 3e-4};
  load(bearing, 17800, 0, 0);
  const auto s = solve_ball_statics(bearing);
  const auto& b = s.balls[0];
  const auto groove = contact::groove_geometry(bearing.balls());
  const double fD = 0.5232 * 0.022225;
  CHECK(b.edge[0] ==
        Approx(fD * std::cos(b.alpha[0] + b.a[0] / fD) + groove.centre_radius[0] - 0.06925)
            .epsilon(1e-12));
  CHECK(b.shoulder_depth[1] ==
        Approx(0.05625 - (groove.centre_radius[1] - fD * std::cos(b.alpha[1] + b.a[1] / fD)))
            .epsilon(1e-10));
  CHECK(b.edge[1] == Approx(fD * std::sin(b.alpha[1] - b.a[1] / fD)).epsilon(1e-12));
  bearing.balls().shoulder_diameter[0] = 2.0 * (b.edge[0] + 0.06925) + 1e-6;
  const auto over = solve_ball_statics(bearing);
  for (const auto& ball : over.balls) CHECK(ball.beyond[0] > 0.0);
  CHECK(over.notes.empty());
}

TEST_CASE("epicyclic speeds reject impossible bearings", "[unit][statics]") {
  CHECK_THROWS_WITH(epicyclic_speeds(0, 0.01, 0.05, 0, 0, 1), Catch::Contains("at least one"));
  CHECK_THROWS_WITH(epicyclic_speeds(8, 0.05, 0.05, 0, 0, 1), Catch::Contains("pitch diameter"));
  CHECK_THROWS_AS(epicyclic_speeds(8, 0.01, 0.05, 0, std::nan(""), 1), InputError);
}
