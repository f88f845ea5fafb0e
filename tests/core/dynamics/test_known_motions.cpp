#include "base/constants.hpp"
#include "core/dynamics/roller_scene.hpp"
#include "core/dynamics/system_fixture.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

/// Motions that are known from elsewhere: a ball, textbook frequencies.
using namespace adore;
using namespace adore::fixture;
using scene::Snapshot;

namespace {

using enum scene::Effect;

/// The ball's bearing with spheres that are taken for barrels: arcs of its radius, its grooves, its
/// mass and moments of inertia.
bearing::Bearing barrels_like(const bearing::Bearing& ball) {
  bearing::Bearing b = ball;
  b.type = bearing::Type::Spherical;
  bearing::RollerGeometry g;
  const bearing::BallGeometry& of = ball.balls();
  g.count = of.count;
  g.shape = bearing::RollerShape::Arc;
  g.diameter = of.diameter;
  g.crown_radius = 0.5 * of.diameter;
  g.length = 0.9 * of.diameter;
  g.pitch_diameter = of.pitch_diameter;
  g.clearance = 0.0;
  g.axis_angle = of.contact_angle;
  g.race_angle = {of.contact_angle, of.contact_angle};
  g.groove_factor = of.groove_factor;
  b.elements = g;
  b.roller_mass_offset = 0.0;
  b.cage.reset();
  b.imperfections = {};
  return b;
}

struct Settled {
  double orbit = 0.0;            ///< mean of all elements [rad/s]
  double spin = 0.0;             ///< mean |ω| [rad/s]
  std::array<double, 2> load{};  ///< mean by race [N]
  std::array<double, 2> contact_angle{};
};

/// Calls visit(snapshot) at `samples` instants of (from, to].
template <class Visit>
void watch(dynamics::System& system, double from, double to, int samples, const Visit& visit) {
  const std::vector<double> y = system.initial_state();
  system.set_start(0.0, y);
  Adapter adapter(system);
  const auto stepper = integrators::make_stepper("rkf5");
  integrators::StepControl control;
  control.maximum = to;
  control.minimum = 1e-13;
  control.tolerance = 1e-7;
  stepper->start(adapter, 0.0, y, control);
  for (int k = 1; k <= samples; ++k) {
    const double t = from + (to - from) * k / samples;
    while (stepper->time() < t) stepper->step(t);
    const std::span<const double> now = stepper->state();
    visit(system.snapshot(t, {now.begin(), now.end()}));
  }
}

/// Means over all elements and the second half of the time.
Settled settled(dynamics::System& system, double end) {
  constexpr int kSamples = 40;
  Settled out;
  watch(system, 0.5 * end, end, kSamples, [&](const Snapshot& at) {
    const double share = 1.0 / static_cast<double>(kSamples * at.elements.size());
    for (const scene::ElementSnapshot& e : at.elements) {
      out.orbit += share * e.theta_dot;
      out.spin += share * e.omega.norm();
      for (std::size_t j = 0; j < 2; ++j) {
        out.load[j] += share * e.race[j].load;
        out.contact_angle[j] += share * e.race[j].angle;
      }
    }
  });
  return out;
}

}  // namespace

TEST_CASE("barrels with the ball's radii and inertia carry a thrust as balls do",
          "[physics][rollers][limits]") {
  bearing::Bearing ball = angular_contact(9, 0.07);
  ball.constraints.load = {1500.0, 0.0, 0.0, 0.0, 0.0};
  ball.cage.reset();
  ball.speed = {0.0,
                500.0 * kPi / 30.0};  // statics of barrels has a guide for their weight at speed
  const double end = 4e-3;
  dynamics::System balls = make_system(ball, plan_with({RaceContact, RaceTraction}));
  const Settled b = settled(balls, end);
  roller_scene::Scene rollers = roller_scene::scene_of(
      barrels_like(ball), roller_scene::plan_of({RaceContact, RaceTraction}), 61);
  const Settled r = settled(rollers.system, end);
  INFO("orbit " << b.orbit << " and " << r.orbit << ", outer load " << b.load[0] << " and "
                << r.load[0] << ", angle " << b.contact_angle[0] << " and " << r.contact_angle[0]);
  // The laws of both contacts differ by up to a third (decision 108), which moves the contact
  // angle by half a degree; the rest is kinematics and balance.
  for (const std::size_t j : {0UL, 1UL}) {
    CHECK(r.contact_angle[j] == Approx(b.contact_angle[j]).margin(0.015));
    CHECK(r.load[j] == Approx(b.load[j]).epsilon(0.02));
  }
  CHECK(r.orbit == Approx(b.orbit).epsilon(3e-3));
  CHECK(r.load[1] * std::sin(r.contact_angle[1]) == Approx(1500.0 / 9.0).epsilon(0.005));
}

