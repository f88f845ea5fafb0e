#include "core/dynamics/system_fixture.hpp"
#include "dynamics/scene_estimate.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <thread>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

std::size_t first_of(const System& system, const std::string& group) {
  for (const auto& g : system.layout().groups())
    if (g.name == group) return static_cast<std::size_t>(g.slice.first);
  FAIL("no group " << group);
  return 0;
}
bool has_group(const System& system, const std::string& part) {
  const auto& groups = system.layout().groups();
  return std::any_of(groups.begin(), groups.end(),
                     [&](const auto& g) { return g.name.find(part) != std::string::npos; });
}

/// A solution with balls where the test wants them, all at rest, nothing loaded.
statics::StaticSolution placed_balls(const bearing::Bearing& b) {
  statics::StaticSolution s;
  for (int i = 0; i < b.balls().count; ++i) {
    statics::StaticBall ball;
    ball.azimuth = 2.0 * std::numbers::pi * i / b.balls().count;
    ball.r = 0.5 * b.balls().pitch_diameter;
    s.balls.push_back(ball);
  }
  return s;
}

/// Inertia forces and moments (about the base origin) of balls and cage in this state.
struct MomentumRates {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
  double size = 0.0;  ///< sum of magnitudes of the forces, for tolerances
};
MomentumRates momentum_rates(System& system, const std::vector<double>& y) {
  const bearing::Bearing& b = system.bearing();
  std::vector<double> d(y.size());
  REQUIRE(system.rhs(0.0, y.data(), d.data()) == RhsStatus::Ok);
  const auto at = [&](const std::vector<double>& v, const char* name, std::size_t i) {
    return v[first_of(system, std::string("element.") + name) + i];
  };
  MomentumRates rates;
  for (std::size_t i = 0; i < static_cast<std::size_t>(b.balls().count); ++i) {
    const double theta = at(y, "theta", i), td = at(y, "theta_dot", i), r = at(y, "r", i);
    const Vec3 e_r = radial_direction(theta), e_t = circumferential_direction(theta),
               e_x = Vec3::UnitX();
    const Vec3 centre = at(y, "x", i) * e_x + r * e_r;
    const Vec3 a = at(d, "x_dot", i) * e_x + (at(d, "r_dot", i) - r * td * td) * e_r +
                   (r * at(d, "theta_dot", i) + 2.0 * at(y, "r_dot", i) * td) * e_t;
    const double wr = at(y, "omega_r", i), wt = at(y, "omega_theta", i);
    // The unit vectors turn with the orbit: d(e_r) = td e_theta, d(e_theta) = -td e_r.
    const Vec3 alpha = at(d, "omega_x", i) * e_x + (at(d, "omega_r", i) - td * wt) * e_r +
                       (at(d, "omega_theta", i) + td * wr) * e_t;
    const Vec3 force = b.element_inertia.mass * a;
    rates.linear += force;
    rates.angular += centre.cross(force) + b.element_inertia.moments[0] * alpha;
    rates.size += force.norm();
  }
  if (has_group(system, "cage.position")) {
    const auto vec = [&](const std::vector<double>& v, const char* name) {
      const std::size_t k = first_of(system, name);
      return Vec3(v[k], v[k + 1], v[k + 2]);
    };
    const std::size_t q = first_of(system, "cage.quaternion");
    const Mat3 R = rotation_matrix(normalize_quaternion({y[q], y[q + 1], y[q + 2], y[q + 3]}));
    const Vec3 w = vec(y, "cage.omega"), I = b.cage->inertia.moments;
    const Vec3 force = b.cage->inertia.mass * vec(d, "cage.velocity");
    const Vec3 torque = R * (I.cwiseProduct(vec(d, "cage.omega")) + w.cross(I.cwiseProduct(w)));
    rates.linear += force;
    rates.angular += vec(y, "cage.position").cross(force) + torque;
    rates.size += force.norm();
  }
  return rates;
}

/// Adds what holds the races (minus the contact forces on them).
MomentumRates with_reactions(System& system, const std::vector<double>& y) {
  MomentumRates rates = momentum_rates(system, y);
  const Snapshot snapshot = system.snapshot(0.0, y);
  const contact::GrooveGeometry groove = contact::groove_geometry(system.bearing().balls());
  for (std::size_t j = 0; j < 2; ++j) {
    const RaceSnapshot& race = snapshot.races[j];
    const Vec3 centre = race.position + Vec3(groove.centre_x[j], 0.0, 0.0);
    rates.linear -= race.applied_force;
    rates.angular -= race.applied_moment + centre.cross(race.applied_force);
    rates.size += race.applied_force.norm();
  }
  return rates;
}

