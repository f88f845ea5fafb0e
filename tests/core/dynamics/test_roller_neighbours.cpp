#include "contact/line_contact.hpp"
#include "contact/roller_pair.hpp"
#include "core/dynamics/roller_scene.hpp"
#include "scene/ledger.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

/// Rollers that touch each other in a bearing without cage.
using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

using enum scene::Effect;

/// As many rollers as fit with some 0.1 mm of play from one to the next.
bearing::Bearing crowded(bearing::Bearing b) {
  const double D = b.element_diameter();
  bearing::RollerGeometry& rollers = *b.rollers();
  rollers.count =
      static_cast<int>(std::numbers::pi / std::asin((D + 1e-4) / rollers.pitch_diameter));
  b.element_traction =
      bearing::TractionCurve{bearing::TractionCurve::Form::Exponential, -0.05, 0.0, 2.0, 0.05, 0.0};
  return b;
}

std::size_t place(const System& system, const std::string& group) {
  for (const auto& one : system.layout().groups())
    if (one.name == group) return static_cast<std::size_t>(one.slice.first);
  FAIL("no " << group);
  return 0;
}

/// Every second roller next to the one before it, and all at speeds of their own.
std::vector<double> colliding(const System& system) {
  std::vector<double> y = system.initial_state();
  const double D = system.bearing().element_diameter();
  const std::size_t n = static_cast<std::size_t>(system.bearing().element_count());
  for (std::size_t i = 1; i < n; i += 2) {
    const double r = y[place(system, "element.r") + i];
    double& theta = y[place(system, "element.theta") + i];
    const double shift =
        y[place(system, "element.theta") + i - 1] + 2.0 * std::asin((D + 2e-5) / (2.0 * r)) - theta;
    theta += shift;
    const std::size_t q = place(system, "element" + std::to_string(i + 1) + ".quaternion");
    const Quat turned =
        multiply(quaternion_about(Vec3::UnitX(), shift), Quat{y[q], y[q + 1], y[q + 2], y[q + 3]});
    for (std::size_t k = 0; k < 4; ++k) y[q + k] = turned[k];
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double own = std::sin(1.0 + 2.3 * static_cast<double>(i));
    y[place(system, "element.theta_dot") + i] += i % 2 == 0 ? 8.0 : -8.0;
    y[place(system, "element.omega_r") + i] += 3.0 * own;
    y[place(system, "element.x_dot") + i] += 0.01 * own;
  }
  return y;
}

}  // namespace

TEST_CASE("a slice of one roller against another pushes along the gradient of its energy",
          "[unit][rollers][jacobian]") {
  contact::RollerProfile profile;
  profile.diameter = 0.01;
  profile.length = 0.012;
  profile.crown_radius = 0.8;
  profile.central_length = 0.004;
  profile.half_angle = 0.03;
  const contact::RollerSide side{profile, -0.0055, 0.0055};
  constexpr double kStiffness = 1e9, kHalf = 4e-4, kRadius = 5e-3;
  const Vec3 a = Vec3(1.0, 0.02, -0.03).normalized(), C(1e-4, -2e-4, 3e-4);
  const auto energy = [&](const Vec3& p) {
    const contact::RollerPairSlice c = contact::roller_pair_slice(p, kRadius, kHalf, side, C, a);
    return c.overlap > 0.0 ? 0.5 * kStiffness * c.fraction * c.overlap * c.overlap : 0.0;
  };
  int partly = 0;
  for (const double x : {-5.3e-3, -1e-3, 3e-3, 5.2e-3}) {
    const Vec3 p(x, 9.78e-3 - 0.01 * x, 4e-4);
    const contact::RollerPairSlice c = contact::roller_pair_slice(p, kRadius, kHalf, side, C, a);
    REQUIRE(c.overlap > 1e-6);
    partly += c.fraction < 1.0 ? 1 : 0;
    const double q = kStiffness * c.overlap, e = 0.5 * q * c.overlap;
    const Vec3 force = -c.fraction * q * (c.m + c.other_slope * a) - e * c.fraction_slope * a;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 h = 1e-9 * Vec3::Unit(axis);
      const double slope = (energy(p + h) - energy(p - h)) / 2e-9;
      INFO("x = " << x << ", axis " << axis);
      CHECK(force[axis] == Approx(-slope).margin(1e-5 * force.norm()));
    }
    // No moment about the axis of the other roller.
    CHECK(std::abs((p - C).cross(force).dot(a)) < 1e-12 * force.norm());
  }
  CHECK(partly >= 2);
}

