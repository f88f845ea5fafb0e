#include "core/dynamics/system_fixture.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

/// Limits that moving races must obey whatever the bearing.
using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

using Vec5 = Eigen::Matrix<double, 5, 1>;
using Mat5 = Eigen::Matrix<double, 5, 5>;

/// Balls and races at rest, thrust and radial load, no friction, no cage; tilts under moments.
bearing::Bearing at_rest(const Vec5& load) {
  bearing::Bearing b = angular_contact(12);
  b.cage.reset();
  b.speed = {0.0, 0.0};
  b.constraints.displacement_given = {};
  for (int k = 0; k < 5; ++k) b.constraints.load[static_cast<std::size_t>(k)] = load[k];
  return b;
}

Vec5 place_under(const Vec5& load) {
  const bearing::Bearing b = at_rest(load);
  const auto& displacement = statics_of(b, b.balls().contact_angle).displacement;
  Vec5 out;
  for (int k = 0; k < 5; ++k) out[k] = displacement[static_cast<std::size_t>(k)];
  return out;
}

std::size_t index_of(const System& system, const std::string& group) {
  for (const StateLayout::Group& g : system.layout().groups())
    if (g.name == group) return static_cast<std::size_t>(g.slice.first);
  FAIL("no group " << group);
  return 0;
}

}  // namespace

TEST_CASE("a race vibrates on its bearing at the eigenfrequencies of the static stiffness",
          "[physics][dynamics][races][limits]") {
  Vec5 load;
  load << 3000.0, 0.0, 0.0, 0.0, 0.0;
  // Compliance by differences: displacements of small changes of each load.
  Mat5 compliance;
  for (int k = 0; k < 5; ++k) {
    Vec5 step = Vec5::Zero();
    step[k] = k < 3 ? 3.0 : 0.1;
    compliance.col(k) = (place_under(load + step) - place_under(load - step)) / (2.0 * step[k]);
  }
  const Mat5 stiffness = (0.5 * (compliance + compliance.transpose())).inverse();
  const double mass = 25.0, polar = 0.05, transverse = 0.03;  // the balls have 0.1 kg together
  Vec5 inertia;
  inertia << mass, mass, mass, transverse, transverse;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Mat5> modes(stiffness, Mat5(inertia.asDiagonal()));
  REQUIRE(modes.eigenvalues()[0] > 0.0);
  const Vec5 rest = place_under(load);
  for (int mode = 0; mode < 5; ++mode) {
    const double w = std::sqrt(modes.eigenvalues()[mode]);
    Vec5 shape = modes.eigenvectors().col(mode);
    shape *= 2e-8 / std::max(shape.head<3>().cwiseAbs().maxCoeff(),
                             0.04 * shape.tail<2>().cwiseAbs().maxCoeff());
    bearing::Bearing b = at_rest(load);
    b.race_inertia[1] = {mass, {polar, transverse, transverse}};
    ScenePlan plan = plan_with({Effect::RaceContact});
    const Vec5 push = stiffness * shape;
    bearing::FreeRace& free = plan.race_motions.free[1].emplace();
    free.force = Vec3(load.head<3>() + push.head<3>());
    free.moment = Vec3(0.0, load[3] + push[3], load[4] + push[4]);
    free.rotation_held = {true, false, false};
    System system = make_system(b, plan);
    // Released at the old place it swings about the new one: after four whole periods it is back,
    // half a period later twice as far away.
    const double period = 2.0 * std::numbers::pi / w;
    const std::vector<double> y0 = system.initial_state();
    const auto place = [&](double t) {
      const Snapshot now = system.snapshot(t, run(system, y0, t, 1e-7, "rkf7").y);
      const RaceSnapshot& race = now.races[1];
      const Vec3 axis = rotation_matrix(normalize_quaternion(race.orientation)).col(0);
      Vec5 out;
      // A small turn ξ about y moves the tip of the axis by -ξ along z, a turn λ about z by λ along
      // y.
      out << race.position, -axis[2], axis[1];
      return Vec5(out - rest);
    };
    const double size = shape.dot(inertia.cwiseProduct(shape));
    const auto share = [&](const Vec5& at) { return shape.dot(inertia.cwiseProduct(at)) / size; };
    const double late = share(place(4.5 * period));
    // 1 - cos of the phase at a quarter before: slope 1 per radian, 28 rad of phase.
    const double quarter = share(place(4.25 * period));
    INFO("mode " << mode << " at " << w / (2.0 * std::numbers::pi) << " Hz, shape "
                 << shape.transpose() << ": " << late << ", " << quarter);
    CHECK(late == Approx(2.0).epsilon(0.02));
    CHECK(std::abs(quarter - 1.0) < 0.005 * 4.25 * 2.0 * std::numbers::pi);
  }
}

