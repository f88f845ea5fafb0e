#include "core/dynamics/system_fixture.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

/// Balls at rest between races at rest, thrust F [N], no friction: nothing turns.
bearing::Bearing standing(double thrust) {
  bearing::Bearing b = angular_contact(12);
  b.cage.reset();
  b.speed = {0.0, 0.0};
  b.constraints.load = {thrust, 0.0, 0.0, 0.0, 0.0};
  return b;
}

}  // namespace

TEST_CASE(
    "a free race without contacts falls, spins up and circles its mass center as a rigid body",
    "[physics][dynamics][races]") {
  bearing::Bearing b = angular_contact(6);
  b.cage.reset();
  const Vec3 c(2e-3, 0.0, 1e-3), weight(3.0, -2.0, 5.0);
  b.race_inertia[1] = {0.4, {4e-4, 3e-4, 3e-4}, -c};
  b.gravity = weight / 0.4;
  ScenePlan plan = plan_with({Effect::MomentumLedger, Effect::Gravity});
  bearing::FreeRace& free = plan.race_motions.free[1].emplace();
  free.moment = {0.7, 0.0, 0.0};
  System system = make_system(b, plan);
  const std::vector<double> y0 = system.initial_state();
  const double t = 1e-3, speed = b.speed[1];
  const Snapshot start = system.snapshot(0.0, y0);
  const RunResult result = run(system, y0, t, 1e-11, "rkf7");
  const Snapshot now = system.snapshot(t, result.y);
  const RaceSnapshot& race = now.races[1];
  // The applied moment is along a principal axis through the mass center: it turns about X alone.
  const double turn = speed * t + 0.5 * free.moment[0] / 4e-4 * t * t;
  CHECK(race.total_rotation == Approx(turn).epsilon(1e-8));
  CHECK(race.omega.x() == Approx(speed + free.moment[0] / 4e-4 * t).epsilon(1e-10));
  CHECK(now.shaft_rotation == Approx(turn).epsilon(1e-8));
  const Vec3 turned(c[0], c[1] * std::cos(turn) - c[2] * std::sin(turn),
                    c[1] * std::sin(turn) + c[2] * std::cos(turn));
  const Vec3 v0 = speed * Vec3::UnitX().cross(c);  // of the mass center: the groove was at rest
  const Vec3 expected = start.races[1].position + c + v0 * t + 0.5 * t * t / 0.4 * weight;
  CHECK((race.position + turned - expected).norm() < 1e-10);
  const Vec3 at_groove = v0 + t / 0.4 * weight - race.omega.cross(turned);
  CHECK((race.velocity - at_groove).norm() < 1e-8 * at_groove.norm());
  // The loads are all that acts.
  CHECK(std::abs(now.energy.residual()) < 1e-9 * now.energy.sum(LedgerKind::Start));
  CHECK(now.energy.value("load_work", 1) == Approx(free.moment[0] * turn).epsilon(1e-8));
  CHECK(now.momentum->linear.residual().norm() < 1e-10 * now.momentum->linear_size);
  CHECK(now.momentum->angular.residual().norm() < 1e-9 * now.momentum->angular_size);
}

TEST_CASE("a load on a free race acts at its center and turns an unbalanced one",
          "[physics][dynamics][races]") {
  bearing::Bearing b = angular_contact(6);
  b.cage.reset();
  b.speed = {0.0, 0.0};
  b.race_inertia[1] = {0.4, {4e-4, 3e-4, 3e-4}, {0.0, 0.0, -1e-3}};  // mass center above
  ScenePlan plan = plan_with({Effect::MomentumLedger});
  plan.race_motions.free[1].emplace().force = {0.0, 8.0, 0.0};
  System system = make_system(b, plan);
  std::vector<double> y = system.initial_state(), rates(y.size());
  REQUIRE(system.rhs(0.0, y.data(), rates.data()) == RhsStatus::Ok);
  const RaceSnapshot race = system.snapshot(0.0, y).races[1];
  CHECK(race.applied_force == Vec3(0.0, 8.0, 0.0));
  // a_G = F/m; α_x = (-c × F)_x / I = c_z F_y / I; of the center: a_G - α × c.
  const double alpha = 1e-3 * 8.0 / 4e-4;
  CHECK((race.acceleration - Vec3(0.0, 8.0 / 0.4 + alpha * 1e-3, 0.0)).norm() < 1e-9);
}

