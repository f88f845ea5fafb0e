#include "bearing/contact_losses.hpp"
#include "contact/race_errors.hpp"
#include "core/dynamics/allocation_counter.hpp"
#include "core/dynamics/roller_scene.hpp"
#include "core/dynamics/system_fixture.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

/// Energy loss of normal contacts (contact/damping_law.hpp, dynamics/effects/contact_damping.hpp).
using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

/// Out of d v (1 + e) = ln((1 + d v)/(1 - d e v)), d = 1.5 α: by bisection.
double restitution(double alpha, double speed) {
  const double v = 1.5 * alpha * speed;
  double low = 0.0, high = std::min(1.0, 1.0 / v);
  for (int k = 0; k < 200; ++k) {
    const double e = 0.5 * (low + high);
    const double gap = v * (1.0 + e) - std::log((1.0 + v) / (1.0 - v * e));
    (gap > 0.0 ? low : high) = e;
  }
  return 0.5 * (low + high);
}

std::size_t place_of(const System& system, const std::string& name) {
  for (const auto& group : system.layout().groups())
    if (group.name == name) return static_cast<std::size_t>(group.slice.first);
  FAIL("no state " << name);
  return 0;
}

/// Speed at which an element that flies outwards comes back from the outer race.
double bounce(System& system, std::vector<double> y, double speed, double contact_time,
              Snapshot& after) {
  y[place_of(system, "element.r_dot")] = speed;
  double end = contact_time;
  for (int k = 0; k < 100; ++k, end += contact_time) {
    const RunResult result = run(system, y, end, 1e-12, "rkf7");
    after = system.snapshot(end, result.y);
    if (after.elements[0].vr < 0.0 && after.elements[0].race[0].load == 0.0)
      return -after.elements[0].vr;
  }
  FAIL("the element did not come back");
  return 0.0;
}

double power(const Snapshot& s) {
  return s.energy.rate("contact_damping", 0) + s.energy.rate("contact_damping", 1);
}

/// Still, without a load, and both grooves in one plane: the ball has its clearance to fly in.
statics::StaticSolution at_rest(bearing::Bearing& b) {
  b.speed = {0.0, 0.0};
  b.constraints.load = {};
  b.constraints.displacement = {};
  b.constraints.displacement_given = {true, true, true, true, true};
  const auto groove = contact::groove_geometry(b.balls());
  statics::StaticSolution solution = statics_of(b, b.balls().contact_angle);
  solution.displacement[0] = groove.centre_x[0] - groove.centre_x[1];
  return solution;
}

/// What damping takes beside the races, each kind an item of its own.
template <class Of>
double beside(const Of& of) {
  return of("pocket_damping") + of("land_damping") + of("flange_damping");
}

/// Hunt and Crossley's law alone.
SystemOptions damped(double alpha) {
  SystemOptions options;
  options.damping = {alpha, true};
  return options;
}

}  // namespace

TEST_CASE("contact damping: ball rebounds from a race by Hunt and Crossley's law",
          "[physics][dynamics][damping]") {
  bearing::Bearing b = angular_contact(1);
  b.cage.reset();
  const statics::StaticSolution solution = at_rest(b);
  const auto groove = contact::groove_geometry(b.balls());
  double before = 1.0;
  for (const double alpha : {0.1, 0.3, 2.0})
    for (const double speed : {0.02, 0.1, 0.5, 2.0}) {
      System system = make_system(b, plan_with({Effect::RaceContact, Effect::ContactDamping}),
                                  solution, damped(alpha));
      std::vector<double> y = system.initial_state();
      std::fill(y.begin(), y.end(), 0.0);
      y[place_of(system, "element.x")] = groove.centre_x[0];
      y[place_of(system, "element.r")] = groove.centre_radius[0] + groove.offset[0] - 1e-9;
      Snapshot after;
      const double back = bounce(system, y, speed, 4e-5 / std::pow(speed, 0.2), after);
      const double e = restitution(alpha, speed);
      INFO("alpha " << alpha << " s/m, " << speed << " m/s: " << back / speed << " for " << e);
      CHECK(back / speed == Approx(e).epsilon(2e-6));
      if (alpha * speed < 0.02) CHECK(1.0 - e == Approx(alpha * speed).epsilon(0.02));
      const double m = b.element_inertia.mass, lost = 0.5 * m * speed * speed * (1.0 - e * e);
      CHECK(after.energy.value("contact_damping", 0) == Approx(lost).epsilon(1e-5));
      CHECK(std::abs(after.energy.residual()) < 5e-6 * 0.5 * m * speed * speed);
      before = e;
    }
  CHECK(before < 0.3);
}

