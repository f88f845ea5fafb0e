#include "core/dynamics/system_fixture.hpp"
#include "scene/ledger.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

using enum scene::Effect;

/// A full ring: 0.1 mm of play from ball to ball on the pitch circle.
bearing::Bearing crowded(int balls = 12) {
  const double pitch = (0.0127 + 1e-4) / std::sin(std::numbers::pi / balls);
  bearing::Bearing b = angular_contact(3, pitch);  // a cage has no room here
  b.cage.reset();
  b.balls().count = balls;
  b.constraints.load = {1500.0, 0.0, 0.0, 0.0, 0.0};  // all alike
  b.element_traction =
      bearing::TractionCurve{bearing::TractionCurve::Form::Exponential, -0.05, 0.0, 2.0, 0.05, 0.0};
  return b;
}

scene::ScenePlan ring_plan(bool friction) {
  return friction ? plan_with({RaceContact, RaceTraction, ElementContact, ElementTraction,
                               Effect::MomentumLedger})
                  : plan_with({RaceContact, ElementContact, Effect::MomentumLedger});
}

std::size_t place(const System& system, const std::string& group, std::size_t i) {
  for (const auto& one : system.layout().groups())
    if (one.name == group) return static_cast<std::size_t>(one.slice.first) + i;
  FAIL("no " << group);
  return 0;
}

/// Every ball at its own orbital speed: collisions all around.
std::vector<double> colliding(const System& system) {
  std::vector<double> y = system.initial_state();
  const std::size_t n = static_cast<std::size_t>(system.bearing().element_count());
  for (std::size_t i = 0; i < n; ++i)
    y[place(system, "element.theta_dot", i)] += 20.0 * std::sin(1.0 + 2.3 * static_cast<double>(i));
  return y;
}

}  // namespace

TEST_CASE("two balls: contact by Hertz", "[physics][dynamics]") {
  const bearing::Bearing b = crowded(2 + 8);
  System system = make_system(b, ring_plan(false));
  const std::vector<double> start = system.initial_state();
  const double pitch = 2.0 * start[place(system, "element.r", 0)];
  for (const double overlap : {1e-7, 1e-6, 1e-5}) {
    std::vector<double> y = start;
    // Ball 2 towards ball 1 until they overlap.
    const double half = std::asin((b.balls().diameter - overlap) / pitch);
    y[place(system, "element.theta", 1)] = y[place(system, "element.theta", 0)] + 2.0 * half;
    const auto ball = system.snapshot(0.0, y).elements[0];
    REQUIRE(ball.to_next.has_value());
    const double E_star = 2.06e11 / (2.0 * (1.0 - 0.09));
    const double hertz =
        4.0 / 3.0 * E_star * std::sqrt(b.balls().diameter / 4.0) * std::pow(overlap, 1.5);
    CHECK(ball.to_next->gap == Approx(-overlap).epsilon(1e-5));
    CHECK(ball.to_next->force == Approx(hertz).epsilon(2e-5));
    // Equal and opposite along the line of centers.
    std::vector<double> with(y.size()), without(y.size());
    REQUIRE(system.rhs(0.0, y.data(), with.data()) == RhsStatus::Ok);
    System apart = make_system(b, plan_with({RaceContact, Effect::MomentumLedger}));
    REQUIRE(apart.rhs(0.0, y.data(), without.data()) == RhsStatus::Ok);
    const double m = b.element_inertia.mass, r = 0.5 * pitch;
    const auto pushed = [&](std::size_t i) {
      const std::size_t at = place(system, "element.theta_dot", i);
      return m * r * (with[at] - without[at]);
    };
    CHECK(pushed(0) == Approx(-hertz * std::cos(half)).epsilon(1e-4));
    CHECK(pushed(1) == Approx(hertz * std::cos(half)).epsilon(1e-4));
  }
}

