#include "roller_scene.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

/// kDOF 1 to 5 of rollers (reading N9): what is suppressed keeps its velocity, all else moves.
using namespace adore;
using namespace adore::dynamics;
using roller_scene::Scene;
using scene::LedgerKind;
using scene::ScenePlan;
using scene::Snapshot;

namespace {

ScenePlan plan_of(int code) {
  ScenePlan plan = roller_scene::with_friction();
  plan.effects.push_back({scene::Effect::Gravity, "", true, "test"});
  plan.suppressed = {code >= 1 && code <= 4, code == 2 || code == 4, code == 5,
                     code == 1 || code == 2, code == 2};
  return plan;
}

std::vector<bearing::Bearing> all_types(double rpm) {
  return {roller_bearings::cylindrical(rpm), roller_bearings::tapered(rpm),
          roller_bearings::spherical(rpm), roller_bearings::spherical_tapered(rpm)};
}

/// Speed of the orbit of cones and cylinders that roll on both races [rad/s]: the speeds of both
/// raceways' meridians are those of the axis' ends, ω r_i/(r_i + r_o) where the roller is largest.
double epicyclic(const bearing::Bearing& b) {
  const bearing::RollerGeometry& g = *b.rollers();
  if (g.race_angle[0] == g.race_angle[1])
    return 0.5 * b.speed[1] * (1.0 - g.diameter * std::cos(g.axis_angle) / g.pitch_diameter);
  const double inner = std::sin(g.race_angle[1]), outer = std::sin(g.race_angle[0]);
  return b.speed[1] * inner / (inner + outer);
}

/// Axial speed of the cage's geometric center, which is held; that of a conical cage is beside its
/// mass center, whose motion is reported.
double axial_speed(const bearing::Bearing& b, const scene::CageSnapshot& cage) {
  const Vec3 arm = rotation_matrix(cage.orientation) * b.cage->inertia.geometric_centre;
  return (cage.velocity + cage.omega.cross(arm)).x();
}

}  // namespace

TEST_CASE("rollers: suppressed motions keep their velocities, all others change",
          "[physics][rollers][constrained][dof]") {
  const double t = 5e-4;
  for (bearing::Bearing b : all_types(3000.0)) {
    b.gravity = {3.0, 0.0, -9.81};
    b.constraints.displacement[3] = 2e-4;  // what skews rollers
    roller_scene::add_cage(b);
    roller_scene::add_friction(b);
    b.cage->start_offset = {1.0e-5, 8.0e-5, -9.0e-5};
    b.cage->start_angles = {0.0, 5e-4, -3e-4};
    for (int code = 0; code <= 5; ++code) {
      Scene s = roller_scene::scene_of(b, plan_of(code), 9);
      const std::vector<double> y0 = s.system.initial_state();
      const Snapshot start = s.system.snapshot(0.0, y0);
      const Snapshot now = s.system.snapshot(t, fixture::run(s.system, y0, t, 1e-8, "rkf5").y);
      INFO("type " << static_cast<int>(b.type) << ", kDOF " << code << ", residual "
                   << now.energy.residual());
      CHECK(std::abs(now.energy.residual()) < 1e-6 * now.energy.sum(LedgerKind::Start));
      CHECK(now.momentum->linear.residual().norm() < 1e-5 * now.momentum->linear_size);
      CHECK(now.momentum->angular.residual().norm() < 1e-5 * now.momentum->angular_size);
      // Of every roller: what is kept; of any: what moves.
      bool still = true, upright = true, whole = true;
      int pushed = 0, tilting = 0, spinning = 0, orbiting = 0;
      for (std::size_t i = 0; i < now.elements.size(); ++i) {
        const scene::ElementSnapshot &before = start.elements[i], &after = now.elements[i];
        still = still && after.vx == before.vx;
        upright = upright && after.omega.tail<2>() == before.omega.tail<2>();
        whole = whole && after.vr == before.vr && after.theta_dot == before.theta_dot &&
                after.omega == before.omega;
        pushed += after.vx != before.vx;
        tilting += after.omega[1] != before.omega[1] && after.omega[2] != before.omega[2];
        spinning += after.omega[0] != before.omega[0];
        orbiting += after.theta_dot != before.theta_dot && after.vr != before.vr;
      }
      const int n = b.element_count();
      CHECK(still == (code >= 1));
      CHECK(upright == (code == 2 || code >= 4));
      CHECK(whole == (code == 5));
      CHECK(pushed == (code == 0 ? n : 0));
      CHECK(tilting == (code == 0 || code == 1 || code == 3 ? n : 0));
      CHECK(spinning == (code < 5 ? n : 0));
      CHECK(orbiting == (code < 5 ? n : 0));
      const scene::CageSnapshot &before = start.cages[0], &after = now.cages[0];
      const double pushed_cage = std::abs(axial_speed(b, after) - axial_speed(b, before));
      CAPTURE(pushed_cage);
      // Gravity gives it 1.5 mm/s; a conical cage is held to the error of the steps.
      CHECK((pushed_cage < 5e-5) == (code == 1 || code == 2));
      CHECK(after.velocity.z() != before.velocity.z());
      CHECK(after.omega.x() != before.omega.x());
      const Vec3 change =
          rotation_matrix(before.orientation).transpose() * (after.omega - before.omega);
      CHECK((change.tail<2>().norm() < 1e-9 * after.omega.norm()) == (code == 2));
    }
  }
}