TEST_CASE("contact damping: roller rebounds from a race as a ball does",
          "[physics][rollers][damping]") {
  bearing::Bearing b = roller_bearings::cylindrical(0.0, 4e-4);
  b.rollers()->count = 1;
  b.constraints.load = {};
  b.constraints.displacement = {};
  b.constraints.displacement_given = {true, true, true, true, true};
  scene::ScenePlan plan = roller_scene::races_only();
  plan.effects.push_back({Effect::ContactDamping, "", true, "test"});
  auto rollers = std::make_shared<RollerStaticResult>();
  rollers->options.slices = 9;
  rollers->solution = statics::solve_roller_statics(b, rollers->options);
  for (const double speed : {0.1, 1.0}) {
    System system(b, plan, static_start(*rollers, b), {}, damped(0.3), {}, rollers);
    std::vector<double> y = system.initial_state();
    Snapshot after;
    const double r = y[place_of(system, "element.r")];
    REQUIRE(r > 0.02);
    y[place_of(system, "element.r")] = r + 9.9e-5;  // a micrometre from the race
    const double back = bounce(system, y, speed, 2e-5, after);
    INFO(speed << " m/s: " << back / speed);
    CHECK(back / speed == Approx(restitution(0.3, speed)).epsilon(1e-4));
  }
}

TEST_CASE("a loaded roller: small radial vibration -> decay of both losses of its contacts",
          "[physics][rollers][damping]") {
  // One roller between held races: m r'' = -(k1 + k2) r - (c1 + c2) r'. Material alone:
  // c_j = η √(m k_j/2), a decrement of πη (√k1 + √k2)/√(2 (k1 + k2)). The impact loss adds
  // c_j = 1.5 α Q_j.
  const bearing::Bearing b = roller_bearings::cylindrical(3000.0);
  scene::ScenePlan plan = roller_scene::races_only();
  plan.effects.push_back({Effect::ContactDamping, "", true, "test"});
  auto rollers = std::make_shared<RollerStaticResult>();
  rollers->options.slices = 9;
  rollers->solution = statics::solve_roller_statics(b, rollers->options);
  const auto losses = bearing::contact_losses(b.element_material, b.race_material[0]);
  for (const double alpha : {1e-12, 0.05}) {
    SystemOptions options;
    options.damping.impact_loss = alpha;
    System system(b, plan, static_start(*rollers, b), {}, options, {}, rollers);
    const std::vector<double> y0 = system.initial_state();
    const Snapshot start = system.snapshot(0.0, y0);
    std::size_t most = 0;
    for (std::size_t i = 1; i < start.elements.size(); ++i)
      if (start.elements[i].race[1].load > start.elements[most].race[1].load) most = i;
    const std::size_t r = place_of(system, "element.r") + most;
    const double mass = b.element_inertia.mass, shift = 1e-9;
    std::array<double, 2> k{};
    std::vector<double> y = y0;
    for (const double sign : {1.0, -1.0}) {
      y[r] = y0[r] + sign * shift;
      const Snapshot s = system.snapshot(0.0, y);
      for (std::size_t j = 0; j < 2; ++j)
        k[j] += (j == 0 ? sign : -sign) * s.elements[most].race[j].load / (2.0 * shift);
    }
    REQUIRE(std::min(k[0], k[1]) > 1e8);
    const double omega = std::sqrt((k[0] + k[1]) / mass);
    const double c =
        losses.loss_factor * std::sqrt(0.5 * mass) * (std::sqrt(k[0]) + std::sqrt(k[1])) +
        1.5 * alpha * (start.elements[most].race[0].load + start.elements[most].race[1].load);
    const double ratio = c / (2.0 * mass * omega),
                 decrement = 2.0 * std::numbers::pi * ratio / std::sqrt(1.0 - ratio * ratio);
    if (alpha < 1e-6)
      CHECK(decrement == Approx(std::numbers::pi * losses.loss_factor).epsilon(1e-3));
    constexpr double kPeriods = 5.0;
    const double end = kPeriods * 2.0 * std::numbers::pi / (omega * std::sqrt(1.0 - ratio * ratio));
    y = y0;
    y[r] += shift;
    const RunResult moved = run(system, y, end, 1e-12, "rkf7"),
                    still = run(system, y0, end, 1e-12, "rkf7");
    const double left = moved.y[r] - still.y[r];
    INFO("alpha " << alpha << " s/m, loss factor " << losses.loss_factor << ", stiffness " << k[0]
                  << " and " << k[1] << " N/m");
    CHECK(std::log(shift / left) / kPeriods == Approx(decrement).epsilon(0.02));
  }
}

