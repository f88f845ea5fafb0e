#include "core/dynamics/system_fixture.hpp"
#include "integrators/arrow_jacobian.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

/// A state away from every symmetry, near the static one, with every ball pressed on both races.
std::vector<double> disturbed(const System& system) {
  std::vector<double> y = system.initial_state();
  for (const StateLayout::Group& group : system.layout().groups()) {
    const Slice& s = group.slice;
    for (int i = 0; i < s.count && s.first < system.layout().controlled_size(); ++i) {
      const double scale = system.layout().scales()[static_cast<std::size_t>(s.first + i)];
      y[static_cast<std::size_t>(s.first + i)] += 1e-5 * scale * std::sin(1.0 + s.first + 3.0 * i);
    }
  }
  return y;
}

Slice slice_of(const System& system, std::string_view name) {
  for (const StateLayout::Group& group : system.layout().groups())
    if (group.name == name) return group.slice;
  FAIL("no component is called " << name);
  return {};
}

bearing::Bearing bearing_with_touching_cage(int balls = 12) {
  bearing::Bearing b = angular_contact(balls, 0.07);
  b.gravity = {0.0, 0.0, -9.81};
  b.cage->pocket_clearance_1 = b.cage->pocket_clearance_2 = 2e-5;
  b.cage->start_offset = {0.0, 1.2e-4, -8e-5};  // several balls press on their pockets
  return b;
}

}  // namespace

TEST_CASE("stiff part: the rest of frictionless balls is the fictitious forces",
          "[physics][dynamics][implicit]") {
  bearing::Bearing b = angular_contact();
  b.cage.reset();
  System system = make_system(b, plan_with({Effect::RaceContact}));
  REQUIRE(system.has_stiff_part());
  std::vector<double> y = disturbed(system), whole(y.size()), stiff(y.size(), 1e300);
  const Slice x = slice_of(system, "element.x"), r = slice_of(system, "element.r");
  const Slice r_dot = slice_of(system, "element.r_dot"), td = slice_of(system, "element.theta_dot");
  const Slice vx = slice_of(system, "element.x_dot"), theta = slice_of(system, "element.theta");
  REQUIRE(system.rhs(0.0, y.data(), whole.data()) == RhsStatus::Ok);
  REQUIRE(system.rhs_stiff(0.0, y.data(), stiff.data()) == RhsStatus::Ok);
  double largest = 0.0;
  for (int i = 0; i < 18; ++i) {
    const auto rest = [&](const Slice& s) { return whole[s.first + i] - stiff[s.first + i]; };
    const double speed = y[td.first + i];
    CHECK(rest(x) == 0.0);
    CHECK(rest(r) == 0.0);
    CHECK(rest(theta) == 0.0);
    // Rounding of accelerations of some 1e4 m/s².
    largest = std::max(largest, std::abs(stiff[vx.first + i]));
    CHECK(std::abs(rest(vx)) < 1e-8);
    CHECK(rest(r_dot) == Approx(y[r.first + i] * speed * speed).epsilon(1e-9));
    CHECK(rest(td) ==
          Approx(-2.0 * y[r_dot.first + i] * speed / y[r.first + i]).epsilon(1e-6).margin(1e-6));
  }
  CHECK(largest > 1e3);  // the contacts did push
  const Slice spin = slice_of(system, "element.omega_x");
  CHECK(std::all_of(stiff.begin() + spin.first, stiff.end(), [](double v) { return v == 0.0; }));
}

TEST_CASE("stiff part: none without race contacts", "[unit][dynamics][implicit]") {
  bearing::Bearing b = angular_contact();
  b.cage.reset();
  System system = make_system(b, plan_with({Effect::Gravity}));
  CHECK_FALSE(system.has_stiff_part());
  std::vector<double> y = system.initial_state();
  CHECK(system.rhs_stiff(0.0, y.data(), y.data()) == RhsStatus::Fail);
}

