#include "core/dynamics/allocation_counter.hpp"
#include "core/dynamics/system_fixture.hpp"
#include "dynamics/constrained.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

/// Radial load with little thrust: the balls opposite the load touch the outer race only. The cage
/// is thrown against its lands and pockets.
bearing::Bearing half_loaded(bool rattling = false) {
  bearing::Bearing b = angular_contact(12, 0.06);
  b.constraints.load = {200.0, 0.0, 2000.0, 0.0, 0.0};
  b.gravity = {0.0, 0.0, -9.81};
  if (!rattling) return b;
  b.cage->start_offset = {0.0, 1.0e-4, -1.4e-4};
  b.cage->speed_ratio = 0.995;
  return b;
}

ScenePlan held_plan(double ratio, ScenePlan plan = full_plan()) {
  plan.effects.push_back({Effect::MomentumLedger, "", true, "test"});
  if (ratio > 0.0) plan.effects.push_back({Effect::LightLoadBalance, "", true, "test"});
  plan.light_load_ratio = ratio;
  return plan;
}

int held_count(System& system, double t, std::span<const double> y) {
  return system.snapshot(t, y).held_elements.value_or(0);
}

struct HeldRun {
  std::vector<double> y;
  Snapshot last;
  double largest_residual = 0.0;  ///< of the energy, over the stored energy, at ten instants
  long evaluations = 0, changes = 0;
  int most_held = 0;
};

/// As a run does it: elements change between holding and free after every tenth step only.
HeldRun run_held(System& system, std::vector<double> y, double end, double tolerance,
                 const char* method = "rkf5") {
  Adapter adapter(system);
  system.set_start(0.0, y);
  HeldRun out;
  out.changes += system.between_steps(0.0, y);
  const auto stepper = integrators::make_stepper(method);
  integrators::StepControl control;
  control.maximum = end;
  control.minimum = 1e-13;
  control.tolerance = tolerance;
  stepper->start(adapter, 0.0, y, control);
  long before = 0;
  for (int k = 1; k <= 10; ++k) {
    const double stop = 0.1 * k * end;
    while (stepper->time() < stop) {
      double h = 0.0;
      for (int i = 0; i < 10 && stepper->time() < stop; ++i) h = stepper->step(stop).h;
      y.assign(stepper->state().begin(), stepper->state().end());
      out.most_held = std::max(out.most_held, held_count(system, stepper->time(), y));
      if (!system.between_steps(stepper->time(), y)) continue;
      ++out.changes;
      before += stepper->counters().evaluations;
      control.initial = h;
      stepper->start(adapter, stepper->time(), y, control);
    }
    out.last = system.snapshot(stepper->time(), stepper->state());
    const EnergyLedger& energy = out.last.energy;
    out.largest_residual =
        std::max(out.largest_residual, std::abs(energy.residual()) / energy.sum(LedgerKind::Start));
  }
  out.y.assign(stepper->state().begin(), stepper->state().end());
  out.evaluations = before + stepper->counters().evaluations;
  return out;
}

/// Component `slice_first + i` of a state by name.
std::size_t index_of(const System& system, const std::string& group) {
  for (const StateLayout::Group& g : system.layout().groups())
    if (g.name == group) return static_cast<std::size_t>(g.slice.first);
  FAIL("no group " << group);
  return 0;
}

}  // namespace

