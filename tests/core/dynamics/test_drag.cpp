#include "base/constants.hpp"
#include "core/dynamics/roller_scene.hpp"
#include "core/dynamics/system_fixture.hpp"
#include "dynamics/effect.hpp"
#include "dynamics/effect_catalogue.hpp"
#include "tribology/bearing_drag.hpp"
#include "tribology/fluid.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;
using tribology::BearingDrag;

namespace {

bearing::Bearing in_medium(double density, double viscosity) {
  bearing::Bearing b = angular_contact();
  b.churning = bearing::Churning{2, density, viscosity, 1.0, 1.0};
  b.cage->clearance_outer = b.cage->clearance_inner = 2e-3;
  return b;
}

ScenePlan drag_plan() {
  ScenePlan plan = full_plan();
  plan.effects.push_back({Effect::ElementDrag, "", true, "test"});
  plan.effects.push_back({Effect::CageDrag, "", true, "test"});
  return plan;
}

}  // namespace

TEST_CASE("drag: sphere without the part behind the cage; none at rest",
          "[physics][tribology][analytic]") {
  bearing::Bearing b = in_medium(800.0, 0.01);
  const BearingDrag with_cage(b);
  b.cage.reset();
  const BearingDrag drag(b);
  const double R = 0.5 * b.balls().diameter;
  // Independent of the table of the program: Brown and Lawler (2003) [recalled, high], C_D of a
  // sphere within 6 % of measurements up to Re = 2e5.
  const auto sphere_force = [&](double V) {
    const double D = 2.0 * R, Re = 800.0 * V * D / 0.01;
    const double C = 24.0 / Re * (1.0 + 0.15 * std::pow(Re, 0.681)) + 0.407 / (1.0 + 8710.0 / Re);
    return C * 0.5 * 800.0 * V * V * 0.25 * kPi * D * D;
  };
  CHECK(drag.exposed_area_fraction() == 1.0);
  for (const double V : {1e-3, 1.0, 40.0}) {
    CHECK(drag.element_force_per_speed(V) * V == Approx(sphere_force(V)).epsilon(0.1));
    CHECK(
        with_cage.element_force_per_speed(V) ==
        Approx(with_cage.exposed_area_fraction() * drag.element_force_per_speed(V)).epsilon(1e-12));
  }
  // The wall of 4.5 mm (95 mm + 5, - 4) covers z = -2 to 2.5 mm of a disc of 6.35 mm.
  const auto below = [R](double z) {
    return std::asin(z / R) + z / R * std::sqrt(1.0 - z * z / R / R);
  };
  CHECK(with_cage.exposed_area_fraction() ==
        Approx(1.0 - (below(0.0025) - below(-0.002)) / kPi).epsilon(1e-12));
  // Power falls to nothing with the speed, and force over speed stays finite.
  CHECK(std::isfinite(drag.element_force_per_speed(0.0)));
  CHECK(drag.element_spin(0.0) == Approx(8.0 * kPi * 0.01 * R * R * R).epsilon(1e-9));
  b.speed = {0.0, 0.0};
  const tribology::DragPower none = tribology::drag_power(drag, b, 0.0, 0.0, 0.0);
  CHECK(none.total() == 0.0);
  // A medium that turns with everything else drags on nothing.
  b.speed = {500.0, 500.0};
  CHECK(tribology::drag_power(drag, b, 500.0, 0.0, 500.0).total() == 0.0);
}

