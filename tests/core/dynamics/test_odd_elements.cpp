#include "core/dynamics/system_fixture.hpp"
#include "dynamics/element_masses.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

/// Balls of unequal diameter, of an inertia of their own or off center, where motions are
/// suppressed (kDOF) or stand in balance (modes 1 and 2, qFac).
using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

scene::ScenePlan mode_plan(int mode, scene::ScenePlan plan = full_plan()) {
  plan.effects.push_back({Effect::MomentumLedger, "", true, "test"});
  if (mode >= 1) plan.effects.push_back({Effect::ElementBalance, "", true, "test"});
  if (mode == 2) plan.effects.push_back({Effect::RaceBalance, "", true, "test"});
  return plan;
}

/// kDOF of elements.
void suppress(scene::ScenePlan& plan, int kdof) {
  plan.suppressed.element_axial = kdof >= 1 && kdof <= 4;
  plan.suppressed.element_tilt = kdof == 2 || kdof == 4;
  plan.suppressed.element_all = kdof == 5;
}

Snapshot run_of(System& system, double end, double tolerance) {
  std::vector<double> y = system.initial_state();
  system.set_start(0.0, y);
  system.between_steps(0.0, y);
  Adapter adapter(system);
  const auto stepper = integrators::make_stepper("rkf5");
  integrators::StepControl control;
  control.maximum = end;
  control.minimum = 1e-13;
  control.tolerance = tolerance;
  stepper->start(adapter, 0.0, y, control);
  while (stepper->time() < end) stepper->step(end);
  return system.snapshot(end, stepper->state());
}

bearing::Bearing nine_balls() {
  bearing::Bearing b = angular_contact(9, 0.07);
  b.gravity = {0.5, 0.0, -9.81};
  b.cage->start_offset = {1e-5, 6e-5, -8e-5};
  return b;
}

bearing::Inertia odd_inertia(const bearing::Bearing& b) {
  bearing::Inertia odd = b.element_inertia;
  odd.mass *= 1.2;
  odd.moments = {1.1 * odd.moments[0], 0.9 * odd.moments[0], 1.05 * odd.moments[0]};
  odd.geometric_centre = {2e-5, -4e-5, 3e-5};
  odd.frame = {0.2, -0.3, 0.4};
  return odd;
}

/// Energy and momenta close, the better the finer the tolerance.
template <class Make>
void check_ledgers(const Make& make, double end) {
  double previous = 1e300;
  for (const double tolerance : {1e-5, 1e-9}) {
    System system = make();
    const Snapshot at = run_of(system, end, tolerance);
    const double residual =
        std::abs(at.energy.residual()) / at.energy.sum(scene::LedgerKind::Start);
    INFO("tolerance " << tolerance << ": " << residual);
    CHECK(residual < std::max(0.5 * previous, 2e-9));  // some runs without blows begin there
    if (tolerance == 1e-9) {
      CHECK(residual < 1e-7);
      REQUIRE(at.momentum.has_value());
      CHECK(at.momentum->linear.residual().norm() < 1e-7 * at.momentum->linear_size);
      CHECK(at.momentum->angular.residual().norm() < 1e-7 * at.momentum->angular_size);
    }
    previous = residual;
  }
}

}  // namespace

TEST_CASE("off-centre balls with suppressed motions: energy and momentum close",
          "[physics][dynamics][rigid][energy]") {
  for (const int kdof : {1, 2, 5}) {
    bearing::Bearing b = nine_balls();
    b.element_inertia = odd_inertia(b);
    scene::ScenePlan plan = mode_plan(0);
    plan.rigid_balls = true;
    suppress(plan, kdof);
    INFO("kDOF " << kdof);
    check_ledgers([&] { return make_system(b, plan); }, 1e-3);
  }
}

TEST_CASE("off-centre balls with suppressed motions keep what is suppressed, and nothing else",
          "[physics][dynamics][rigid]") {
  bearing::Bearing b = nine_balls();
  b.element_inertia = odd_inertia(b);
  for (const int kdof : {1, 2}) {
    scene::ScenePlan plan = mode_plan(0);
    plan.rigid_balls = true;
    suppress(plan, kdof);
    System system = make_system(b, plan);
    std::vector<double> y = system.initial_state();
    const Snapshot start = system.snapshot(0.0, y);
    const Snapshot end = run_of(system, 3e-4, 1e-9);
    double turned = 0.0;
    for (std::size_t i = 0; i < 9; ++i) {
      CHECK(end.elements[i].x == Approx(start.elements[i].x).margin(1e-16));
      CHECK(end.elements[i].ax == 0.0);
      const auto change = end.elements[i].omega - start.elements[i].omega;
      turned = std::max(turned, change.norm());
      if (kdof == 2)
        CHECK(std::hypot(change[1], change[2]) < 1e-9 * start.elements[i].omega.norm());
      CHECK(std::abs(end.elements[i].r - start.elements[i].r) > 1e-12);
    }
    CHECK(turned > 1e-3);
  }
}