TEST_CASE("a load that turns with the observer's frame is a fixed load",
          "[physics][dynamics][races][limits]") {
  // Inner race driven on a circle at w, seen at rest; and the same seen from axes that turn at w:
  // races at speeds less w, a fixed displacement, transport and Coriolis forces.
  const double w = 400.0, t = 1.5e-3;
  bearing::Bearing still = angular_contact(9);
  still.constraints.displacement_given = {true, true, true, true, true};
  still.constraints.displacement = {3e-5, 4e-6, 8e-6, 0.0, 0.0};
  bearing::Bearing turning = still;
  turning.speed = {-w, still.speed[1] - w};
  ScenePlan with_load = full_plan(), in_frame = full_plan();
  with_load.race_motions.rotating_load_parameters =
      bearing::RotatingLoadParameters{{0.0, 1.0}, {0.0, w}};
  in_frame.race_motions.frame = bearing::FrameMotion{w, 0.0, 0.0};
  System a = make_system(still, with_load), b = make_system(turning, in_frame);
  const std::vector<double> y0 = a.initial_state();
  std::vector<double> z0 = y0;
  for (const char* spin : {"element.theta_dot", "element.omega_x"})
    for (std::size_t i = 0; i < 9; ++i) z0[index_of(b, spin) + i] -= w;
  z0[index_of(b, "cage.omega")] -= w;
  const Snapshot at_rest = a.snapshot(t, run(a, y0, t, 1e-11, "rkf7").y);
  const Snapshot relative = b.snapshot(t, run(b, z0, t, 1e-11, "rkf7").y);
  for (std::size_t i = 0; i < 9; ++i) {
    const ElementSnapshot &p = at_rest.elements[i], &q = relative.elements[i];
    CHECK(p.x == Approx(q.x).margin(1e-9));  // 4e-10 at this tolerance, deflections are 1e-5
    CHECK(p.r == Approx(q.r).margin(1e-9));
    CHECK(p.theta == Approx(q.theta + w * t).margin(1e-7));
    for (std::size_t j = 0; j < 2; ++j)
      CHECK(p.race[j].load == Approx(q.race[j].load).epsilon(1e-4).margin(1e-2));
  }
  CHECK(at_rest.cages[0].total_rotation == Approx(relative.cages[0].total_rotation + w * t));
  CHECK(at_rest.energy.sum(LedgerKind::Heat) ==
        Approx(relative.energy.sum(LedgerKind::Heat)).epsilon(1e-4));
  CHECK(std::abs(relative.races[1].position.z() - 8e-6) < 1e-12);
}