TEST_CASE("bearing without cage: energy and momentum conserved through collisions",
          "[physics][dynamics][energy]") {
  for (const bool friction : {false, true}) {
    double previous = 1e300;
    for (const double tolerance : {1e-6, 1e-9}) {
      System system = make_system(crowded(), ring_plan(friction));
      const std::vector<double> y0 = colliding(system);
      const double end = 1.5e-3;
      const RunResult result = fixture::run(system, y0, end, tolerance);
      const auto snapshot = system.snapshot(end, result.y);
      const double residual =
          std::abs(snapshot.energy.residual()) / snapshot.energy.sum(scene::LedgerKind::Start);
      const double heat = snapshot.energy.value("element_heat");
      INFO("friction " << friction << ", tolerance " << tolerance << ": residual " << residual
                       << ", heat between balls " << heat << " J");
      CHECK((heat > 1e-6) == friction);
      CHECK(residual < 0.5 * previous);
      REQUIRE(snapshot.momentum.has_value());
      if (tolerance == 1e-9) {
        CHECK(residual < 1e-6);
        CHECK(snapshot.momentum->linear.residual().norm() < 1e-6 * snapshot.momentum->linear_size);
        CHECK(snapshot.momentum->angular.residual().norm() <
              1e-6 * snapshot.momentum->angular_size);
      }
      previous = residual;
    }
  }
}

TEST_CASE("balls that do not reach each other: no effect of the missing cage",
          "[physics][dynamics]") {
  bearing::Bearing b = angular_contact(10);
  b.cage.reset();
  System alone = make_system(b, plan_with({RaceContact, RaceTraction}));
  b.element_traction = b.pocket_traction;
  System ring =
      make_system(b, plan_with({RaceContact, RaceTraction, ElementContact, ElementTraction}));
  const std::vector<double> y = ring.initial_state();
  std::vector<double> one(y.size()), other(y.size());
  REQUIRE(ring.rhs(0.0, y.data(), one.data()) == RhsStatus::Ok);
  REQUIRE(alone.rhs(0.0, y.data(), other.data()) == RhsStatus::Ok);
  for (int k = 0; k < alone.layout().controlled_size(); ++k)
    CHECK(one[static_cast<std::size_t>(k)] == other[static_cast<std::size_t>(k)]);
}

TEST_CASE("balls that overlap by a radius: invalid state", "[physics][dynamics]") {
  System system = make_system(crowded(), ring_plan(false));
  std::vector<double> y = system.initial_state();
  y[place(system, "element.theta", 1)] = y[place(system, "element.theta", 0)] + 0.1;
  CHECK_THROWS_WITH(system.snapshot(0.0, y),
                    Catch::Contains("elements 1 and 2 overlap by more than their radius"));
}

// Balls in balance (modes 1 and 2, qFac).

namespace {

scene::ScenePlan held_ring(bool friction, Effect balance = Effect::ElementBalance) {
  scene::ScenePlan plan = ring_plan(friction);
  plan.effects.push_back({balance, "", true, "test"});
  plan.light_load_ratio = balance == Effect::LightLoadBalance ? 0.15 : 0.0;
  return plan;
}

/// As a run does it: balls become held or free between steps.
Snapshot run_held(System& system, std::vector<double> y, double end, double tolerance) {
  system.set_start(0.0, y);
  (void)system.between_steps(0.0, y);
  Adapter adapter(system);
  const auto stepper = integrators::make_stepper("rkf4");
  integrators::StepControl control;
  control.maximum = end;
  control.minimum = 1e-13;
  control.tolerance = tolerance;
  stepper->start(adapter, 0.0, y, control);
  for (int step = 1; stepper->time() < end; ++step) {
    stepper->step(end);
    if (step % 5 != 0) continue;
    y.assign(stepper->state().begin(), stepper->state().end());
    if (system.between_steps(stepper->time(), y))
      stepper->start(adapter, stepper->time(), y, control);
  }
  return system.snapshot(end, stepper->state());
}

}  // namespace