TEST_CASE("a guide at the center of an off-centre ball feels what accelerates its mass",
          "[unit][dynamics][rigid]") {
  // A ball that only spins about x, its mass center off that axis: held in all six motions it is
  // turned by m c × g, and its center is held against m ω² c and its weight.
  bearing::Bearing b = angular_contact(9, 0.07);
  b.cage.reset();
  b.gravity = {-9.81, 0.0, 0.0};
  b.element_inertia.geometric_centre = {0.0, 0.0, 1e-4};
  scene::ScenePlan plan = plan_with({Effect::Gravity, Effect::MomentumLedger});
  plan.rigid_balls = true;
  suppress(plan, 1);
  System system = make_system(b, plan);
  std::vector<double> y = system.initial_state();
  for (const auto& group : system.layout().groups())
    for (int i = 0; i < group.slice.count; ++i) {
      double& value = y[static_cast<std::size_t>(group.slice.first + i)];
      if (group.name == "element.theta_dot" || group.name.starts_with("element.omega")) value = 0.0;
    }
  std::vector<double> f(y.size());
  REQUIRE(system.rhs(0.0, y.data(), f.data()) == RhsStatus::Ok);
  // Gravity along -x at the mass center, 0.1 mm below the center: the guide at the center takes the
  // weight, the ball swings like a pendulum about it, ω̇ = m g c/(I + m c²).
  const double m = b.element_inertia.mass, I = b.element_inertia.moments[0], c = 1e-4;
  const double rate = m * 9.81 * c / (I + m * c * c);
  for (const auto& group : system.layout().groups()) {
    if (group.name != "element.omega_theta" && group.name != "element.x_dot") continue;
    for (int i = 0; i < group.slice.count; ++i) {
      const double value = f[static_cast<std::size_t>(group.slice.first + i)];
      if (group.name == "element.x_dot")
        CHECK(value == 0.0);
      else
        CHECK(std::abs(value) == Approx(rate).epsilon(1e-9));
    }
  }
}

TEST_CASE("odd balls in balance: energy and momentum close in modes 1 and 2",
          "[physics][dynamics][constrained][energy]") {
  enum class Odd { Diameters, First, OffCentre, OffCentreGuided };
  for (const Odd odd : {Odd::Diameters, Odd::First, Odd::OffCentre, Odd::OffCentreGuided})
    for (const int mode : {1, 2}) {
      bearing::Bearing b = nine_balls();
      scene::ScenePlan plan = mode_plan(mode);
      if (odd == Odd::Diameters) {
        for (int i = 0; i < 9; ++i)
          b.imperfections.ball_diameter.push_back(5e-6 * std::sin(1.0 + 2.3 * i));
      } else {
        (odd == Odd::First ? b.first_inertia.emplace() : b.element_inertia) = odd_inertia(b);
        plan.rigid_balls = true;
      }
      if (odd == Odd::OffCentreGuided) suppress(plan, 4);
      INFO("case " << static_cast<int>(odd) << ", mode " << mode);
      check_ledgers([&] { return make_system(b, plan); }, 5e-4);
    }
}

TEST_CASE("odd balls in balance carry their own centrifugal force and their unbalance",
          "[physics][dynamics][constrained]") {
  for (const bool has_eccentric_mass : {false, true})
    for (const bool unequal : {false, true}) {
      bearing::Bearing b = angular_contact(9, 0.07);
      b.cage.reset();
      bearing::Inertia heavy = b.element_inertia;
      heavy.mass *= 2.0;
      if (has_eccentric_mass) heavy.geometric_centre = {0.0, 0.0, 3e-4};
      b.first_inertia = heavy;
      if (unequal) b.imperfections.ball_diameter = {0, 3e-6, 0, 0, -4e-6, 0, 0, 0, 1e-6};
      scene::ScenePlan plan = mode_plan(1, plan_with({Effect::RaceContact}));
      plan.rigid_balls = true;
      System system = make_system(b, plan);
      const Snapshot s = run_of(system, 5e-4, 1e-9);
      const ElementMasses masses(b);
      for (std::size_t i = 0; i < 9; ++i) {
        const auto& ball = s.elements[i];
        const double m = masses[i].mass;
        double outward = 0.0;
        for (std::size_t j = 0; j < 2; ++j)
          outward += (j == 0 ? 1.0 : -1.0) * ball.race[j].load * std::cos(ball.race[j].angle);
        const double centrifugal = m * ball.r * ball.theta_dot * ball.theta_dot;
        const double unbalance =
            m * (i == 0 && has_eccentric_mass ? 3e-4 : 0.0) * ball.omega.squaredNorm();
        INFO("ball " << i << ": races take " << outward << " N of " << centrifugal << " N");
        if (unbalance > 0.0) {
          CHECK(unbalance > 0.05 * centrifugal);
          CHECK(std::abs(outward - centrifugal) < 1.02 * unbalance);
          CHECK(std::abs(outward - centrifugal) > 0.02 * unbalance);
        } else {
          CHECK(outward == Approx(centrifugal).epsilon(2e-3));
        }
      }
    }
}

TEST_CASE("equal deviations and inertia of an ideal ball change nothing of the balance",
          "[physics][dynamics][constrained]") {
  bearing::Bearing b = nine_balls(), same = nine_balls();
  same.first_inertia = same.element_inertia;
  scene::ScenePlan plan = mode_plan(2), rigid = plan;
  rigid.rigid_balls = true;
  System spheres = make_system(b, plan), bodies = make_system(same, rigid);
  const Snapshot one = run_of(spheres, 3e-4, 1e-9), other = run_of(bodies, 3e-4, 1e-9);
  for (std::size_t i = 0; i < 9; ++i) {
    CHECK(other.elements[i].x == Approx(one.elements[i].x).margin(1e-11));
    CHECK(other.elements[i].r == Approx(one.elements[i].r).margin(1e-11));
    CHECK(other.elements[i].race[0].load == Approx(one.elements[i].race[0].load).epsilon(1e-6));
  }
}