TEST_CASE("a free race on its balls vibrates and decays as the linearized equations have it",
          "[physics][dynamics][races][damping]") {
  bearing::Bearing b = angular_contact(12);
  b.cage.reset();
  b.speed = {0.0, 0.0};
  b.constraints.load = {2000.0, 0.0, 0.0, 0.0, 0.0};
  b.constraints.displacement_given = {false, true, true, true, true};
  b.race_inertia[1] = {0.5, {5e-4, 4e-4, 4e-4}, Vec3::Zero()};
  scene::ScenePlan plan = plan_with({Effect::RaceContact, Effect::ContactDamping});
  plan.race_motions.free[1].emplace().force = {2000.0, 0.0, 0.0};
  SystemOptions options = damped(0.1);
  options.moving_angle = false;
  const double angle = b.balls().contact_angle, d = 1.5 * options.damping.impact_loss;
  statics::BallStaticsOptions frozen;
  frozen.curvature = statics::Curvature::Fixed;
  frozen.fixed_angle = {angle, angle};
  const auto solution = statics::solve_ball_statics(b, frozen);
  System system = make_system(b, plan, solution, options);

  // Race X, ball x and r, by one of 12 equal balls. u: X, x, r and their velocities.
  const auto groove = contact::groove_geometry(b.balls());
  const statics::StaticBall& ball = solution.balls[0];
  Eigen::Matrix3d K = Eigen::Matrix3d::Zero(), C = K;
  for (std::size_t j = 0; j < 2; ++j) {
    const double nx = std::sin(ball.alpha[j]), nr = std::cos(ball.alpha[j]);
    Eigen::Matrix<double, 2, 3> way;  // of the ball in the race
    way << (j == 1 ? -1.0 : 0.0), 1.0, 0.0, 0.0, 0.0, 1.0;
    const Eigen::Vector2d n(nx, nr), c(nr, -nx);
    const double normal = 1.5 * ball.Q[j] / ball.delta[j],
                 across = ball.Q[j] / (groove.offset[j] + ball.delta[j]);
    K += way.transpose() * (normal * n * n.transpose() + across * c * c.transpose()) * way;
    C += way.transpose() * (d * ball.Q[j] * n * n.transpose()) * way;
  }
  const Eigen::Vector3d mass(0.5 / 12.0, b.element_inertia.mass, b.element_inertia.mass);
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  A.topRightCorner<3, 3>().setIdentity();
  A.bottomLeftCorner<3, 3>() = -(mass.cwiseInverse().asDiagonal() * K);
  A.bottomRightCorner<3, 3>() = -(mass.cwiseInverse().asDiagonal() * C);
  const Eigen::EigenSolver<Eigen::Matrix<double, 6, 6>> modes(A);
  // The slowest one is the race on all its balls.
  int slow = 0;
  for (int k = 1; k < 6; ++k)
    if (std::abs(modes.eigenvalues()[k]) < std::abs(modes.eigenvalues()[slow])) slow = k;
  const std::complex<double> lambda = modes.eigenvalues()[slow];
  REQUIRE(lambda.real() < -20.0);
  REQUIRE(std::abs(lambda.imag()) > 10.0 * -lambda.real());

  const std::vector<double> y0 = system.initial_state();
  std::vector<double> y = y0;
  const std::size_t X = place_of(system, "inner race.position"),
                    V = place_of(system, "inner race.velocity"), x = place_of(system, "element.x"),
                    r = place_of(system, "element.r"), vx = place_of(system, "element.x_dot"),
                    vr = place_of(system, "element.r_dot");
  const double size = 1e-4 * ball.delta[0];
  const Eigen::Matrix<double, 6, 1> shape =
      (modes.eigenvectors().col(slow) / modes.eigenvectors()(0, slow)).real();
  y[X] += size * shape[0], y[V] += size * shape[3];
  for (std::size_t i = 0; i < 12; ++i) {
    y[x + i] += size * shape[1], y[r + i] += size * shape[2];
    y[vx + i] += size * shape[4], y[vr + i] += size * shape[5];
  }
  const double period = 2.0 * std::numbers::pi / std::abs(lambda.imag());
  for (const double periods : {1.25, 5.0}) {
    const double t = periods * period;
    const RunResult end = run(system, y, t, 1e-12, "rkf7");
    const RunResult rest = run(system, y0, t, 1e-12, "rkf7");
    const double expected = size * std::exp(lambda * t).real();
    INFO(periods << " periods of " << 1.0 / period << " Hz, decay " << -lambda.real() << " 1/s");
    CHECK(end.y[X] - rest.y[X] == Approx(expected).margin(3e-4 * size));
  }
  CHECK(std::exp(lambda.real() * 5.0 * period) < 0.95);
}