TEST_CASE("held balls: without friction they stand where the balance says, and energy is kept",
          "[physics][dynamics][held]") {
  bearing::Bearing b = half_loaded();
  b.gravity.setZero();
  b.cage.reset();
  const auto solution = statics_of(b, b.balls().contact_angle);
  System system = make_system(b, held_plan(0.05, plan_with({Effect::RaceContact})), solution);
  const HeldRun run = run_held(system, system.initial_state(), 2e-3, 1e-10);
  REQUIRE(run.most_held >= 3);
  REQUIRE(run.most_held < 12);
  CHECK(run.changes >= 2);  // balls pass in and out of the load zone

  const contact::GrooveGeometry groove = contact::groove_geometry(b.balls());
  std::array<RacePose, 2> races;
  for (std::size_t j = 0; j < 2; ++j) {
    races[j].centre = Vec3(groove.centre_x[j], 0.0, 0.0);
  }
  races[1].centre +=
      Vec3(solution.displacement[0], solution.displacement[1], solution.displacement[2]);
  const double mass = b.element_inertia.mass;
  const ConstrainedBall ball(groove, {1.0, 1.0}, mass, angle_laws(b));
  int compared = 0;
  for (const ElementSnapshot& e : run.last.elements) {
    if (!e.held) continue;
    const Orbit orbit{Orbit::Kept::Momentum, mass * e.r * e.r * e.theta_dot};
    const BallBalance exact = ball.solve(races, e.theta, orbit, Vec2::Zero(), {e.x, e.r});
    REQUIRE(exact.solved);
    // The motion follows the balance to the integration's error: 1e-10 of the ball radius per step.
    CHECK(std::abs(e.x - exact.x) < 2e-8 * b.balls().diameter);
    CHECK(std::abs(e.r - exact.r) < 2e-8 * b.balls().diameter);
    CHECK(e.vx == 0.0);
    CHECK(e.ar == 0.0);
    ++compared;
  }
  CHECK(compared >= 3);
  const EnergyLedger& energy = run.last.energy;
  CHECK(std::abs(energy.value("balance")) <
        1e-6 * energy.value("elastic"));  // nothing is lost on the way
  CHECK(run.largest_residual < 1e-10);
}

TEST_CASE("held balls: the energy residual with impacts and switches shrinks with the tolerance",
          "[physics][dynamics][held][energy][slow]") {
  const bearing::Bearing b = half_loaded(true);
  System system = make_system(b, held_plan(0.05));
  double first = 0.0, previous = 0.0, momentum = 0.0, angular = 0.0;
  for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
    const HeldRun run = run_held(system, system.initial_state(), 3e-3, tolerance, "rkf4");
    const EnergyLedger& energy = run.last.energy;
    CHECK(run.most_held >= 3);
    CHECK(run.changes >= 3);
    CHECK(energy.value("pocket_heat") > 1e-5);
    CHECK(energy.value("switches") != 0.0);
    // Blows of the cage on held balls lose what would be their motion in x and r: some per cent.
    CHECK(energy.value("balance") > 0.0);
    CHECK(energy.value("balance") < 0.1 * (energy.value("heat", 0) + energy.value("heat", 1)));
    UNSCOPED_INFO("tolerance " << tolerance << ": residual / stored " << run.largest_residual);
    if (previous > 0.0) CHECK(run.largest_residual < 0.3 * previous);
    if (first == 0.0) first = run.largest_residual;
    previous = run.largest_residual;
    momentum = run.last.momentum->linear.residual().norm() / run.last.momentum->linear_size;
    angular = run.last.momentum->angular.residual().norm() / run.last.momentum->angular_size;
  }
  // When a blow falls hangs on last digits: three instruction sets and two ways to round the start
  // left 1.2e-4 to 1.1e-3 of the first, for a tolerance of 1e-4 of it.
  CHECK(previous < 4e-3 * first);
  CHECK(momentum < 1e-10);
  CHECK(angular < 1e-10);
}