TEST_CASE("arrow: elements are coupled only through the cage, with complete shares",
          "[physics][dynamics][implicit]") {
  ScenePlan plan = full_plan();
  plan.effects.push_back({Effect::ElementOrientation, "", true, "test"});
  plan.oriented_elements = {0, 4};
  System system = make_system(bearing_with_touching_cage(), plan);
  const auto element_of = system.coupling();
  REQUIRE(static_cast<int>(element_of.size()) == system.layout().controlled_size());
  std::vector<int> border;
  for (int k = 0; k < system.layout().controlled_size(); ++k)
    if (element_of[k] < 0) border.push_back(k);
  REQUIRE(border.size() == 14);

  const std::vector<double> y0 = disturbed(system);
  std::vector<double> f0(y0.size()), f(y0.size()), plain(y0.size());
  std::vector<double> shares0(12 * border.size()), shares(shares0.size());
  REQUIRE(system.rhs(0.0, y0.data(), plain.data()) == RhsStatus::Ok);
  REQUIRE(system.rhs_with_contributions(0.0, y0.data(), f0.data(), shares0.data()) ==
          RhsStatus::Ok);
  CHECK(f0 == plain);
  int pushed = 0;
  for (int k = 0; k < system.layout().controlled_size(); ++k) {
    if (element_of[k] < 0) continue;
    std::vector<double> y = y0;
    y[k] += 1e-4 * system.layout().scales()[k];
    REQUIRE(system.rhs_with_contributions(0.0, y.data(), f.data(), shares.data()) == RhsStatus::Ok);
    INFO("moved " << system.layout().component_name(k));
    for (int i = 0; i < system.layout().controlled_size(); ++i) {
      if (element_of[i] < 0 || element_of[i] == element_of[k]) continue;
      if (f[i] != f0[i]) FAIL("moves " << system.layout().component_name(i));
    }
    for (std::size_t c = 0; c < border.size(); ++c) {
      const std::size_t own = element_of[k] * border.size() + c;
      const double change = f[border[c]] - f0[border[c]];
      // Sums over all pockets against one share: rounding of rates of some 1e5.
      CHECK(shares[own] - shares0[own] == Approx(change).epsilon(1e-6).margin(1e-7));
      pushed += std::abs(change) > 1.0;
    }
  }
  CHECK(pushed > 20);  // the pockets did push
}

TEST_CASE("implicit-explicit steps: converge to the explicit solution of a bearing",
          "[physics][dynamics][implicit][slow]") {
  const bearing::Bearing b = bearing_with_touching_cage();
  System system = make_system(b, full_plan());
  const std::vector<double> y0 = system.initial_state();
  const double end = 3e-4;
  const RunResult reference = run(system, y0, end, 1e-12, "rkf7");
  const auto scales = system.layout().scales();
  double previous_error = 1e300, previous_residual = 1e300;
  for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
    const RunResult imex = run(system, y0, end, tolerance, "arkode-imex");
    double error = 0.0;
    for (int i = 0; i < system.layout().controlled_size(); ++i)
      error = std::max(error, std::abs(imex.y[i] - reference.y[i]) / scales[i]);
    const EnergyLedger energy = system.snapshot(end, imex.y).energy;
    const double residual = std::abs(energy.residual()) / energy.sum(LedgerKind::Start);
    INFO("tolerance " << tolerance << ": error " << error << ", energy residual " << residual
                      << ", steps " << imex.counters.steps);
    // Two decades of tolerance are 1.6 of the error at order four; contacts open and close.
    CHECK(error < 0.2 * previous_error);
    CHECK(residual < 0.2 * previous_residual);
    CHECK(imex.counters.nonlinear_iterations > imex.counters.steps);
    previous_error = error;
    previous_residual = residual;
  }
  CHECK(previous_error < 1e-6);
  // Of one instant: where steps meet the opening and closing of contacts is chance (1.4e-6
  // and 6.2e-6 of two roundings of the same contact law, whose errors are 9.8e-7 and 5.1e-7).
  CHECK(previous_residual < 1e-5);
}

TEST_CASE("Jacobian: cost independent of the number of balls", "[unit][dynamics][implicit]") {
  long price[2] = {0, 0};
  int which = 0;
  for (const int balls : {8, 18}) {
    System system = make_system(angular_contact(balls), full_plan());
    Adapter adapter(system);
    integrators::ArrowJacobian jacobian(adapter, integrators::RhsPart::Whole);
    integrators::ArrowMatrix J(jacobian.shape());
    std::vector<double> y = system.initial_state(), f(y.size());
    REQUIRE(system.rhs(0.0, y.data(), f.data()) == RhsStatus::Ok);
    REQUIRE(jacobian(0.0, y.data(), f.data(), J) == integrators::Outcome::Ok);
    price[which++] = jacobian.evaluations();
    J.scale_and_add_identity(-1e-6);
    CHECK(J.factor());
  }
  CHECK(price[0] == 9 + 14 + 1);  // one ball, the cage, the shares at the point
  CHECK(price[1] == price[0]);
}