TEST_CASE(
    "a race held at its center turns about it whatever its balance, and what holds it is booked",
    "[physics][dynamics][races]") {
  bearing::Bearing b = angular_contact(6);
  b.cage.reset();
  const Vec3 c(1e-3, 4e-4, -3e-4);
  b.race_inertia[1] = {0.4, {4e-4, 3e-4, 2.5e-4}, -c, {0.2, -0.3, 0.1}};
  b.constraints.displacement[3] = 2e-3;  // misaligned about y
  ScenePlan plan = plan_with({Effect::MomentumLedger});
  bearing::FreeRace& free = plan.race_motions.free[1].emplace();
  free.moment = {0.9, 0.0, 0.0};
  free.translation_held = {true, true, true};
  SECTION("only its spin is free: its axis stands") { free.rotation_held = {false, true, true}; }
  SECTION("its speed follows a ramp") {
    free.rotation_held = {true, true, true};
    plan.race_motions.ramp[1] = bearing::SpeedRampParameters{4e5, 2e-4, 7e-4};
  }
  SECTION("it vibrates and tilts freely") {
    free.rotation_held = {true, false, false};
    plan.race_motions.vibration[1] = bearing::Vibration{{1e-6, 2e-6, 0.0}, 900.0};
  }
  System system = make_system(b, plan);
  const std::vector<double> y0 = system.initial_state();
  const double t = 1e-3;
  const Snapshot start = system.snapshot(0.0, y0);
  const Snapshot now = system.snapshot(t, run(system, y0, t, 1e-10, "rkf7").y);
  const RaceSnapshot &before = start.races[1], &after = now.races[1];
  Vec3 way = Vec3::Zero();
  if (plan.race_motions.vibration[1])
    way = std::sin(2.0 * std::numbers::pi * 900.0 * t) * Vec3(1e-6, 2e-6, 0.0);
  CHECK((after.position - before.position - way).norm() < 1e-11);
  const Vec3 axis = rotation_matrix(before.orientation).col(0);
  if (free.rotation_held[1]) {
    CHECK((rotation_matrix(normalize_quaternion(after.orientation)).col(0) - axis).norm() < 1e-9);
    if (plan.race_motions.ramp[1])
      CHECK(after.omega.dot(axis) == Approx(b.speed[1] + 4e5 * 5e-4));
    else
      CHECK(after.omega.norm() != Approx(b.speed[1]).epsilon(1e-3));
  } else {
    CHECK(after.omega.dot(axis) == Approx(before.omega.dot(axis)));
  }
  CHECK(after.applied_force.norm() > 1.0);
  CHECK(std::abs(now.energy.residual()) < 1e-8 * now.energy.sum(LedgerKind::Start));
  CHECK(now.momentum->linear.residual().norm() < 1e-8 * now.momentum->linear_size);
  CHECK(now.momentum->angular.residual().norm() < 1e-8 * now.momentum->angular_size);
}

TEST_CASE("free inner race: step of thrust → eigenfrequency of the static stiffness",
          "[physics][dynamics][races]") {
  const double thrust = 1500.0, step = 15.0, mass = 20.0;  // 200 times the balls
  const auto place = [](double load) {
    const bearing::Bearing b = standing(load);
    return statics_of(b, b.balls().contact_angle).displacement[0];
  };
  const double stiffness = 2.0 * step / (place(thrust + 2.0 * step) - place(thrust));
  const double w = std::sqrt(stiffness / mass), half = std::numbers::pi / w;

  bearing::Bearing b = standing(thrust);
  b.race_inertia[1] = {mass, {0.04, 0.03, 0.03}};
  ScenePlan plan = plan_with({Effect::RaceContact, Effect::MomentumLedger});
  plan.race_motions.free[1].emplace().force = {thrust + step, 0.0, 0.0};
  double previous = 1e300;
  for (const double tolerance : {1e-5, 1e-8}) {
    System system = make_system(b, plan);
    const std::vector<double> y0 = system.initial_state();
    const double x0 = system.snapshot(0.0, y0).races[1].position.x();
    const RunResult result = run(system, y0, half, tolerance, "rkf4");
    const Snapshot now = system.snapshot(half, result.y);
    // Half a period after the step: twice the static change, at rest again.
    const double way = now.races[1].position.x() - x0, expected = 2.0 * step / stiffness;
    INFO("tolerance " << tolerance << ": way " << way << ", static " << expected);
    CHECK(way == Approx(expected).epsilon(0.01));
    CHECK(std::abs(now.races[1].velocity.x()) < 0.02 * w * 0.5 * expected);
    CHECK(std::abs(now.races[1].position.z()) < 1e-3 * expected);
    const double moved = now.energy.value("load_work", 1);
    CHECK(moved == Approx((thrust + step) * way).epsilon(1e-6));
    const double residual = std::abs(now.energy.residual()) / moved;
    const double impulse = (now.momentum->linear.residual()).norm() / (step * half);
    INFO("energy residual " << residual << ", momentum residual " << impulse);
    CHECK(residual < 0.1 * previous);
    CHECK(impulse < 1e-3);
    previous = residual;
  }
  CHECK(previous < 1e-6);
}