TEST_CASE("held balls: a switch books its jump, whatever the ball was doing",
          "[physics][dynamics][held]") {
  const bearing::Bearing b = half_loaded();
  System system = make_system(b, held_plan(0.05));
  std::vector<double> y = system.initial_state();
  system.set_start(0.0, y);
  const Snapshot start = system.snapshot(0.0, y);
  std::size_t light = 0, heavy = 0;
  const auto load = [&](std::size_t i) {
    return std::max(start.elements[i].race[0].load, start.elements[i].race[1].load);
  };
  for (std::size_t i = 0; i < 12; ++i) {
    if (load(i) < load(light)) light = i;
    if (load(i) > load(heavy)) heavy = i;
  }
  REQUIRE(load(light) < 0.05 * system.scales().force);
  REQUIRE(load(heavy) > 0.1 * system.scales().force);

  const std::size_t vx = index_of(system, "element.x_dot"), vr = index_of(system, "element.r_dot"),
                    r = index_of(system, "element.r");
  y[vx + light] = 0.02;
  y[vr + light] = -0.03;
  y[r + light] -= 2e-7;
  system.set_start(0.0, y);
  const double stored = system.snapshot(0.0, y).energy.sum(LedgerKind::Start);
  CHECK(system.between_steps(0.0, y));
  CHECK(y[vx + light] == 0.0);
  CHECK(y[vr + light] == 0.0);
  const Snapshot after = system.snapshot(0.0, y);
  CHECK(after.elements[light].held);
  CHECK_FALSE(after.elements[heavy].held);
  const double kinetic = 0.5 * b.element_inertia.mass * (0.02 * 0.02 + 0.03 * 0.03);
  CHECK(after.energy.value("switches") <
        -kinetic);  // and the elastic energy above that of the balance
  CHECK(after.energy.value("switches") > -3.0 * kinetic);
  CHECK(std::abs(after.energy.residual()) < 1e-13 * stored);
  CHECK(after.momentum->linear.residual().norm() < 1e-13 * after.momentum->linear_size);
  CHECK(after.momentum->angular.residual().norm() < 1e-13 * after.momentum->angular_size);
  CHECK_FALSE(system.between_steps(0.0, y));  // nothing more to change

  // Another system that takes this state over holds the same balls and has the same right-hand
  // side, bit for bit: a continued run is the unbroken one.
  System other = make_system(b, held_plan(0.05));
  other.set_start(0.0, y);
  CHECK(held_count(other, 0.0, y) == held_count(system, 0.0, y));
  std::vector<double> f(y.size()), g(y.size());
  REQUIRE(system.rhs(0.0, y.data(), f.data()) == RhsStatus::Ok);
  REQUIRE(other.rhs(0.0, y.data(), g.data()) == RhsStatus::Ok);
  CHECK(std::memcmp(f.data(), g.data(), f.size() * sizeof(double)) == 0);

  // The right-hand side knows no history.
  std::vector<double> moved = y;
  moved[r + light] += 3e-7;
  REQUIRE(system.rhs(0.0, moved.data(), g.data()) == RhsStatus::Ok);
  CHECK(std::memcmp(f.data(), g.data(), f.size() * sizeof(double)) != 0);
  REQUIRE(system.rhs(0.0, y.data(), g.data()) == RhsStatus::Ok);
  CHECK(std::memcmp(f.data(), g.data(), f.size() * sizeof(double)) == 0);

  const long allocations = test::allocation_count();
  for (int k = 0; k < 100; ++k) system.rhs(0.0, y.data(), f.data());
  CHECK(test::allocation_count() == allocations);

  // Released with the rates that it had as a held ball: pushed into the outer race by 2 µm.
  y[r + light] += 2e-6;
  REQUIRE(system.rhs(0.0, y.data(), f.data()) == RhsStatus::Ok);
  const double x_rate = f[index_of(system, "element.x") + light], r_rate = f[r + light];
  CHECK(system.between_steps(0.0, y));
  CHECK_FALSE(system.snapshot(0.0, y).elements[light].held);
  CHECK(y[vx + light] == x_rate);
  CHECK(y[vr + light] == r_rate);
}