TEST_CASE("contact damping: energy is in the ledger, on perfect and on wavy races",
          "[physics][dynamics][energy][damping]") {
  for (const bool whole : {false, true})
    for (const bool wavy : {false, true}) {
      bearing::Bearing b = angular_contact();
      if (wavy)
        for (bearing::RaceErrors& e : b.imperfections.race) {
          e.roundness = bearing::RaceErrors::Roundness::Sinusoidal;
          e.variation = {2e-6, 11.0, 0.4};
        }
      // Whole, what is left at any tolerance are bends of the traction, met by a ball at a time.
      scene::ScenePlan plan = whole ? full_plan() : plan_with({Effect::RaceContact});
      plan.effects.push_back({Effect::ContactDamping, "", true, "test"});
      std::vector<double> residual;
      for (const double tolerance : {1e-5, 1e-8}) {
        System system = make_system(b, plan, damped(0.3));
        const double end = 5e-4;
        std::vector<double> y = system.initial_state();
        for (std::size_t i = 0; i < 18; ++i) y[place_of(system, "element.r_dot") + i] += 0.2;
        const RunResult result = run(system, y, end, tolerance);
        const Snapshot s = system.snapshot(end, result.y);
        const double heat =
            s.energy.value("contact_damping", 0) + s.energy.value("contact_damping", 1);
        CHECK(heat > 0.0);
        CHECK(power(s) >= 0.0);
        residual.push_back(std::abs(s.energy.residual()));
        INFO((whole ? "whole, " : "races only, ")
             << (wavy ? "wavy" : "perfect") << " races, tolerance " << tolerance << ": heat "
             << heat << " J, residual " << residual.back() << " J");
        if (tolerance < 1e-6) CHECK(residual.back() < (whole ? 1e-3 : 5e-5) * heat);
      }
      if (!whole) CHECK(residual[1] < 0.1 * residual[0]);
    }
}

TEST_CASE("contact damping of rollers: energy is in the ledger, on perfect and on wavy races",
          "[physics][rollers][energy][damping]") {
  for (const bool wavy : {false, true})
    for (bearing::Bearing b :
         {roller_bearings::cylindrical(3000.0), roller_bearings::tapered(3000.0)}) {
      roller_scene::add_friction(b);
      if (wavy)
        for (bearing::RaceErrors& e : b.imperfections.race) {
          e.roundness = bearing::RaceErrors::Roundness::Sinusoidal;
          e.variation = {1e-6, 7.0, 0.3};
        }
      scene::ScenePlan plan = roller_scene::races_only();
      plan.effects.push_back({Effect::ContactDamping, "", true, "test"});
      if (!b.rollers()->has_flange(0) && !b.rollers()->has_flange(1)) plan.effects[1].on = false;
      auto rollers = std::make_shared<RollerStaticResult>();
      rollers->options.slices = 9;
      rollers->solution = statics::solve_roller_statics(b, rollers->options);
      System system(b, plan, static_start(*rollers, b), {}, damped(0.3), {}, rollers);
      std::vector<double> y = system.initial_state();
      const auto n = static_cast<std::size_t>(b.element_count());
      for (std::size_t i = 0; i < n; ++i) y[place_of(system, "element.r_dot") + i] += 0.05;
      const RunResult result = run(system, y, 1e-3, 1e-8, "rkf5");
      const Snapshot s = system.snapshot(1e-3, result.y);
      const double heat =
          s.energy.value("contact_damping", 0) + s.energy.value("contact_damping", 1);
      INFO("type " << static_cast<int>(b.type) << (wavy ? ", wavy" : "") << ": heat " << heat
                   << " J, residual " << s.energy.residual() << " J");
      CHECK(heat > 0.0);
      CHECK(std::abs(s.energy.residual()) < std::max(2e-3 * heat, 1e-10));
    }
}