TEST_CASE("two rollers side by side press on each other by the line law over their whole length",
          "[physics][rollers]") {
  bearing::Bearing b = crowded(roller_bearings::cylindrical(3000.0));
  b.rollers()->crown_radius = 1e10;
  roller_scene::Scene s =
      roller_scene::scene_of(b, roller_scene::plan_of({RaceContact, ElementContact}), 15);
  std::vector<double> y = s.system.initial_state();
  double r = 0.0;
  std::size_t theta = 0;
  for (const auto& group : s.system.layout().groups()) {
    if (group.name == "element.theta") theta = static_cast<std::size_t>(group.slice.first);
    if (group.name == "element.r") {
      r = y[static_cast<std::size_t>(group.slice.first)];
      y[static_cast<std::size_t>(group.slice.first) + 1] = r;
    }
  }
  constexpr double kOverlap = 1e-6;
  const double D = b.element_diameter();
  y[theta + 1] = y[theta] + 2.0 * std::asin((D - kOverlap) / (2.0 * r));
  const auto element = s.system.snapshot(0.0, y).elements[0];
  REQUIRE(element.to_next.has_value());
  CHECK(element.to_next->gap == Approx(-kOverlap).epsilon(1e-3));
  const double E_star = 2.06e11 / (2.0 * (1.0 - 0.09));
  const double L = b.rollers()->contact_length();
  const double load = contact::line_constant(E_star) * std::pow(b.rollers()->length, -1.0 / 9.0) *
                      L * std::pow(kOverlap, 10.0 / 9.0);
  CHECK(element.to_next->force == Approx(load).epsilon(2e-3));
}

TEST_CASE(
    "damping of rollers side by side: slice that barely reaches the other roller → the axial force "
    "of its edge stays elastic",
    "[unit][rollers][damping]") {
  constexpr int kSlices = 15;
  constexpr double kOverlap = 2e-6, kSpeed = 1.0;
  bearing::Bearing b = crowded(roller_bearings::cylindrical(3000.0));
  b.rollers()->crown_radius = 1e10;
  scene::ScenePlan plan = roller_scene::plan_of({RaceContact, ElementContact, ContactDamping});
  SystemOptions options;
  options.damping = {0.3, true};
  roller_scene::Scene s = roller_scene::scene_of(b, plan, kSlices, 0.0, options);
  std::vector<double> y = s.system.initial_state();
  const std::size_t r = place(s.system, "element.r"), theta = place(s.system, "element.theta"),
                    x = place(s.system, "element.x"), x_dot = place(s.system, "element.x_dot");
  y[r + 1] = y[r];
  y[theta + 1] = y[theta] + 2.0 * std::asin((b.element_diameter() - kOverlap) / (2.0 * y[r]));
  const double width = b.rollers()->contact_length() / kSlices, home = y[x + 1];
  std::vector<double> dydt(y.size());
  const auto axial = [&](double fraction, double speed) {
    y[x + 1] = home + (1.0 - fraction) * width;
    y[x_dot + 1] = speed;
    REQUIRE(s.system.rhs(0.0, y.data(), dydt.data()) == RhsStatus::Ok);
    return dydt[x_dot + 1];
  };
  // Along the axes two cylinders do not approach each other.
  const double still = axial(0.5, 0.0);
  CHECK(still > 0.0);
  for (const double fraction : {0.5, 1e-3, 1e-6}) {
    CAPTURE(fraction);
    CHECK(axial(fraction, -kSpeed) == Approx(axial(fraction, 0.0)).epsilon(1e-6));
    CHECK(axial(fraction, -kSpeed) == Approx(still).epsilon(0.01));
  }
}