TEST_CASE("held balls: every stepper follows the same motion", "[physics][dynamics][held][slow]") {
  const bearing::Bearing b = half_loaded();
  System system = make_system(b, held_plan(0.05));
  std::vector<double> y0 = system.initial_state();
  system.set_start(0.0, y0);
  REQUIRE(system.between_steps(0.0, y0));
  REQUIRE(held_count(system, 0.0, y0) >= 3);
  const double end = 2e-4;  // nothing is held or released in it
  const auto reference = run(system, y0, end, 1e-11, "rkf7").y;
  const auto scales = system.layout().scales();
  for (const std::string_view name : integrators::stepper_names()) {
    if (name == "arkode-imex") continue;  // needs a split right-hand side
    const bool first_order = name == "rkf1" || name == "pece1";
    const auto y = run(system, y0, end, first_order ? 1e-7 : 1e-8, std::string(name).c_str()).y;
    double worst = 0.0;
    for (int i = 0; i < system.layout().controlled_size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      worst = std::max(worst, std::abs(y[k] - reference[k]) / scales[k]);
    }
    INFO(name << ": " << worst);
    // Local errors of 1e-8 (order 1: 1e-7) add up over some hundred (ten thousand) steps.
    CHECK(worst < (first_order ? 2e-3 : 1e-5));
  }
}

TEST_CASE("held balls: few and light ones leave the bearing as it is, and none is no change at all",
          "[physics][dynamics][held]") {
  const bearing::Bearing b = half_loaded();
  System free = make_system(b, held_plan(0.0)), none = make_system(b, held_plan(1e-6));
  const double end = 3e-3, tolerance = 1e-8;
  const HeldRun without = run_held(free, free.initial_state(), end, tolerance);
  CHECK(run_held(none, none.initial_state(), end, tolerance).changes == 0);
  // To the byte: 16 balls fill the vectors of each race, which are then evaluated alike.
  bearing::Bearing whole = angular_contact(16, 0.08);
  whole.constraints.load = b.constraints.load;
  System free_16 = make_system(whole, held_plan(0.0)),
         none_16 = make_system(whole, held_plan(1e-6));
  const HeldRun one = run_held(free_16, free_16.initial_state(), 1e-3, tolerance);
  const HeldRun other = run_held(none_16, none_16.initial_state(), 1e-3, tolerance);
  for (int i = 0; i < free_16.layout().controlled_size(); ++i)
    CHECK(one.y[static_cast<std::size_t>(i)] == other.y[static_cast<std::size_t>(i)]);

  // Held balls do not vibrate along the groove, which costs the free ones a little friction; the
  // load zone is as it was.
  const auto heat = [](const HeldRun& run) {
    return run.last.energy.value("heat", 0) + run.last.energy.value("heat", 1);
  };
  const auto largest_load = [](const HeldRun& run) {
    double out = 0.0;
    for (const ElementSnapshot& e : run.last.elements) out = std::max(out, e.race[1].load);
    return out;
  };
  for (const double ratio : {0.3, 0.1, 0.03}) {
    System system = make_system(b, held_plan(ratio));
    const HeldRun with = run_held(system, system.initial_state(), end, tolerance);
    INFO("qFac " << ratio << ", " << with.evaluations << " evaluations, free "
                 << without.evaluations);
    CHECK(with.most_held > 2);
    CHECK(heat(with) == Approx(heat(without)).epsilon(0.03));
    CHECK(largest_load(with) == Approx(largest_load(without)).epsilon(0.02));
  }
}

TEST_CASE("held balls: a still bearing, one that holds all balls, and one far too fast for any",
          "[physics][dynamics][held]") {
  bearing::Bearing b = half_loaded();
  const auto run_with = [&b](double rpm, double ratio) {
    b.speed[1] = rpm * std::numbers::pi / 30.0;
    System system = make_system(b, held_plan(ratio));
    const HeldRun run = run_held(system, system.initial_state(), 3e-4, 1e-7);
    CHECK(run.largest_residual < 1e-6);
    return run;
  };
  const HeldRun still = run_with(0.0, 0.1);
  CHECK(still.most_held >= 3);
  CHECK(still.last.energy.value("kinetic") < 1e-6);  // the light balls settle, nothing takes off
  CHECK(run_with(10000.0, 10.0).most_held == 12);
  CHECK(run_with(30000.0, 0.01).most_held == 0);  // centrifugal loads of 400 N
}