/// Moves balls against pocket walls and the cage against the lands, everything sliding.
std::vector<double> rough_state(System& system) {
  std::vector<double> y = system.initial_state();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const std::size_t n = static_cast<std::size_t>(system.bearing().balls().count);
  for (std::size_t i = 0; i < n; ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    y[first_of(system, "element.theta") + i] += sign * 1.54e-4 / 0.0475;  // play is 1.5e-4 m
    for (const char* name :
         {"element.theta_dot", "element.omega_x", "element.omega_r", "element.omega_theta"})
      y[first_of(system, name) + i] += 30.0 * unit(random);
    for (const char* name : {"element.x_dot", "element.r_dot"})
      y[first_of(system, name) + i] += 0.01 * unit(random);
  }
  const std::size_t p = first_of(system, "cage.position"), v = first_of(system, "cage.velocity");
  y[p + 1] += 1.5e-4;  // land play is 2e-4 m
  y[p + 2] -= 1.38e-4;
  for (std::size_t k = 0; k < 3; ++k) {
    y[v + k] += 0.1 * unit(random);
    y[first_of(system, "cage.omega") + k] += 5.0 * unit(random);
  }
  const Quat q = quaternion_from_angles({0.0, 2e-4, -3e-4});
  for (std::size_t k = 0; k < 4; ++k) y[first_of(system, "cage.quaternion") + k] = q[k];
  return y;
}

}  // namespace

TEST_CASE("state layout: names carry index and unit, quadratures come last", "[unit][dynamics]") {
  StateLayout layout;
  const Slice x = layout.add("element.x", "m", 3, 0.5);
  const Slice w = layout.add("cage.rotation", "rad", 1, 1.0);
  layout.begin_quadratures();
  layout.add("pockets.heat", "J", 1, 1.0);
  CHECK(layout.size() == 5);
  CHECK(layout.controlled_size() == 4);
  CHECK(layout.component_name(1) == "element.x[2] [m]");
  CHECK(layout.component_name(3) == "cage.rotation [rad]");
  CHECK(layout.component_name(4) == "pockets.heat [J]");
  CHECK_THROWS_AS(layout.component_name(5), InternalError);
  layout.set_scale(x, 0.25);
  CHECK(layout.scales()[2] == 0.25);
  CHECK(layout.scales()[static_cast<std::size_t>(w.first)] == 1.0);
}