namespace {

/// Mean orbit of the rollers and turn of the cage over the epicyclic speed, less 1.
struct Excess {
  double orbit = 0.0, cage = 0.0;
};
Excess excess_of(const bearing::Bearing& b, int code, double t) {
  Scene s = roller_scene::scene_of(b, plan_of(code), 9);
  const Snapshot at =
      s.system.snapshot(t, fixture::run(s.system, s.system.initial_state(), t, 1e-7).y);
  const double speed = epicyclic(b);
  double mean = 0.0;
  for (const scene::ElementSnapshot& e : at.elements) mean += e.theta_dot / b.element_count();
  return {mean / speed - 1.0, at.cages[0].omega.x() / speed - 1.0};
}

bool is_cone(const bearing::Bearing& b) {
  return b.type == bearing::Type::Tapered || b.type == bearing::Type::SphericalTapered;
}

/// Lightly loaded, with cage and friction.
bearing::Bearing light(bearing::Bearing b) {
  b.constraints.load.fill(0.0);
  if (is_cone(b))
    b.constraints.load[0] = 60.0;  // beside what the rollers' centrifugal force takes
  else
    b.rollers()->clearance = -2e-6;
  roller_scene::add_cage(b);
  roller_scene::add_friction(b);
  return b;
}

}  // namespace

// Cones whose tips meet in the bearing axis roll without slip all along; barrels of cones touch
// beside that, by some 1e-4 of the radius.
TEST_CASE("rollers: with a light load and kDOF 0 to 4 cage and rollers turn at the epicyclic speed",
          "[physics][rollers][constrained][dof]") {
  for (const bearing::Bearing& of_type : all_types(3000.0)) {
    bearing::Bearing b = light(of_type);
    if (is_cone(b)) b.flange_traction = bearing::TractionCurve{};  // of the rib: below
    for (int code = 0; code <= 4; ++code) {
      INFO("type " << static_cast<int>(b.type) << ", kDOF " << code);
      const Excess of = excess_of(b, code, 3e-3);
      const double most = b.type == bearing::Type::Tapered            ? 1e-5
                          : b.type == bearing::Type::SphericalTapered ? 5e-4
                                                                      : 5e-3;
      CHECK(std::abs(of.orbit) < most);
      CHECK(std::abs(of.cage) < most);
    }
  }
}

// The rib of the inner race rubs the ends of cones forward, and the races hold them back by the
// slip u that their traction κ = B u needs. Both go with the load, so that no load is light enough
// to end it: what is in excess of the epicyclic speed goes with κ_rib/B over the speed.
TEST_CASE("rollers: cones orbit faster than epicyclic by what the rib drags them, at any load",
          "[physics][rollers][dof]") {
  const auto excess = [](double rib, double slope, double faster) {
    bearing::Bearing b = light(roller_bearings::tapered(3000.0 * faster));
    b.constraints.load[0] *= faster * faster;  // as centrifugal forces
    b.flange_traction = {bearing::TractionCurve::Form::Exponential, -rib, 0.0, 2.0, rib, 0.0};
    b.race_traction.B = slope;
    return excess_of(b, 0, 4e-3).orbit;
  };
  const double one = excess(0.05, 1.0, 1.0), half_rib = excess(0.025, 1.0, 1.0),
               twice_slope = excess(0.05, 2.0, 1.0), twice_speed = excess(0.05, 1.0, 2.0);
  INFO(one << ", half the friction of the rib " << half_rib << ", twice the slope " << twice_slope
           << ", twice the speed and four times the load " << twice_speed);
  CHECK(one > 3e-4);
  CHECK(one < 2e-3);
  CHECK(half_rib == Approx(0.5 * one).epsilon(0.2));
  CHECK(twice_slope == Approx(0.5 * one).epsilon(0.2));
  CHECK(twice_speed == Approx(0.5 * one).epsilon(0.2));
}