TEST_CASE("contact damping: no allocation, and absent when off",
          "[unit][dynamics][damping][allocation]") {
  const bearing::Bearing b = angular_contact();
  scene::ScenePlan plan = full_plan();
  System elastic = make_system(b, plan);
  plan.effects.push_back({Effect::ContactDamping, "", true, "test"});
  System system = make_system(b, plan, damped(0.2));
  CHECK(system.layout().size() ==
        elastic.layout().size() + 4);  // items of the ledger: races, pockets, lands
  for (const auto& row : elastic.cost().rows())
    CHECK(row.name.find("damping") == std::string::npos);
  const std::vector<double> y = system.initial_state();
  std::vector<double> rates(y.size());
  REQUIRE(system.rhs(0.0, y.data(), rates.data()) == RhsStatus::Ok);
  const auto before = test::allocation_count();
  REQUIRE(system.rhs(0.0, y.data(), rates.data()) == RhsStatus::Ok);
  CHECK(test::allocation_count() == before);
}

namespace {

/// Each contact beside the races by itself: how fast a body meets another, and how fast it leaves.
struct Impact {
  double back = 0.0, heat = 0.0, residual = 0.0;
};

/// The only ball flies along the ring into its pocket's wall; the cage is free.
Impact into_pocket(const bearing::Bearing& b, const statics::StaticSolution& solution, double alpha,
                   double speed) {
  scene::ScenePlan plan =
      plan_with({Effect::RaceContact, Effect::CageMotion, Effect::PocketContact});
  if (alpha > 0.0) plan.effects.push_back({Effect::ContactDamping, "", true, "test"});
  System system = make_system(b, plan, solution, damped(alpha));
  const auto groove = contact::groove_geometry(b.balls());
  std::vector<double> y = system.initial_state();
  const double r = 0.5 * (groove.centre_radius[0] + groove.centre_radius[1]);
  y[place_of(system, "element.x")] = groove.centre_x[0];
  y[place_of(system, "element.r")] = r;
  for (const char* still : {"element.x_dot", "element.r_dot", "element.omega_x", "element.omega_r",
                            "element.omega_theta"})
    y[place_of(system, still)] = 0.0;
  y[place_of(system, "element.theta_dot")] = speed / r;
  y[place_of(system, "element.theta")] += 1.4e-4 / r;  // of a play of 1.5e-4 m
  y[place_of(system, "cage.position")] = groove.centre_x[0];
  for (const auto& group : system.layout().groups())
    if (group.name == "cage.velocity" || group.name == "cage.omega")
      std::fill_n(y.begin() + group.slice.first, 3, 0.0);
  const auto gap = [&](double t, const std::vector<double>& state) {
    return system.snapshot(t, state).elements[0].pocket.at(0).gap;
  };
  // To the wall and away again, which takes some 50 us besides.
  const double flight = 3e-5 / speed + 2e-4, moment = 1e-6 / speed;
  const RunResult after = run(system, y, flight, 1e-11, "rkf7");
  const double apart = gap(flight, after.y);
  REQUIRE(apart > 0.0);
  std::vector<double> later = after.y;
  std::vector<double> rates(later.size());
  REQUIRE(system.rhs(flight, later.data(), rates.data()) == RhsStatus::Ok);
  for (std::size_t k = 0; k < later.size(); ++k) later[k] += moment * rates[k];
  const Snapshot s = system.snapshot(flight, after.y);
  REQUIRE(s.elements[0].race[0].load + s.elements[0].race[1].load == 0.0);
  Impact out;
  out.back = (gap(flight + moment, later) - apart) / moment;
  out.heat = alpha > 0.0 ? s.energy.value("pocket_damping") : 0.0;
  out.residual = s.energy.residual();
  return out;
}

}  // namespace