TEST_CASE("a bearing turned about its axis gives turned results", "[physics][dynamics][limits]") {
  const double turn = 0.7, t = 1e-3;
  const Mat3 R = rotation_matrix(quaternion_about(Vec3::UnitX(), turn));
  const auto scene = [&](bool turned) {
    bearing::Bearing b = angular_contact(9);
    b.race_inertia[1] = {0.6, {5e-4, 4e-4, 4e-4}, {0.0, 1e-5, -2e-5}};
    Vec3 load(1500.0, 0.0, 500.0), gravity(0.0, 0.0, -9.81), offset(0.0, 5e-5, -9e-5);
    if (turned) {
      load = R * load;
      gravity = R * gravity;
      offset = R * offset;
      b.race_inertia[1].geometric_centre = R * b.race_inertia[1].geometric_centre;
    }
    for (int k = 0; k < 3; ++k) b.constraints.load[static_cast<std::size_t>(k)] = load[k];
    b.gravity = gravity;
    b.cage->start_offset = offset;
    ScenePlan plan = full_plan();
    bearing::FreeRace& free = plan.race_motions.free[1].emplace();
    free.force = load;
    free.rotation_held = {true, true, true};
    const double angle = b.balls().contact_angle;
    System system = make_system(
        b, plan, statics_of(b, angle, statics::Control::FromBearing, turned ? turn : 0.0));
    return system.snapshot(t, run(system, system.initial_state(), t, 1e-9, "rkf7").y);
  };
  const Snapshot plain = scene(false), turned = scene(true);
  for (std::size_t i = 0; i < 9; ++i) {
    CHECK(turned.elements[i].theta == Approx(plain.elements[i].theta + turn).margin(1e-7));
    CHECK(turned.elements[i].x == Approx(plain.elements[i].x).margin(1e-9));
    CHECK(turned.elements[i].race[1].load ==
          Approx(plain.elements[i].race[1].load).epsilon(1e-4).margin(1e-2));
  }
  CHECK((turned.races[1].position - R * plain.races[1].position).norm() < 1e-10);
  CHECK((turned.races[1].velocity - R * plain.races[1].velocity).norm() < 1e-6);
  CHECK(turned.races[1].velocity.norm() > 1e-5);
}

TEST_CASE("a free race holds the mean asked load", "[physics][dynamics][races][limits]") {
  bearing::Bearing b = angular_contact(12);
  b.race_inertia[1] = {0.5, {4e-4, 3e-4, 3e-4}};
  ScenePlan plan = full_plan();
  bearing::FreeRace& free = plan.race_motions.free[1].emplace();
  const Vec3 asked(1500.0, 0.0, 500.0);
  free.force = asked;
  free.rotation_held = {true, true, true};
  System system = make_system(b, plan);
  const double turn = 2.0 * std::numbers::pi / b.speed[1];
  const std::vector<double> y0 = system.initial_state();
  const RaceSnapshot before = system.snapshot(0.0, y0).races[1];
  const RaceSnapshot after = system.snapshot(turn, run(system, y0, turn, 1e-6).y).races[1];
  // Newton: what the elements exert on the mean is the change of the race's momentum, less the
  // load.
  const Vec3 mean = asked - 0.5 / turn * (after.velocity - before.velocity);
  INFO("mean " << mean.transpose() << ", moved " << (after.position - before.position).norm());
  CHECK((mean - asked).norm() < 0.005 * asked.norm());
  CHECK(after.velocity.norm() > 0.0);
  CHECK((after.position - before.position).norm() < 5e-6);
}

TEST_CASE("a free race runs alike with implicit-explicit, implicit and explicit steppers",
          "[physics][dynamics][races][implicit]") {
  bearing::Bearing b = angular_contact(9);
  b.gravity = {0.0, 0.0, -9.81};
  b.race_inertia[1] = {0.3, {3e-4, 2e-4, 2e-4}, {0.0, 0.0, 5e-6}};
  ScenePlan plan = full_plan();
  bearing::FreeRace& free = plan.race_motions.free[1].emplace();
  free.force = {1500.0, 0.0, 500.0};
  free.rotation_held = {true, true, true};
  const double t = 5e-4;
  const auto at_end = [&](const char* method, double tolerance) {
    System system = make_system(b, plan);
    return system.snapshot(t, run(system, system.initial_state(), t, tolerance, method).y);
  };
  const Snapshot exact = at_end("rkf7", 1e-10);
  REQUIRE(exact.races[1].velocity.norm() > 1e-5);
  for (const char* method : {"arkode-imex", "arkode-dirk", "cvode-bdf"}) {
    const Snapshot now = at_end(method, 1e-7);
    INFO(method);
    CHECK((now.races[1].position - exact.races[1].position).norm() < 2e-8);
    CHECK((now.races[1].velocity - exact.races[1].velocity).norm() <
          0.02 * exact.races[1].velocity.norm());
    for (std::size_t i = 0; i < 9; ++i)
      CHECK(now.elements[i].theta == Approx(exact.elements[i].theta).margin(1e-5));
    CHECK(std::abs(now.energy.residual()) < 1e-4 * now.energy.sum(LedgerKind::Start));
  }
}