TEST_CASE("rollers without cage conserve energy and momentum through their collisions",
          "[physics][rollers][energy]") {
  for (const bearing::Bearing& b :
       {crowded(roller_bearings::cylindrical(3000.0)), crowded(roller_bearings::tapered(3000.0)),
        crowded(roller_bearings::spherical(3000.0))})
    for (const bool friction : {false, true}) {
      scene::ScenePlan plan =
          friction
              ? roller_scene::plan_of({RaceContact, RaceTraction, FlangeContact, FlangeTraction,
                                       ElementContact, ElementTraction, Effect::MomentumLedger})
              : roller_scene::plan_of(
                    {RaceContact, FlangeContact, ElementContact, Effect::MomentumLedger});
      bearing::Bearing with = b;
      roller_scene::add_friction(with);
      with.pocket_traction.reset();
      with.land_traction.reset();
      double previous = 1e300;
      for (const double tolerance : {1e-6, 1e-9}) {
        roller_scene::Scene s = roller_scene::scene_of(with, plan, 7);
        const double end = 5e-4;
        // Order 4: pairs of higher order see little of an impact that begins inside a step.
        const RunResult result =
            fixture::run(s.system, colliding(s.system), end, tolerance, "rkf4");
        const Snapshot at = s.system.snapshot(end, result.y);
        const double residual = std::abs(at.energy.residual());
        double touched = 0.0;
        for (const scene::ElementSnapshot& e : at.elements) touched += e.to_next->force;
        INFO("type " << static_cast<int>(with.type) << ", friction " << friction << ", tolerance "
                     << tolerance << ": residual " << residual << " J, touching now " << touched
                     << " N");
        if (friction) CHECK(at.energy.value("element_heat") > 1e-6);
        CHECK(residual < std::max(0.5 * previous, 1e-9));
        if (tolerance == 1e-9) {
          CHECK(residual < 1e-5 * at.energy.sum(scene::LedgerKind::Start));
          CHECK(at.momentum->linear.residual().norm() < 1e-5 * at.momentum->linear_size);
          CHECK(at.momentum->angular.residual().norm() < 1e-5 * at.momentum->angular_size);
        }
        previous = residual;
      }
    }
}

TEST_CASE("held rollers without cage close the ledgers through their collisions",
          "[physics][rollers][held][energy]") {
  for (const bearing::Bearing& b :
       {crowded(roller_bearings::cylindrical(3000.0)), crowded(roller_bearings::tapered(3000.0)),
        crowded(roller_bearings::spherical(3000.0)),
        crowded(roller_bearings::spherical_tapered(3000.0))})
    for (const bool all : {true, false}) {
      scene::ScenePlan plan =
          roller_scene::plan_of({RaceContact, RaceTraction, FlangeContact, FlangeTraction,
                                 ElementContact, ElementTraction, Effect::MomentumLedger});
      plan.effects.push_back(
          {all ? Effect::ElementBalance : Effect::LightLoadBalance, "", true, "test"});
      plan.light_load_ratio = all ? 0.0 : 0.1;
      bearing::Bearing with = b;
      roller_scene::add_friction(with);
      with.pocket_traction.reset();
      with.land_traction.reset();
      double previous = 1e300;
      for (const double tolerance : {1e-6, 1e-9}) {
        roller_scene::Scene s = roller_scene::scene_of(with, plan, 7);
        std::vector<double> y = colliding(s.system);
        s.system.set_start(0.0, y);
        (void)s.system.between_steps(0.0, y);
        Adapter adapter(s.system);
        const auto stepper = integrators::make_stepper("rkf4");
        integrators::StepControl control;
        const double end = 3e-4;
        control.maximum = end;
        control.minimum = 1e-13;
        control.tolerance = tolerance;
        stepper->start(adapter, 0.0, y, control);
        while (stepper->time() < end) stepper->step(end);
        const Snapshot at = s.system.snapshot(end, stepper->state());
        const double residual = std::abs(at.energy.residual());
        INFO("type " << static_cast<int>(with.type) << ", all held " << all << ", tolerance "
                     << tolerance << ": residual " << residual << " J, "
                     << at.held_elements.value_or(0) << " held");
        CHECK(at.held_elements.value_or(0) > 0);
        CHECK(at.energy.value("element_heat") > 1e-6);
        CHECK(residual < std::max(0.5 * previous, 1e-9));
        if (tolerance == 1e-9) {
          CHECK(residual < 1e-5 * at.energy.sum(scene::LedgerKind::Start));
          CHECK(at.momentum->linear.residual().norm() < 1e-5 * at.momentum->linear_size);
          CHECK(at.momentum->angular.residual().norm() < 1e-5 * at.momentum->angular_size);
        }
        previous = residual;
      }
    }
}