TEST_CASE("drag: every medium of the table; thin gases less than liquids", "[physics][tribology]") {
  bearing::Bearing b = in_medium(1.0, 1.0);
  const double orbit = 0.04 * b.speed[1];
  const auto power = [&](int code, double T) {
    b.churning = bearing::Churning{code, 0.0, 0.0, 1.0, 1.0};
    b.race_temperature = {T, T};
    b.element_temperature = T;
    const BearingDrag drag(b);
    CHECK_FALSE(drag.medium().name.empty());
    CHECK_FALSE(drag.medium().provenance.empty());
    return tribology::drag_power(drag, b, orbit, 2000.0, orbit).total();
  };
  const double oxygen = power(3, 95.0), hydrogen = power(4, 22.0), air = power(13, 320.0),
               water = power(14, 320.0);
  CHECK(air > 0.0);
  CHECK(water > 100.0 * air);
  CHECK(oxygen > 5.0 * hydrogen);  // sixteen times as dense
  for (const int code : tribology::fluid_codes())
    if (code >= 3) CHECK(power(code, 300.0) > 0.0);
  // Half the density: less, by half at most (below the drag crisis, which thins out the wake).
  b.churning = bearing::Churning{14, 0.0, 0.0, 0.5, 1.0};
  const double half = tribology::drag_power(BearingDrag(b), b, orbit, 2000.0, orbit).total();
  const double whole = power(14, b.element_temperature);
  CHECK(half < whole);
  CHECK(half > 0.49 * whole);
}

TEST_CASE("drag: slows balls and cage, with all of its work in the ledger",
          "[physics][dynamics][energy]") {
  const bearing::Bearing b = in_medium(800.0, 0.01);
  const double end = 2e-4;
  System plain = make_system(b, full_plan()), drag = make_system(b, drag_plan());
  CHECK(drag.layout().controlled_size() == plain.layout().controlled_size());
  CHECK(drag.layout().size() == plain.layout().size() + 2);  // two heats
  const auto entries = [](System& system) {
    std::size_t n = 0;
    for (const auto& row : system.cost().rows()) n += row.name == "drag in the medium" ? 1 : 0;
    return n;
  };
  CHECK(entries(plain) == 0);
  CHECK(entries(drag) == 1);

  double previous = 0.0;
  for (const double tolerance : {1e-6, 1e-9}) {
    const RunResult result = run(drag, drag.initial_state(), end, tolerance, "rkf4");
    const Snapshot snapshot = drag.snapshot(end, result.y);
    const double elements = snapshot.energy.rate("element_drag"),
                 cage = snapshot.energy.rate("cage_drag");
    const BearingDrag law(b);
    double expected = 0.0;
    for (const ElementSnapshot& ball : snapshot.elements) {
      const double V = std::hypot(ball.vx, ball.vr, ball.r * ball.theta_dot), w = ball.omega.norm();
      expected += law.element_force_per_speed(V) * V * V + law.element_spin(w) * w * w;
    }
    CHECK(elements == Approx(expected).epsilon(1e-12));
    CHECK(cage > 0.0);
    CHECK(snapshot.power.churning_fraction ==
          Approx((elements + cage) / snapshot.power.total_loss).epsilon(1e-12));
    const double heat = snapshot.energy.value("element_drag") + snapshot.energy.value("cage_drag");
    CHECK(heat > 0.0);
    const double residual = std::abs(snapshot.energy.residual());
    if (previous > 0.0) {
      CHECK(residual < previous);
      CHECK(residual < 0.01 * heat);
    }
    previous = residual;
  }
  const RunResult free = run(plain, plain.initial_state(), end, 1e-7, "rkf4");
  const RunResult slowed = run(drag, drag.initial_state(), end, 1e-7, "rkf4");
  CHECK(drag.snapshot(end, slowed.y).elements[0].theta_dot <
        plain.snapshot(end, free.y).elements[0].theta_dot);
  CHECK(plain.snapshot(end, free.y).power.churning_fraction == 0.0);
}

TEST_CASE("drag: momentum leaves through the outer race", "[physics][dynamics][energy]") {
  const bearing::Bearing b = in_medium(800.0, 0.01);
  ScenePlan plan = drag_plan();
  plan.effects.push_back({Effect::MomentumLedger, "", true, "test"});
  System system = make_system(b, plan);
  const double end = 2e-4;
  const RunResult result = run(system, system.initial_state(), end, 1e-8, "rkf4");
  const Snapshot snapshot = system.snapshot(end, result.y);
  REQUIRE(snapshot.momentum);
  CHECK(snapshot.momentum->angular.residual().norm() < 1e-6 * snapshot.momentum->angular_size);
  CHECK(snapshot.momentum->linear.residual().norm() < 1e-6 * snapshot.momentum->linear_size);
}