TEST_CASE("barrels with the ball's radii and inertia roll between preloaded races as balls do",
          "[physics][rollers][limits]") {
  bearing::Bearing ball = angular_contact(9, 0.07);
  ball.balls().contact_angle = 0.0;
  ball.balls().clearance = -1e-5;
  ball.balls().groove_plane = {0.0, 0.0};
  ball.constraints.displacement_given = {true, true, true, true, true};
  ball.constraints.load = {};
  ball.cage.reset();
  for (const double rpm : {1000.0, 6000.0}) {
    ball.speed = {0.0, rpm * kPi / 30.0};
    const double end = 2e-3;
    dynamics::System balls = make_system(ball, plan_with({RaceContact, RaceTraction}));
    const Settled b = settled(balls, end);
    bearing::Bearing barrels = barrels_like(ball);
    barrels.rollers()->clearance = ball.balls().clearance;
    roller_scene::Scene rollers =
        roller_scene::scene_of(barrels, roller_scene::plan_of({RaceContact, RaceTraction}), 61);
    const Settled r = settled(rollers.system, end);
    INFO(rpm << " rpm: orbit " << b.orbit << " and " << r.orbit << ", spin " << b.spin << " and "
             << r.spin << ", outer load " << b.load[0] << " and " << r.load[0]);
    CHECK(r.orbit == Approx(b.orbit).epsilon(3e-4));
    CHECK(r.spin == Approx(b.spin).epsilon(1e-3));  // where in its ellipse a ball rolls
    CHECK(r.load[0] == Approx(b.load[0]).epsilon(0.33));
    // Centrifugal force is that of the ball: the difference of both races' loads.
    CHECK(r.load[0] - r.load[1] == Approx(b.load[0] - b.load[1]).epsilon(2e-3).margin(0.02));
    CHECK(b.load[0] > 100.0);
  }
}

TEST_CASE("a bearing with a cage vibrates by its compliance at Z times the cage frequency",
          "[physics][dynamics][limits]") {
  constexpr int kBalls = 9;
  bearing::Bearing b = angular_contact(kBalls, 0.07);
  b.constraints.load = {100.0, 0.0, 900.0, 0.0, 0.0};
  dynamics::System system = make_system(b, full_plan());
  const double epicyclic = 0.5 * b.speed[1] * (1.0 - 0.0127 / 0.07 * std::cos(0.4363));
  const double turn = 2.0 * kPi / epicyclic;
  // The second turn of the cage; what holds the inner race, over the angle of the cage.
  std::vector<double> force, angle;
  watch(system, turn, 2.1 * turn, 330, [&](const Snapshot& at) {
    const double now = at.cages[0].total_rotation;
    if (!angle.empty() && now - angle.front() >= 2.0 * kPi) return;
    force.push_back(at.races[1].applied_force[2]);
    angle.push_back(now);
  });
  CHECK(angle.back() - angle.front() == Approx(2.0 * kPi).epsilon(0.01));
  const auto order = [&](int n) {
    std::complex<double> sum = 0.0;
    for (std::size_t k = 0; k < force.size(); ++k) {
      const double next = k + 1 < angle.size() ? angle[k + 1] : angle.front() + 2.0 * kPi;
      sum += force[k] * (next - angle[k]) / kPi * std::polar(1.0, -n * angle[k]);
    }
    return std::abs(sum);
  };
  const double passing = order(kBalls);
  INFO("orders 1, 5, 8, 9, 10, 13, 18: " << order(1) << ", " << order(5) << ", " << order(8) << ", "
                                         << passing << ", " << order(10) << ", " << order(13)
                                         << ", " << order(18));
  CHECK(passing > 1e-4 * 900.0);
  for (int n = 1; n < 2 * kBalls; ++n)
    if (n != kBalls) CHECK(order(n) < 0.2 * passing);
}