TEST_CASE("contact damping: ball leaves its pocket by Hunt and Crossley's law",
          "[physics][dynamics][cage][damping]") {
  bearing::Bearing b = angular_contact(1);
  const statics::StaticSolution solution = at_rest(b);
  for (const double speed : {0.05, 0.5}) {
    const Impact elastic = into_pocket(b, solution, 0.0, speed);
    CHECK(elastic.back == Approx(speed).epsilon(2e-3));
    double mass = 0.0;  // of ball and cage together along the normal: the same for all dampings
    for (const double alpha : {0.1, 0.3, 2.0}) {
      const Impact impact = into_pocket(b, solution, alpha, speed);
      const double e = restitution(alpha, speed);
      INFO("alpha " << alpha << " s/m, " << speed << " m/s: " << impact.back / elastic.back
                    << " for " << e);
      CHECK(impact.back / elastic.back == Approx(e).epsilon(1e-3));
      const double of_both = impact.heat / (0.5 * speed * speed * (1.0 - e * e));
      if (mass > 0.0) CHECK(of_both == Approx(mass).epsilon(2e-3));
      mass = of_both;
      // The bends of the law are met in the middle of steps, hard ones by few.
      CHECK(std::abs(impact.residual) < 1e-4 * 0.5 * mass * speed * speed);
    }
    CHECK(mass < b.element_inertia.mass);
    CHECK(mass > 0.0);
  }
}

TEST_CASE("contact damping: energy in pockets, at lands and flanges is in the ledger",
          "[physics][dynamics][cage][rollers][energy][damping]") {
  const auto check = [](System& system, double end, const std::string& name) {
    std::vector<double> y = system.initial_state();
    y[place_of(system, "cage.velocity") + 1] += 0.4;
    y[place_of(system, "cage.velocity") + 2] += 0.3;
    const std::size_t x_dot = place_of(system, "element.x_dot");
    for (std::size_t i = 0; i < 4; ++i) y[x_dot + i] += 0.1;
    const RunResult result = run(system, y, end, 1e-8, "rkf5");
    const Snapshot s = system.snapshot(end, result.y);
    const double heat =
        beside([&](const char* id) { return s.energy.value(id) + s.energy.value(id, 1); });
    INFO(name << ": heat " << heat << " J, residual " << s.energy.residual() << " J");
    CHECK(heat > 0.0);
    CHECK(beside([&](const char* id) { return s.energy.rate(id) + s.energy.rate(id, 1); }) >= 0.0);
    CHECK(std::abs(s.energy.residual()) < 2e-3 * heat);
    REQUIRE(s.momentum);
    CHECK(s.momentum->linear.residual().norm() < 1e-7 * s.momentum->linear_size);
    CHECK(s.momentum->angular.residual().norm() < 1e-7 * s.momentum->angular_size);
  };
  {
    scene::ScenePlan plan = plan_with({Effect::RaceContact, Effect::CageMotion, Effect::LandContact,
                                       Effect::PocketContact, Effect::MomentumLedger});
    plan.effects.push_back({Effect::ContactDamping, "", true, "test"});
    System system = make_system(angular_contact(), plan, damped(0.3));
    check(system, 2e-3, "balls");
  }
  for (bearing::Bearing b :
       {roller_bearings::cylindrical(3000.0), roller_bearings::tapered(3000.0)}) {
    roller_scene::add_cage(b);
    scene::ScenePlan plan = roller_scene::frictionless();
    plan.effects.push_back({Effect::ContactDamping, "", true, "test"});
    auto rollers = std::make_shared<RollerStaticResult>();
    rollers->options.slices = 9;
    rollers->solution = statics::solve_roller_statics(b, rollers->options);
    System system(b, plan, static_start(*rollers, b), {}, damped(0.3), {}, rollers);
    check(system, 1e-3, "rollers of type " + std::to_string(static_cast<int>(b.type)));
  }
}