TEST_CASE("shaft-like race under its unbalance: energy and momentum kept",
          "[physics][dynamics][races][energy]") {
  bearing::Bearing b = angular_contact(12);
  b.gravity = {0.0, 0.0, -9.81};
  b.race_inertia[1] = {0.8, {6e-4, 5e-4, 5e-4}, {0.0, 0.0, -2e-6}};
  ScenePlan plan = full_plan();
  plan.effects.push_back({Effect::MomentumLedger, "", true, "test"});
  bearing::FreeRace& free = plan.race_motions.free[1].emplace();
  free.force = {1500.0, 0.0, 500.0};
  free.rotation_held = {true, true, true};  // driven at constant speed, guided
  const double end = 3e-4;
  double first = 0.0, energy = 0.0, linear = 0.0, angular = 0.0;
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    System system = make_system(b, plan);
    const RunResult result = run(system, system.initial_state(), end, tolerance, "rkf4");
    const Snapshot now = system.snapshot(end, result.y);
    CHECK(now.races[1].omega.x() == Approx(b.speed[1]).epsilon(1e-12));
    CHECK(now.races[1].velocity.norm() > 1e-6);
    energy = std::abs(now.energy.residual()) / now.energy.sum(LedgerKind::Start);
    linear = now.momentum->linear.residual().norm() / now.momentum->linear_size;
    angular = now.momentum->angular.residual().norm() / now.momentum->angular_size;
    INFO("tolerance " << tolerance << ": energy " << energy << ", momentum " << linear << ", "
                      << angular);
    if (first == 0.0) first = energy;
    CHECK(energy <= first);
    CHECK(now.energy.find("work", 1) == nullptr);  // a free race is not moved from outside
    CHECK(now.energy.find("load_work", 1) != nullptr);
  }
  CHECK(energy < 1e-2 * first);
  CHECK(linear < 1e-5);
  CHECK(angular < 1e-5);
}

TEST_CASE("races excited by laws of time: follow the laws, energy ledger closes",
          "[physics][dynamics][excitations]") {
  bearing::Bearing b = angular_contact(9);
  ScenePlan plan = full_plan();
  bearing::RaceMotions& motions = plan.race_motions;
  const double pi = std::numbers::pi, t = 4e-4;
  motions.rotating_load_parameters = bearing::RotatingLoadParameters{{0.0, 0.6}, {0.0, 900.0}};
  motions.vibration[0] = bearing::Vibration{{1e-6, 0.0, 2e-6}, 800.0};
  motions.ramp[1] = bearing::SpeedRampParameters{5e4, 1e-4, 3e-4};
  motions.variation[0] = bearing::SpeedVariation{20.0, 500.0};
  System system = make_system(b, plan);
  // A part of the shortest period, then the kinks of the ramp.
  CHECK(system.longest_step(0.0) == Approx(1.0 / (20.0 * 800.0)));
  CHECK(system.longest_step(9.9e-5) == Approx(1e-6));
  CHECK(make_system(b, full_plan()).longest_step(0.0) > 1e300);

  double first = 0.0, residual = 0.0;
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    const RunResult result = run(system, system.initial_state(), t, tolerance, "rkf4");
    const Snapshot now = system.snapshot(t, result.y);
    const RaceSnapshot &outer = now.races[0], &inner = now.races[1];
    const double w = 2.0 * pi * 800.0;
    CHECK(outer.position.z() == Approx(2e-6 * std::sin(w * t)));
    CHECK(outer.velocity.x() == Approx(1e-6 * w * std::cos(w * t)));
    CHECK(outer.acceleration.z() == Approx(-2e-6 * w * w * std::sin(w * t)));
    const double v = 2.0 * pi * 500.0;
    CHECK(outer.omega.x() == Approx(20.0 * std::sin(v * t)));
    CHECK(outer.total_rotation == Approx(20.0 / v * (1.0 - std::cos(v * t))));
    CHECK(inner.omega.x() == Approx(b.speed[1] + 5e4 * 2e-4));
    CHECK(inner.total_rotation == Approx(b.speed[1] * t + 5e4 * (0.5 * 2e-4 * 2e-4 + 2e-4 * 1e-4)));
    // 0.6 of the static radial deflection has turned by 0.36 rad, the rest stays.
    const Vec3 at_rest = system.snapshot(0.0, system.initial_state()).races[1].position;
    const double deflection = std::hypot(at_rest[1], at_rest[2]), psi = azimuth(at_rest);
    const Vec3 expected =
        at_rest + 0.6 * deflection * (radial_direction(psi + 0.36) - radial_direction(psi));
    CHECK((inner.position - expected).norm() < 1e-9 * deflection);
    residual = std::abs(now.energy.residual());
    INFO("tolerance " << tolerance << ": residual " << residual);
    if (first == 0.0) first = residual;
    CHECK(residual <= first);
  }
  CHECK(residual < 1e-2 * first);
}