TEST_CASE("held balls: without their vibration the steps are longer",
          "[physics][dynamics][held][slow]") {
  const bearing::Bearing b = half_loaded();
  System free = make_system(b, held_plan(0.0)), held = make_system(b, held_plan(0.1));
  const double end = 6e-3;  // one turn of the shaft: balls leave the load zone and enter it
  const HeldRun without = run_held(free, free.initial_state(), end, 1e-8);
  const HeldRun with = run_held(held, held.initial_state(), end, 1e-8);
  INFO(with.evaluations << " evaluations, free " << without.evaluations);
  CHECK(with.changes >= 4);
  CHECK(static_cast<double>(with.evaluations) < 0.9 * static_cast<double>(without.evaluations));
}

TEST_CASE("momentum ledger: the residuals shrink with the tolerance",
          "[physics][dynamics][momentum]") {
  const bearing::Bearing b = half_loaded(true);
  System system = make_system(b, held_plan(0.0));
  double first = 0.0, linear = 0.0, angular = 0.0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const HeldRun run = run_held(system, system.initial_state(), 1e-3, tolerance, "rkf3");
    const MomentumLedger& m = *run.last.momentum;
    // The races have pushed: the ledger balances something.
    CHECK(m.linear.sum(LedgerKind::Work).norm() > 1e-3 * m.linear_size);
    CHECK(m.angular.sum(LedgerKind::Work).norm() > 1e-5 * m.angular_size);
    linear = m.linear.residual().norm() / m.linear_size;
    angular = m.angular.residual().norm() / m.angular_size;
    UNSCOPED_INFO("tolerance " << tolerance << ": linear " << linear << ", angular " << angular);
    if (first == 0.0) first = linear + angular;
  }
  CHECK(linear + angular < 1e-2 * first);
  CHECK(linear < 1e-6);
  CHECK(angular < 1e-6);
}

TEST_CASE("momentum ledger: a force without its reaction shows as its impulse",
          "[physics][dynamics][momentum]") {
  /// A right-hand side that pushes ball 1 axially and nothing else.
  class OneSided final : public integrators::OdeSystem {
   public:
    OneSided(System& system, double force)
        : inner_(system),
          first_(index_of(system, "element.x_dot")),
          push_(force / system.bearing().element_inertia.mass) {}
    int size() const noexcept override { return inner_.size(); }
    int controlled_size() const noexcept override { return inner_.controlled_size(); }
    std::span<const double> scales() const noexcept override { return inner_.scales(); }
    integrators::EvalStatus rhs(double t, const double* y, double* dydt) noexcept override {
      const auto status = inner_.rhs(t, y, dydt);
      dydt[first_] += push_;
      return status;
    }
    bool project(double t, double* y) noexcept override { return inner_.project(t, y); }

   private:
    Adapter inner_;
    std::size_t first_;
    double push_;
  };
  const bearing::Bearing b = half_loaded();
  System system = make_system(b, held_plan(0.0));
  const std::vector<double> y0 = system.initial_state();
  const double end = 5e-4, force = 0.05;  // a ten-thousandth of the load on the bearing
  OneSided wrong(system, force);
  system.set_start(0.0, y0);
  const auto stepper = integrators::make_stepper("rkf5");
  integrators::StepControl control;
  control.maximum = end;
  control.minimum = 1e-13;
  control.tolerance = 1e-8;
  stepper->start(wrong, 0.0, y0, control);
  while (stepper->time() < end) stepper->step(end);
  const MomentumLedger m = *system.snapshot(end, stepper->state()).momentum;
  // Impulse - change: the change holds force × time that nobody gave.
  CHECK(m.linear.residual()[0] == Approx(-force * end).epsilon(1e-6));
  CHECK(std::abs(m.linear.residual()[1]) < 1e-6 * force * end);
  CHECK(m.angular.residual().norm() > 0.9 * force * end * 0.03);  // at the ball's radius
}