TEST_CASE("squeezed ring of held balls: balance of all forces", "[physics][dynamics][held]") {
  constexpr int kBalls = 12;
  bearing::Bearing b = crowded(kBalls);
  b.balls().pitch_diameter = (0.0127 - 2e-5) / std::sin(std::numbers::pi / kBalls);
  System held = make_system(b, held_ring(false)), free = make_system(b, ring_plan(false));
  std::vector<double> y = held.initial_state();
  (void)held.between_steps(0.0, y);
  y = fixture::run(held, y, 2e-3, 1e-9).y;
  const Snapshot now = held.snapshot(2e-3, y);
  std::vector<double> state(y.begin(), y.begin() + free.layout().controlled_size()), rates;
  state.resize(free.initial_state().size(), 0.0);
  rates.resize(state.size());
  REQUIRE(free.rhs(0.0, state.data(), rates.data()) == RhsStatus::Ok);
  for (std::size_t i = 0; i < kBalls; ++i) {
    const double outward =
        2.0 * now.elements[i].to_next->force * std::sin(std::numbers::pi / kBalls);
    REQUIRE(outward > 5.0);
    for (const char* rate : {"element.x_dot", "element.r_dot"})
      CHECK(std::abs(b.element_inertia.mass * rates[place(free, rate, i)]) < 1e-4 * outward);
  }
}

TEST_CASE("held balls without cage: ledgers close through collisions",
          "[physics][dynamics][held][energy]") {
  for (const Effect balance : {Effect::ElementBalance, Effect::LightLoadBalance})
    for (const bool friction : {false, true}) {
      bearing::Bearing b = crowded();
      if (balance == Effect::LightLoadBalance) b.constraints.load = {600.0, 0.0, 800.0, 0.0, 0.0};
      double previous = 1e300;
      for (const double tolerance : {1e-6, 1e-9}) {
        System system = make_system(b, held_ring(friction, balance));
        const Snapshot at = run_held(system, colliding(system), 1.5e-3, tolerance);
        const double residual =
            std::abs(at.energy.residual()) / at.energy.sum(scene::LedgerKind::Start);
        const double heat = at.energy.value("element_heat");
        INFO("friction " << friction << ", tolerance " << tolerance << ": residual " << residual
                         << ", heat between balls " << heat << " J, "
                         << at.held_elements.value_or(0) << " held");
        CHECK(at.held_elements.value_or(0) > 0);
        CHECK((heat > 1e-6) == friction);
        CHECK(residual < std::max(0.5 * previous, 1e-9));
        if (tolerance == 1e-9) {
          CHECK(residual < 1e-6);
          CHECK(at.momentum->linear.residual().norm() < 1e-6 * at.momentum->linear_size);
          CHECK(at.momentum->angular.residual().norm() < 1e-6 * at.momentum->angular_size);
        }
        previous = residual;
      }
    }
}

TEST_CASE("mode 1 without cage: speed and heat of mode 0", "[physics][dynamics][held][slow]") {
  bearing::Bearing b = crowded();
  b.constraints.load = {1500.0, 0.0, 500.0, 0.0, 0.0};
  const double end = 3.0 * 2.0 * std::numbers::pi / b.speed[1];
  std::array<Snapshot, 2> of;
  for (const bool held : {false, true}) {
    System system = make_system(b, held ? held_ring(true) : ring_plan(true));
    of[held ? 1 : 0] = run_held(system, system.initial_state(), end, 1e-6);
  }
  const auto turned = [](const Snapshot& s) {
    double sum = 0.0;
    for (const auto& e : s.elements) sum += e.theta;
    return sum;
  };
  for (const char* item : {"heat", "element_heat"})
    for (const int race : {0, 1}) {
      if (of[0].energy.find(item, race) == nullptr) continue;
      INFO(item << " " << race << ": " << of[0].energy.value(item, race) << " "
                << of[1].energy.value(item, race));
      CHECK(of[1].energy.value(item, race) == Approx(of[0].energy.value(item, race)).epsilon(0.01));
    }
  CHECK(turned(of[1]) == Approx(turned(of[0])).epsilon(1e-3));
}