TEST_CASE("rotating base frame: free bodies move straight in space",
          "[physics][dynamics][frames]") {
  bearing::Bearing b = angular_contact(6);
  b.cage->inertia = {0.05, {5e-5, 3e-5, 4e-5}};
  b.cage->start_angles = {0.0, 0.1, -0.05};
  ScenePlan plan = plan_with({Effect::CageMotion, Effect::MomentumLedger});
  const bearing::FrameMotion frame{400.0, 0.12, 0.7};
  plan.race_motions.frame = frame;
  System system = make_system(b, plan);
  const std::vector<double> y0 = system.initial_state();
  const double t = 1e-3;
  const RunResult result = run(system, y0, t, 1e-11, "rkf7");
  const Snapshot start = system.snapshot(0.0, y0), now = system.snapshot(t, result.y);

  const Vec3 Omega = frame.speed * Vec3::UnitX();
  const auto rotated = [&](const Vec3& v, double time) {
    return Vec3(rotation_matrix(quaternion_about(Vec3::UnitX(), frame.speed * time)) * v);
  };
  struct Motion {
    Vec3 place, velocity, omega;
  };
  const Vec3 origin = frame.orbit_radius * radial_direction(frame.orbit_angle);
  // In space: axes of the frame at t = 0.
  const auto in_space = [&](const Motion& m, double time) {
    return Motion{rotated(origin + m.place, time),
                  rotated(m.velocity + Omega.cross(origin + m.place), time),
                  rotated(m.omega + Omega, time)};
  };
  const auto of_ball = [](const ElementSnapshot& e) {
    const Vec3 e_r = radial_direction(e.theta), e_t = circumferential_direction(e.theta);
    return Motion{e.x * Vec3::UnitX() + e.r * e_r,
                  e.vx * Vec3::UnitX() + e.vr * e_r + e.r * e.theta_dot * e_t,
                  e.omega[0] * Vec3::UnitX() - e.omega[1] * e_t + e.omega[2] * e_r};
  };
  for (std::size_t i = 0; i < 6; ++i) {
    const Motion before = in_space(of_ball(start.elements[i]), 0.0),
                 after = in_space(of_ball(now.elements[i]), t);
    CHECK((after.velocity - before.velocity).norm() < 1e-8 * before.velocity.norm());
    CHECK((after.place - before.place - t * before.velocity).norm() < 1e-10);
    CHECK((after.omega - before.omega).norm() < 1e-8 * before.omega.norm());
  }
  // The cage, with three different moments of inertia, keeps its angular momentum in space.
  const auto momentum_of = [&](const Snapshot& s, double time) {
    const Mat3 R = rotation_matrix(normalize_quaternion(s.cages[0].orientation));
    const Vec3 whole = R.transpose() * (s.cages[0].omega + Omega);
    return rotated(R * b.cage->inertia.moments.cwiseProduct(whole), time);
  };
  const Vec3 before = momentum_of(start, 0.0), after = momentum_of(now, t);
  CHECK((after - before).norm() < 1e-8 * before.norm());
  CHECK((now.cages[0].omega - start.cages[0].omega).norm() > 1e-3 * start.cages[0].omega.norm());
  CHECK(std::abs(now.energy.residual()) < 1e-8 * std::abs(now.energy.value("kinetic")));
  CHECK(now.momentum->linear.residual().norm() < 1e-9 * now.momentum->linear_size);
  CHECK(now.momentum->angular.residual().norm() < 1e-8 * now.momentum->angular_size);
}