TEST_CASE("cost ledger: sampled entries are scaled to all calls, full ones are not",
          "[unit][dynamics]") {
  CostLedger ledger;
  const int sampled = ledger.add_entry("sampled"), full = ledger.add_entry("full");
  for (int i = 0; i < 10 * CostLedger::kSampleEvery; ++i) {
    if (!ledger.sample()) continue;
    ledger.begin_sample();
    ledger.add_sampled(sampled, std::chrono::milliseconds(2));
    // The thread loses the processor in half of them, and what those saw is left out.
    if (i >= 5 * CostLedger::kSampleEvery) {
      ledger.add_sampled(sampled, std::chrono::milliseconds(50));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ledger.end_sample();
  }
  ledger.add(full, 5e-3);
  const auto rows = ledger.rows();
  // 640 calls of 2 ms; the cost of reading the clock (well below 0.2 ms) is taken off each.
  CHECK(rows[0].seconds == Approx(1.28).epsilon(0.1));
  CHECK(rows[0].calls == 640);
  CHECK(rows[1].seconds == Approx(0.005).epsilon(1e-9));
  CHECK(rows[1].calls == 1);
}

TEST_CASE("zero cost: what the plan does not name has no unknown and no row",
          "[unit][dynamics][zero_cost]") {
  const bearing::Bearing b = angular_contact(9);
  const auto solution = placed_balls(b);
  using enum Effect;
  System bare = make_system(b, plan_with({RaceContact}), solution);
  CHECK(bare.layout().size() == 9 * 9);
  CHECK(bare.layout().controlled_size() == 9 * 9);
  CHECK(bare.cost().rows().size() == 2);  // motion, both races

  System traction = make_system(b, plan_with({RaceContact, RaceTraction}), solution);
  CHECK(traction.layout().controlled_size() == 9 * 9);
  CHECK(traction.layout().size() == 9 * 9 + 4);  // work and heat of two races
  CHECK_FALSE(has_group(traction, "cage"));

  System cage = make_system(b, plan_with({RaceContact, CageMotion, PocketContact}), solution);
  CHECK(cage.layout().size() == 9 * 9 + 14);
  CHECK(cage.cost().rows().size() == 3);

  ScenePlan oriented = plan_with({RaceContact, ElementOrientation});
  oriented.oriented_elements = {0, 4};
  System turned = make_system(b, oriented, solution);
  CHECK(turned.layout().size() == 9 * 9 + 10);
  CHECK(has_group(turned, "element5.quaternion"));

  System full = make_system(b, full_plan(), solution);
  // work 2, heat 2 + 1 + 1, wear 4 + 1
  CHECK(full.layout().size() - full.layout().controlled_size() == 11);
}

TEST_CASE("zero cost: with traction off no ball gets a moment", "[physics][dynamics][zero_cost]") {
  const bearing::Bearing b = angular_contact();
  System system =
      make_system(b, plan_with({Effect::RaceContact, Effect::PocketContact, Effect::CageMotion}));
  const std::vector<double> y = rough_state(system);
  std::vector<double> d(y.size());
  REQUIRE(system.rhs(0.0, y.data(), d.data()) == RhsStatus::Ok);
  for (std::size_t i = 0; i < 18; ++i) {
    const double td = y[first_of(system, "element.theta_dot") + i];
    CHECK(d[first_of(system, "element.omega_x") + i] == 0.0);
    CHECK(d[first_of(system, "element.omega_r") + i] ==
          td * y[first_of(system, "element.omega_theta") + i]);
  }
}

TEST_CASE("scales: radius, largest load and the stiffest contact", "[unit][dynamics]") {
  bearing::Bearing b = angular_contact();
  const auto solution = statics_of(b, b.balls().contact_angle);
  System system = make_system(b, full_plan(), solution);
  CHECK(system.scales().length == 0.00635);
  CHECK(system.scales().force == 1500.0);
  CHECK(system.scales().time ==
        Approx(std::sqrt(b.element_inertia.mass / solution.max_stiffness)).epsilon(1e-14));
  const auto scale = [&](const char* name) {
    return system.layout().scales()[first_of(system, name)];
  };
  CHECK(scale("element.x_dot") == system.scales().length / system.scales().time);
  CHECK(scale("cage.quaternion") == 1.0);
  CHECK(scale("element.omega_r") == 1.0 / system.scales().time);
  system.set_scales({1.0, 2.0, 3.0});
  CHECK(scale("element.theta_dot") == 1.0 / 3.0);
  CHECK(scale("cage.position") == 1.0);

  b.constraints.load.fill(
      0.0);  // nothing applied, nothing carried: weight of an element, a contact at 1e-3 of it
  System idle = make_system(b, full_plan(), placed_balls(b));
  CHECK(idle.scales().force == Approx(b.element_inertia.mass * 9.81).epsilon(1e-14));
  CHECK(idle.scales().time > 0.0);
}

TEST_CASE("free ball under gravity: parabola in cylindrical coordinates",
          "[physics][dynamics][analytic]") {
  bearing::Bearing b = angular_contact(1);
  b.gravity = {0.3, 1.0, -9.81};
  System system = make_system(b, plan_with({Effect::Gravity}), placed_balls(b));
  std::vector<double> y = system.initial_state();
  const Vec3 start(0.01, -0.04 * std::sin(0.5), 0.04 * std::cos(0.5)), velocity(0.2, 0.7, 0.4);
  y[0] = start[0];
  y[1] = 0.04;
  y[2] = 0.5;
  y[3] = velocity[0];
  y[4] = velocity.dot(radial_direction(0.5));
  y[5] = velocity.dot(circumferential_direction(0.5)) / 0.04;
  y[6] = 30.0, y[7] = -20.0, y[8] = 10.0;
  const double end = 0.05;
  const RunResult result = run(system, y, end, 1e-11);
  const Vec3 expected = start + end * velocity + 0.5 * end * end * b.gravity;
  const Vec3 reached = result.y[0] * Vec3::UnitX() + result.y[1] * radial_direction(result.y[2]);
  CHECK((reached - expected).norm() <
        1e-10);  // tolerance 1e-11 of 6 mm per step, some hundred steps
  // A free ball keeps its angular velocity in space.
  const auto omega = [](const std::vector<double>& s) {
    return Vec3(s[6] * Vec3::UnitX() + s[7] * radial_direction(s[2]) +
                s[8] * circumferential_direction(s[2]));
  };
  CHECK((omega(result.y) - omega(y)).norm() < 1e-6);
  CHECK(std::abs(system.snapshot(end, result.y).energy.residual()) < 1e-12);
}

TEST_CASE("single ball: orbits on the outer race and keeps its energy", "[physics][dynamics]") {
  bearing::Bearing b = angular_contact(1);
  b.cage.reset();
  const contact::GrooveGeometry groove = contact::groove_geometry(b.balls());
  statics::StaticSolution solution = placed_balls(b);
  solution.displacement[0] =
      groove.centre_x[0] - groove.centre_x[1];  // grooves face each other with play
  System system = make_system(b, plan_with({Effect::RaceContact}), solution);
  std::vector<double> y = system.initial_state();
  // At the bottom of the outer groove, pressed by its centrifugal force.
  const double speed = 400.0;
  y[0] = groove.centre_x[0];
  y[1] = groove.centre_radius[0] + groove.offset[0];
  y[5] = speed;
  const double m = b.element_inertia.mass;
  for (int k = 0; k < 20; ++k) {  // Q(δ) = m r ω², by substitution
    const double E_star = bearing::contact_modulus(b.element_material, b.race_material[0]);
    const double K = contact::hertz_constants(contact::race_curvature(b.balls(), 0, 0.0), E_star).K;
    const double Q = m * y[1] * speed * speed;
    y[1] = groove.centre_radius[0] + groove.offset[0] + std::pow(Q / K, 2.0 / 3.0);
  }
  const RunResult result = run(system, y, 5e-3, 1e-12);
  CHECK(result.y[1] == Approx(y[1]).margin(1e-11));
  CHECK(result.y[2] == Approx(speed * 5e-3).epsilon(1e-9));
  const Snapshot s = system.snapshot(5e-3, result.y);
  CHECK(s.elements[0].race[0].load == Approx(m * y[1] * speed * speed).epsilon(1e-5));
  CHECK(s.elements[0].race[1].load == 0.0);
}

TEST_CASE("no friction and gravity: every ball keeps its angular momentum, the bearing its energy",
          "[physics][dynamics][energy]") {
  bearing::Bearing b = angular_contact(6);
  b.constraints.load = {1500.0, 0.0, 0.0, 0.0, 0.0};
  System system = make_system(b, plan_with({Effect::RaceContact}));
  std::vector<double> y = system.initial_state();
  for (std::size_t i = 0; i < 6; ++i) {
    y[18 + i] += 0.02 * static_cast<double>(i);  // axial
    y[24 + i] -= 0.01 * static_cast<double>(i);  // radial
  }
  system.set_start(0.0, y);
  const RunResult result = run(system, y, 2e-3, 1e-10);
  const EnergyLedger energy = system.snapshot(2e-3, result.y).energy;
  CHECK(energy.sum(LedgerKind::Work) == 0.0);
  CHECK(std::abs(energy.residual()) < 1e-7 * energy.sum(LedgerKind::Start));
  for (std::size_t i = 0; i < 6; ++i)  // concentric races of revolution: r² θ' is conserved
    CHECK(result.y[6 + i] * result.y[6 + i] * result.y[30 + i] ==
          Approx(y[6 + i] * y[6 + i] * y[30 + i]).epsilon(1e-8));
}

TEST_CASE("action equals reaction: races, pockets and lands", "[physics][dynamics]") {
  bearing::Bearing b = angular_contact();
  b.constraints.outer_misalignment = {2e-4, -1e-4};
  b.cage->lands[1].guide = bearing::GuideLand::Guide::Inner;
  b.cage->lands[1].diameter = 0.091;
  using enum Effect;
  System system =
      make_system(b, plan_with({RaceContact, RaceTraction, PocketContact, PocketTraction,
                                LandContact, LandTraction, CageMotion}));
  const std::vector<double> y = rough_state(system);
  const Snapshot s = system.snapshot(0.0, y);
  const auto loaded =
      std::count_if(s.elements.begin(), s.elements.end(),
                    [](const ElementSnapshot& e) { return e.pocket.at(0).force > 0.0; });
  REQUIRE(loaded >= 6);
  REQUIRE(s.cages.at(0).lands.at(0).force > 0.0);
  REQUIRE(s.cages.at(0).lands.at(1).force > 0.0);
  const MomentumRates sum = with_reactions(system, y);
  // Round-off of a sum of some ten thousand newton, lever 0.05 m.
  CHECK(sum.linear.norm() < 1e-12 * sum.size);
  CHECK(sum.angular.norm() < 1e-13 * sum.size);
}

TEST_CASE("resting cage: hangs in gravity, total weight on the races", "[physics][dynamics]") {
  bearing::Bearing b = angular_contact();
  b.gravity = {0.0, 0.0, -9.81};
  System system =
      make_system(b, plan_with({Effect::RaceContact, Effect::PocketContact, Effect::LandContact,
                                Effect::CageMotion, Effect::Gravity}));
  const std::vector<double> y = rough_state(system);
  const MomentumRates sum = with_reactions(system, y);
  const Vec3 weight = (18 * b.element_inertia.mass + b.cage->inertia.mass) * b.gravity;
  CHECK((sum.linear - weight).norm() < 1e-12 * sum.size);
}

TEST_CASE("start state from statics: close to equilibrium", "[physics][dynamics]") {
  const bearing::Bearing b = angular_contact();
  // Without friction in dynamics the static solution must not share a gyroscopic moment either.
  const auto solution = statics_of(b, b.balls().contact_angle, statics::Control::None);
  System system = make_system(b, plan_with({Effect::RaceContact}), solution);
  const std::vector<double> y = system.initial_state();
  const Snapshot s = system.snapshot(0.0, y);
  for (std::size_t i = 0; i < 18; ++i) {
    const double per_mass = s.elements[i].race[0].load / b.element_inertia.mass;
    CHECK(s.elements[i].race[0].load == Approx(solution.balls[i].Q[0]).epsilon(1e-9));
    CHECK(s.elements[i].race[1].load == Approx(solution.balls[i].Q[1]).epsilon(1e-9));
    // Statics solves to 1e-9 of its load scale, but takes the centrifugal force at the pitch radius
    // (r is some 30 µm more) and at the speed of classical rolling: a few 1e-4 of it.
    CHECK(std::abs(s.elements[i].ax) < 1e-7 * per_mass);
    CHECK(std::abs(s.elements[i].ar) < 1e-3 * per_mass);
  }
  CHECK(s.races[1].applied_force[0] == Approx(1500.0).epsilon(1e-7));
  CHECK(s.races[1].applied_force[2] == Approx(500.0).epsilon(1e-7));
}

TEST_CASE("start state: also with misaligned races", "[physics][dynamics]") {
  bearing::Bearing b = angular_contact();
  b.constraints.outer_misalignment = {1e-3, -5e-4};
  b.constraints.displacement = {0.0, 0.0, 0.0, 4e-4, 7e-4};
  const auto solution = statics_of(b, b.balls().contact_angle, statics::Control::None);
  System system = make_system(b, plan_with({Effect::RaceContact}), solution);
  const Snapshot s = system.snapshot(0.0, system.initial_state());
  for (std::size_t i = 0; i < 18; ++i) {
    // Out-of-plane parts of the normals (second order in tilt) are left out of the static ball
    // equilibrium only in θ.
    CHECK(s.elements[i].race[0].load == Approx(solution.balls[i].Q[0]).epsilon(1e-4));
    CHECK(s.elements[i].race[1].load == Approx(solution.balls[i].Q[1]).epsilon(1e-4));
  }
  CHECK(s.races[1].applied_force[0] == Approx(1500.0).epsilon(1e-4));
}

TEST_CASE("the cage starts on the locus of element centers with its ratios of speed",
          "[unit][dynamics]") {
  bearing::Bearing b = angular_contact();
  b.cage->start_offset = {1e-5, 3e-5, -8e-5};
  b.cage->start_angles = {0.0, 1e-4, -2e-4};
  b.cage->speed_ratio = 0.98;
  b.cage->whirl_ratio = 0.9;
  System system = make_system(b, full_plan());
  const std::vector<double> y = system.initial_state();
  const Snapshot s = system.snapshot(0.0, y);
  // Record 9.6 counts from the middle of the elements, what is stored from the base frame.
  double middle = 0.0;
  for (const auto& ball : s.elements) middle += ball.x / static_cast<double>(s.elements.size());
  CHECK(std::abs(middle) > 1e-7);
  CHECK((s.cages[0].position - Vec3(middle, 0.0, 0.0) - b.cage->start_offset).norm() < 1e-16);
  const double gamma = 0.0127 * std::cos(b.balls().contact_angle) / 0.095;
  const double speed = 0.98 * 0.5 * b.speed[1] * (1.0 - gamma);
  CHECK((s.cages[0].omega - Vec3(speed, 0, 0)).norm() < 1e-10 * speed);
  const Vec3 whirl = 0.9 * speed * Vec3(0.0, 8e-5, 3e-5);
  CHECK((s.cages[0].velocity - whirl).norm() < 1e-12);
  CHECK((angles_from_quaternion(s.cages[0].orientation) - b.cage->start_angles).norm() < 1e-14);
}

TEST_CASE("state judged by its energy: checked and reported as evaluated", "[unit][dynamics]") {
  const bearing::Bearing b = angular_contact();
  System system = make_system(b, full_plan()), fresh = make_system(b, full_plan());
  std::vector<double> y = system.initial_state(), d(y.size());
  y[first_of(system, "element.r") + 1] += 1e-6;
  const Snapshot expected = fresh.snapshot(1e-5, y);
  REQUIRE(system.rhs(1e-5, y.data(), d.data()) == RhsStatus::Ok);
  (void)system.energy_balance();
  std::fill(d.begin(), d.end(), std::nan(""));  // what a method does with its rates is its own
  CHECK_NOTHROW(system.check_state(1e-5, y.data()));
  const Snapshot s = system.snapshot(1e-5, y);
  for (std::size_t i = 0; i < s.elements.size(); ++i) {
    CHECK(s.elements[i].ar == expected.elements[i].ar);
    CHECK(s.elements[i].race[0].load == expected.elements[i].race[0].load);
  }
  // Another state or time is evaluated anew, the one before it is no longer known.
  std::vector<double> other = y;
  other[first_of(system, "element.r") + 1] += 1e-6;
  CHECK(system.snapshot(1e-5, other).elements[1].race[0].load > 1.001 * s.elements[1].race[0].load);
  CHECK(system.snapshot(1e-5, y).elements[1].race[0].load == s.elements[1].race[0].load);
  other[first_of(system, "element.r") + 2] = -0.01;
  CHECK_THROWS_AS(system.check_state(1e-5, other.data()), SolverError);
}

TEST_CASE("state outside the model: trial → smaller step, accepted → reason", "[unit][dynamics]") {
  const bearing::Bearing b = angular_contact();
  System system = make_system(b, full_plan());
  std::vector<double> d(static_cast<std::size_t>(system.layout().size()));
  const std::vector<double> good = system.initial_state();
  REQUIRE(system.rhs(0.0, good.data(), d.data()) == RhsStatus::Ok);
  CHECK_NOTHROW(system.check_state(0.0, good.data()));

  const auto expect = [&](std::vector<double> y, const std::string& words) {
    CHECK(system.rhs(0.0, y.data(), d.data()) == RhsStatus::Retry);
    CHECK_THROWS_WITH(system.check_state(0.0, y.data()), Catch::Contains(words));
    CHECK_THROWS_AS(system.check_state(0.0, y.data()), SolverError);
  };
  std::vector<double> y = good;
  y[first_of(system, "element.theta") + 4] += 0.15;  // 7 mm: through the wall of its pocket
  expect(y, "element 5 is outside its cage pocket");
  y = good;
  y[first_of(system, "element.r") + 2] = -0.01;
  expect(y, "element 3 has reached the bearing axis");
  y = good;
  y[first_of(system, "cage.velocity")] = std::nan("");
  expect(y, "cage.velocity[1]");
  y = good;
  y[first_of(system, "element.r") + 1] += 0.01;
  expect(y, "element 2");
}

TEST_CASE("project: only quaternions change, and only when they are off", "[unit][dynamics]") {
  const bearing::Bearing b = angular_contact();
  System system = make_system(b, full_plan());
  std::vector<double> y = system.initial_state();
  CHECK_FALSE(system.project(0.0, y.data()));
  const std::size_t q = first_of(system, "cage.quaternion");
  std::vector<double> off = y;
  off[q] *= 1.0 + 1e-6;
  CHECK(system.snapshot(0.0, off).max_quaternion_error == Approx(1e-6).epsilon(1e-3));
  CHECK(system.project(0.0, off.data()));
  CHECK(off == y);
}

TEST_CASE("unusual bearings: one ball, two hundred balls, no cage, standing still, no load",
          "[physics][dynamics]") {
  const auto first_rates_are_finite = [](const bearing::Bearing& b, const ScenePlan& plan) {
    System system = make_system(b, plan);
    const std::vector<double> y = system.initial_state();
    std::vector<double> d(y.size());
    REQUIRE(system.rhs(0.0, y.data(), d.data()) == RhsStatus::Ok);
    return std::all_of(d.begin(), d.end(), [](double v) { return std::isfinite(v); });
  };
  using enum Effect;
  const ScenePlan no_cage = plan_with({RaceContact, RaceTraction, Gravity});
  bearing::Bearing b = angular_contact(1);
  b.constraints.load = {100.0, 0.0, 0.0, 0.0, 0.0};
  b.constraints.displacement_given = {false, true, true, true, true};
  CHECK(first_rates_are_finite(b, no_cage));
  CHECK(first_rates_are_finite(angular_contact(200, 1.0), full_plan()));
  b = angular_contact();
  b.speed = {0.0, 0.0};
  CHECK(first_rates_are_finite(b, full_plan()));
  b = angular_contact();
  b.constraints.load.fill(0.0);
  b.constraints.displacement_given.fill(true);
  CHECK(first_rates_are_finite(b, full_plan()));
}

TEST_CASE("plan estimates: the fastest contact and the expected step", "[unit][dynamics]") {
  const bearing::Bearing b = angular_contact();
  const auto solution = statics_of(b, b.balls().contact_angle);
  System system = make_system(b, full_plan(), solution);
  ScenePlan plan = full_plan();
  estimate(plan, b, solution, system);
  // Between two contacts of nearly opposite normals λ lies between one and two times the stiffest
  // contact.
  const double one =
      std::sqrt(solution.max_stiffness / b.element_inertia.mass) / (2.0 * std::numbers::pi);
  CHECK(plan.fastest_frequency > one);
  CHECK(plan.fastest_frequency < 1.5 * one);
  CHECK(plan.fastest_contact.find("race") != std::string::npos);
  CHECK(plan.expected_step == Approx(kPeriodsPerStep / plan.fastest_frequency));
  CHECK(plan.steps_per_revolution == Approx(60.0 / 10000.0 / plan.expected_step));
  CHECK(plan.seconds_per_revolution > 0.0);
  CHECK(system.cost().calls() == 0);
}

TEST_CASE("constants that follow the contact angle: energy kept while the angle swings",
          "[physics][dynamics][energy][hertz]") {
  // The inner race is driven along the axis and back: contact angles swing by some twenty degrees.
  bearing::Bearing b = angular_contact(8);
  b.cage.reset();
  b.constraints.displacement_given = {true, true, true, true, true};
  b.constraints.displacement = {2.2e-4, 0.0, 0.0, 0.0, 0.0};
  ScenePlan plan = plan_with({Effect::RaceContact});
  const double frequency = 150.0, end = 0.75 / frequency;
  plan.race_motions.vibration[1] = bearing::Vibration{Vec3(2e-4, 0.0, 0.0), frequency};
  double last = 1.0, least = 10.0, largest = -10.0;
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    System system = make_system(b, plan);
    const std::vector<double> y = system.initial_state();
    for (const double part : {1.0 / 3.0, 1.0}) {
      const Snapshot s =
          system.snapshot(part * end, run(system, y, part * end, tolerance, "rkf7").y);
      for (const ElementSnapshot& e : s.elements) {
        least = std::min(least, e.race[1].angle);
        largest = std::max(largest, e.race[1].angle);
      }
      if (part < 1.0) continue;
      const double moved = s.energy.value("elastic") + s.energy.sum(LedgerKind::Start);
      const double residual = std::abs(s.energy.residual()) / moved;
      CAPTURE(tolerance, residual);
      CHECK(residual < 100.0 * tolerance);
      CHECK(residual < last);
      last = residual;
    }
  }
  CAPTURE(least, largest);
  CHECK(largest - least > 0.3);
}
