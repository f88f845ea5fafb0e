#include "../statics/ball_bearings.hpp"
#include "core/dynamics/allocation_counter.hpp"
#include "core/dynamics/system_fixture.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

/// The full model, with the cage thrown against its lands so that everything collides within a
/// millisecond.
bearing::Bearing rattling_bearing() {
  bearing::Bearing b = angular_contact();
  b.gravity = {0.0, 0.0, -9.81};
  b.cage->start_offset = {0.0, 1.3e-4, -1.55e-4};  // beyond the land play of 2e-4 m
  b.cage->start_angles = {0.0, 1e-3, 0.0};
  b.cage->speed_ratio = 0.98;
  b.cage->whirl_ratio = 1.5;
  return b;
}

struct ResidualResult {
  double largest =
      0.0;  ///< of ten instants, over the stored energy: the sign of one instant is chance
  EnergyLedger last;
};
ResidualResult largest_residual(System& system, double end, double tolerance, const char* method) {
  Adapter adapter(system);
  const std::vector<double> y0 = system.initial_state();
  system.set_start(0.0, y0);
  const auto stepper = integrators::make_stepper(method);
  integrators::StepControl control;
  control.maximum = end;
  control.minimum = 1e-13;
  control.tolerance = tolerance;
  stepper->start(adapter, 0.0, y0, control);
  ResidualResult result;
  for (int k = 1; k <= 10; ++k) {
    while (stepper->time() < 0.1 * k * end) stepper->step(0.1 * k * end);
    result.last = system.snapshot(stepper->time(), stepper->state()).energy;
    result.largest = std::max(
        result.largest, std::abs(result.last.residual()) / result.last.sum(LedgerKind::Start));
  }
  return result;
}

}  // namespace

TEST_CASE(
    "the energy residual of a full bearing with impacts shrinks with the tolerance over four "
    "decades",
    "[physics][dynamics][energy][slow]") {
  const bearing::Bearing b = rattling_bearing();
  ScenePlan plan = full_plan();
  plan.effects.push_back({Effect::ElementOrientation, "", true, "test"});
  plan.oriented_elements = {0};
  System system = make_system(b, plan);
  const double end = 2e-3;  // a third of a revolution of the shaft
  double previous = 0.0, first = 0.0;
  for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
    // Order 4: the Fehlberg pairs of higher order see little error at an impact that begins inside
    // a step.
    const auto [residual, energy] = largest_residual(system, end, tolerance, "rkf4");
    // Every mechanism must have turned over energy, or this test shows nothing.
    CHECK(energy.value("pocket_heat") > 1e-2);
    CHECK(energy.value("land_heat") > 1e-4);
    CHECK(energy.value("heat", 0) > 1e-2);
    CHECK(energy.value("heat", 1) > 1e-2);
    UNSCOPED_INFO("tolerance " << tolerance << ": residual / stored energy " << residual);
    if (previous > 0.0) CHECK(residual < 0.5 * previous);
    if (first == 0.0) first = residual;
    previous = residual;
  }
  CHECK(previous < 1e-3 * first);
  CHECK(previous < 1e-6);
}

TEST_CASE("without impacts the energy residual follows the order-5 stepper",
          "[physics][dynamics][energy]") {
  bearing::Bearing b = angular_contact();
  b.gravity = {0.0, 0.0, -9.81};
  b.cage.reset();
  using enum Effect;
  System system = make_system(b, plan_with({RaceContact, RaceTraction, Gravity, WearIntegrals}));
  double previous = 1.0;
  for (const double tolerance : {1e-4, 1e-5, 1e-6}) {
    const double residual = largest_residual(system, 1e-3, tolerance, "rkf5").largest;
    UNSCOPED_INFO("tolerance " << tolerance << ": residual / stored energy " << residual);
    CHECK(residual < 0.2 * previous);
    previous = residual;
  }
  CHECK(previous < 1e-9);
}

TEST_CASE("the same start gives the same bits", "[unit][dynamics]") {
  const bearing::Bearing b = rattling_bearing();
  System one = make_system(b, full_plan()), two = make_system(b, full_plan());
  const RunResult first = run(one, one.initial_state(), 2e-4, 1e-6);
  const RunResult second = run(two, two.initial_state(), 2e-4, 1e-6);
  CHECK(first.y == second.y);
  const RunResult again = run(one, one.initial_state(), 2e-4, 1e-6);
  CHECK(first.y == again.y);
}

TEST_CASE("turning load and cage by one pitch shifts the indices by one",
          "[physics][dynamics][symmetry]") {
  constexpr int n = 18;
  const double pitch = 2.0 * std::numbers::pi / n;
  bearing::Bearing b = angular_contact(n);
  b.cage->start_offset = {1e-5, 6e-5, -8e-5};
  b.gravity = {0.1, -2.0, -9.0};
  bearing::Bearing turned = b;
  const auto turn = [pitch](const Vec3& v) {
    return Vec3(v[0], std::cos(pitch) * v[1] - std::sin(pitch) * v[2],
                std::sin(pitch) * v[1] + std::cos(pitch) * v[2]);
  };
  const Vec3 load = turn({1500.0, 0.0, 500.0});
  turned.constraints.load = {load[0], load[1], load[2], 0.0, 0.0};
  turned.cage->start_offset = turn(b.cage->start_offset);
  turned.gravity = turn(b.gravity);
  // The cage has a pocket at every ball before and after the turn, so it starts level in both.
  System one = make_system(b, full_plan());
  System two = make_system(turned, full_plan());
  const double end = 2e-4;
  const RunResult first = run(one, one.initial_state(), end, 1e-9);
  const RunResult second = run(two, two.initial_state(), end, 1e-9);
  const Snapshot s1 = one.snapshot(end, first.y), s2 = two.snapshot(end, second.y);
  for (std::size_t i = 0; i < n; ++i) {
    const ElementSnapshot &p = s1.elements[i], &q = s2.elements[(i + 1) % n];
    // Positions agree to a few tolerances (6e-12 m each); 1e-11 m are 1e-5 of a load.
    CHECK(q.race[1].load == Approx(p.race[1].load).epsilon(1e-4));
    CHECK(std::abs(q.x - p.x) < 1e-10);
    CHECK(std::abs(q.r - p.r) < 1e-10);
    CHECK(std::abs(q.pocket[0].gap - p.pocket[0].gap) < 1e-8);
    CHECK((q.omega - p.omega).norm() < 1e-6 * p.omega.norm());
  }
  CHECK((s2.cages[0].position - turn(s1.cages[0].position)).norm() < 1e-8);
}

TEST_CASE("a right-hand side allocates nothing", "[unit][dynamics][alloc]") {
  const bearing::Bearing b = rattling_bearing();
  ScenePlan plan = full_plan();
  plan.effects.push_back({Effect::ElementOrientation, "", true, "test"});
  plan.oriented_elements = {0, 3};
  System system = make_system(b, plan);
  std::vector<double> y = run(system, system.initial_state(), 2e-4, 1e-6).y;
  std::vector<double> d(y.size());
  const long before = test::allocation_count();
  for (int i = 0; i < 3 * CostLedger::kSampleEvery; ++i) system.rhs(0.0, y.data(), d.data());
  system.project(0.0, y.data());
  CHECK(test::allocation_count() == before);
}

TEST_CASE("the cost ledger adds up to the time of the right-hand sides", "[unit][dynamics]") {
  const bearing::Bearing b = angular_contact();
  System system = make_system(b, full_plan());
  const std::vector<double> y = system.initial_state();
  std::vector<double> d(y.size());
  const auto ledger_sum = [&] {
    double sum = 0.0;
    for (const CostLedger::Row& row : system.cost().rows()) sum += row.seconds;
    return sum;
  };
  // A pause of this process is in neither of them. Still several batches: calls differ in length.
  constexpr int batches = 200, calls = 4 * CostLedger::kSampleEvery;
  double best = 1.0, last = 0.0;
  for (int batch = 0; batch < batches; ++batch) {
    const double start = scene::processor_seconds();
    for (int i = 0; i < calls; ++i) system.rhs(0.0, y.data(), d.data());
    const double measured = scene::processor_seconds() - start;
    const double sum = ledger_sum();
    best = std::min(best, std::abs((sum - last) / measured - 1.0));
    last = sum;
  }
  // What one reading of the clock costs is measured once, and off by a few ns: 2 to 4 % of a call,
  // 6 % when other processes kept the machine busy just then.
  CHECK(best < 0.1);
  CHECK(system.cost().calls() == batches * calls);
}

TEST_CASE("the run's ellipse rule is measured against one of twice as many nodes",
          "[physics][dynamics]") {
  const bearing::Bearing b = angular_contact();
  SystemOptions coarse, fine;
  coarse.ellipse_major = 6, coarse.ellipse_minor = 2;
  fine.ellipse_major = 48, fine.ellipse_minor = 24;
  System rough = make_system(b, full_plan(), coarse), normal = make_system(b, full_plan()),
         exact = make_system(b, full_plan(), fine);
  const auto error = [](System& s) { return s.quadrature_error(0.0, s.initial_state()).force; };
  CHECK(error(exact) > 0.0);
  CHECK(error(exact) < 1e-3);
  CHECK(error(normal) < 3e-2);
  CHECK(error(exact) < error(normal));
  CHECK(error(normal) < error(rough));
  System none = make_system(b, plan_with({Effect::RaceContact}));
  CHECK(none.quadrature_error(0.0, none.initial_state()).force == 0.0);
  const scene::QuadratureError sum = normal.quadrature_error(0.0, normal.initial_state());
  CHECK(sum.heat_of_finer > 0.0);
  CHECK(sum.heat_of_rule == Approx(sum.heat_of_finer).epsilon(0.03));
}

TEST_CASE("the 218 bearing at 15000 rpm runs at the contact angles of the classic solution",
          "[physics][dynamics]") {
  // Thrust 17.8 kN: 56.8 degrees inner, 19.2 outer with the gyroscopic moment carried at the outer
  // race. Its sign decides: reversed, the angles would be 50.0 and 31.8.
  bearing::Bearing b = ball_bearings::angular_contact_218(15000.0);
  ball_bearings::load(b, 17800.0, 0.0, 0.0);
  b.race_traction = {bearing::TractionCurve::Form::TwoSlope, 0.0, 0.15, -0.002, 0.0, 0.3};
  const auto statics = statics_of(b, b.balls().contact_angle);
  constexpr double kDegree = std::numbers::pi / 180.0;
  CHECK(statics.balls[0].alpha[0] == Approx(19.2 * kDegree).margin(0.1 * kDegree));
  CHECK(statics.balls[0].alpha[1] == Approx(56.8 * kDegree).margin(0.1 * kDegree));
  const auto plan = plan_with({Effect::RaceContact, Effect::RaceTraction});
  System system = make_system(b, plan, statics);
  const double turn = 60.0 / 15000.0;
  const Snapshot s =
      system.snapshot(4.0 * turn, run(system, system.initial_state(), 4.0 * turn, 1e-7, "rkf5").y);
  for (const ElementSnapshot& e : s.elements) {
    CHECK(e.race[0].angle == Approx(19.2 * kDegree).margin(0.3 * kDegree));
    CHECK(e.race[1].angle == Approx(56.8 * kDegree).margin(0.3 * kDegree));
  }
}
