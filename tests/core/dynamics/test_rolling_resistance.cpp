#include "core/dynamics/allocation_counter.hpp"
#include "core/dynamics/roller_scene.hpp"
#include "core/dynamics/system_fixture.hpp"
#include "core/dynamics/thrust_scene.hpp"
#include "statics/friction.hpp"
#include "tribology/film_law.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// Rolling resistance of the oil as an effect of motion (dynamics/effects/rolling_resistance.cpp).
using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

bearing::Lubrication oil() {
  bearing::Lubrication out;
  out.code = 1;
  out.critical_film = 1e-9;
  out.meniscus = 10.0;
  return out;
}

tribology::RollingResistance law_of() {
  tribology::RaceFilmInputs surface;
  surface.radius = 0.005;
  surface.modulus = 2.26e11;
  surface.wall_temperature = 360.0;
  surface.race_speed = 60.0;
  return tribology::rolling_resistance(tribology::lubricant(1), oil(), surface);
}

struct Rolled {
  test::Outputs balls;
  RaceSums race;
};
Rolled roll(InstructionSet set, const test::ThrustScene& scene, std::size_t j) {
  Rolled out{test::Outputs(scene.n), {}};
  const ElementForces forces = out.balls.forces();
  out.race =
      evaluate_race_rolling(set, scene.model[j], law_of(), scene.arrays(), scene.race[j], forces);
  return out;
}

/// A scene with everything that moves going the other way.
test::ThrustScene backwards(test::ThrustScene scene) {
  for (std::size_t k = 4; k < scene.ball.size(); ++k)
    for (double& v : scene.ball[k]) v = -v;
  for (RaceMotion& race : scene.race) {
    race.speed = -race.speed;
    race.velocity = -race.velocity;
    race.tilt = -race.tilt;
  }
  return scene;
}

double rolling_power(const Snapshot& s) {
  return s.energy.rate("rolling_heat", 0) + s.energy.rate("rolling_heat", 1);
}

}  // namespace

TEST_CASE("rolling resistance: what balls get the race gives, its power is 2 F u, and it is odd",
          "[physics][dynamics][film]") {
  for (const std::size_t balls : {16UL, 11UL}) {  // whole vectors, and not
    const test::ThrustScene scene = test::thrust_scene(
        "dyn3_40_30k_exp_curved", balls, tribology::make_split_ellipse_rule(15, 2), 1.0);
    const test::ThrustScene back = backwards(scene);
    for (std::size_t j = 0; j < 2; ++j) {
      CAPTURE(balls, j);
      const Rolled all = roll(InstructionSet::Baseline, scene, j);
      Vec3 force = all.race.force, moment = scene.race[j].centre.cross(force) + all.race.moment;
      double size = 0.0, size_of_moments = 0.0, power = 0.0;
      for (std::size_t i = 0; i < balls; ++i) {
        const double s = scene.ball[2][i], c = scene.ball[3][i], r = scene.ball[1][i];
        const auto base = [&](double x, double radial, double theta) {
          return Vec3(x, -s * radial - c * theta, c * radial - s * theta);
        };
        const auto& v = all.balls.value;
        const Vec3 F = base(v[0][i], v[1][i], v[2][i]), M = base(v[3][i], v[4][i], v[5][i]);
        force += F;
        moment += base(scene.ball[0][i], r, 0.0).cross(F) + M;
        size += F.norm();
        size_of_moments += M.norm();
        CHECK(all.balls.value[6][i] == 0.0);  // loads are not written
        const RaceContactState at =
            race_contact_state(scene.model[j], scene.arrays(), i, scene.race[j]);
        tribology::ContactConditions<double> point;
        point.load = at.ellipse.Q;
        point.half_major = at.ellipse.a;
        point.half_minor = at.ellipse.b;
        point.peak_pressure = 1.5 * at.ellipse.Q / (std::numbers::pi * at.ellipse.a * at.ellipse.b);
        point.entrainment = at.motion.entrainment;
        point.curvature = at.motion.curvature;
        const double h = at.ellipse.height(0.0);
        point.slip =
            std::hypot(at.motion.u_t - at.motion.W_c * h, at.motion.u_c + at.motion.W_t * h);
        power += 2.0 * law_of().force(point) * at.motion.entrainment;
      }
      REQUIRE(size > 0.0);
      CHECK(force.norm() < 1e-12 * size);
      CHECK(moment.norm() < 1e-11 * size_of_moments);
      CHECK(all.race.heat > 0.0);
      CHECK(all.race.heat == Approx(power).epsilon(1e-9));
      // It holds the spin of the race back: its moment is against its rolling past the balls.
      const double past = scene.race[j].speed - scene.ball[6][0];
      CHECK(all.race.moment.x() * past < 0.0);
      const Rolled other = roll(InstructionSet::Baseline, back, j);
      for (std::size_t k = 0; k < 6; ++k)
        for (std::size_t i = 0; i < balls; ++i)
          CHECK(other.balls.value[k][i] == Approx(-all.balls.value[k][i]).margin(1e-12 * size));
      CHECK(other.race.heat == Approx(all.race.heat).epsilon(1e-12));
      for (const InstructionSet set : {InstructionSet::Avx2, InstructionSet::Avx512}) {
        if (!is_instruction_set_available(set)) continue;
        const Rolled wide = roll(set, scene, j);
        CHECK(wide.race.heat == Approx(all.race.heat).epsilon(1e-9));
        for (std::size_t k = 0; k < 6; ++k)
          for (std::size_t i = 0; i < balls; ++i)
            CHECK(wide.balls.value[k][i] ==
                  Approx(all.balls.value[k][i]).epsilon(1e-8).margin(1e-9 * size));
      }
    }
  }
}

TEST_CASE("rolling resistance of balls closes the ledgers and costs nothing where it is off",
          "[physics][dynamics][energy][film]") {
  bearing::Bearing b = angular_contact();
  b.lubrication = oil();
  ScenePlan plan = full_plan();
  plan.effects.push_back({Effect::MomentumLedger, "", true, "test"});
  ScenePlan with = plan;
  with.effects.push_back({Effect::RollingResistance, "", true, "test"});
  System plain = make_system(b, plan), rolling = make_system(b, with);
  CHECK(rolling.layout().controlled_size() == plain.layout().controlled_size());
  CHECK(rolling.layout().size() == plain.layout().size() + 2);  // two heats
  const auto entries = [](System& system) {
    std::size_t n = 0;
    for (const auto& row : system.cost().rows()) n += row.name == "rolling resistance" ? 1 : 0;
    return n;
  };
  CHECK(entries(plain) == 0);
  CHECK(entries(rolling) == 1);
  const double end = 2e-4;
  double previous = 0.0;
  for (const double tolerance : {1e-6, 1e-9}) {
    const RunResult result = run(rolling, rolling.initial_state(), end, tolerance, "rkf4");
    const Snapshot now = rolling.snapshot(end, result.y);
    const double heat = now.energy.value("rolling_heat", 0) + now.energy.value("rolling_heat", 1);
    CHECK(heat > 0.0);
    CHECK(rolling_power(now) > 0.0);
    const double residual = std::abs(now.energy.residual());
    REQUIRE(now.momentum);
    CHECK(now.momentum->linear.residual().norm() < 1e-6 * now.momentum->linear_size);
    CHECK(now.momentum->angular.residual().norm() < 1e-6 * now.momentum->angular_size);
    if (previous > 0.0) {
      CHECK(residual < previous);
      CHECK(residual < 0.01 * heat);
    }
    previous = residual;
  }
  // The power of the start is that of the equilibrium, whose law it is.
  const Snapshot first = rolling.snapshot(0.0, rolling.initial_state());
  const statics::FrictionEstimate f =
      statics::friction_estimate(b, statics_of(b, b.balls().contact_angle));
  for (int j = 0; j < 2; ++j)
    CHECK(first.energy.rate("rolling_heat", j) == Approx(f.of_race(j).rolling).epsilon(0.02));
}

TEST_CASE("rolling resistance of rollers closes the ledgers and is that of the equilibrium",
          "[physics][rollers][energy][film]") {
  bearing::Bearing b = roller_bearings::cylindrical(6000.0);
  roller_scene::add_friction(b);
  b.lubrication = oil();
  ScenePlan plan =
      roller_scene::plan_of({Effect::RaceContact, Effect::RaceTraction, Effect::FlangeContact,
                             Effect::RollingResistance, Effect::MomentumLedger});
  roller_scene::Scene scene = roller_scene::scene_of(b, plan);
  System& system = scene.system;
  const Snapshot first = system.snapshot(0.0, system.initial_state());
  const statics::FrictionEstimate f =
      statics::friction_estimate(scene.bearing, scene.rollers->solution);
  for (int j = 0; j < 2; ++j) {
    REQUIRE(f.of_race(j).rolling > 0.0);
    CHECK(first.energy.rate("rolling_heat", j) == Approx(f.of_race(j).rolling).epsilon(0.03));
  }
  const double end = 1e-4;
  const RunResult result = run(system, system.initial_state(), end, 1e-9, "rkf4");
  const Snapshot now = system.snapshot(end, result.y);
  const double heat = now.energy.value("rolling_heat", 0) + now.energy.value("rolling_heat", 1);
  CHECK(heat > 0.0);
  CHECK(std::abs(now.energy.residual()) < 0.01 * heat);
  REQUIRE(now.momentum);
  CHECK(now.momentum->linear.residual().norm() < 1e-6 * now.momentum->linear_size);
  CHECK(now.momentum->angular.residual().norm() < 1e-6 * now.momentum->angular_size);
}

TEST_CASE(
    "rolling resistance of rollers: of the films of the traction it is that of films of its own",
    "[physics][rollers][film]") {
  using enum Effect;
  for (const int code : {1, 6, 8, 10, 11, 19}) {
    for (const bool tapers : {false, true}) {
      CAPTURE(code, tapers);
      bearing::Bearing b =
          tapers ? roller_bearings::tapered(6000.0) : roller_bearings::spherical(6000.0);
      roller_scene::add_friction(b);
      b.lubrication = oil();
      b.lubrication->code = code;
      const auto seen = [&](const ScenePlan& plan, bool floats) {
        SystemOptions options;
        options.single_films = floats;
        System system = roller_scene::scene_of(b, plan, 15, 0.0, options).system;
        return system.snapshot(0.0, system.initial_state());
      };
      const ScenePlan both =
          roller_scene::plan_of({RaceContact, RaceTraction, FlangeContact, RollingResistance});
      const Snapshot together = seen(both, false),
                     alone = seen(
                         roller_scene::plan_of({RaceContact, FlangeContact, RollingResistance}),
                         false),
                     rough = seen(both, true);
      for (const int race : {0, 1}) {
        CAPTURE(race);
        const double rolling = together.energy.rate("rolling_heat", race),
                     heat = together.energy.rate("heat", race);
        REQUIRE(rolling > 0.0);
        REQUIRE(heat > 0.0);
        CHECK(rolling == Approx(alone.energy.rate("rolling_heat", race)).epsilon(1e-11));
        // Films by floats (decision 570).
        CHECK(rough.energy.rate("rolling_heat", race) == Approx(rolling).epsilon(2e-5));
        CHECK(rough.energy.rate("heat", race) == Approx(heat).epsilon(3e-5));
        CHECK(rough.energy.rate("heat", race) != heat);
      }
    }
  }
}

TEST_CASE("rollers in oil: slices that share a vector with the next roller's stay with their own",
          "[physics][rollers][film]") {
  // 17 slices fill three vectors of eight, so that the last ones of a roller wait for the next one.
  // A bearing turned by a pitch has its rollers one further: other partners, the same forces.
  using enum Effect;
  constexpr int kSlices = 17;
  for (const int code : {1, 8, 13}) {
    bearing::Bearing b = roller_bearings::cylindrical(6000.0);
    roller_scene::add_friction(b);
    b.lubrication = oil();
    b.lubrication->code = code;
    const ScenePlan plan =
        roller_scene::plan_of({RaceContact, RaceTraction, FlangeContact, RollingResistance});
    const int n = b.element_count();
    const auto rates = [&](double first_azimuth) {
      SystemOptions options;
      System system = roller_scene::scene_of(b, plan, kSlices, first_azimuth, options).system;
      const std::vector<double> y = system.initial_state();
      std::vector<double> out(y.size());
      REQUIRE(system.rhs(0.0, y.data(), out.data()) == RhsStatus::Ok);
      return std::pair(system.layout().groups(), out);
    };
    const auto [groups, here] = rates(0.0);
    const auto there = rates(2.0 * std::numbers::pi / n).second;
    std::map<std::string, double> largest;  // of a unit: what is far below it is rounding
    for (const auto& group : groups)
      for (int k = 0; k < group.slice.count; ++k)
        largest[group.unit] = std::max(
            largest[group.unit], std::abs(here[static_cast<std::size_t>(group.slice.first + k)]));
    int compared = 0;
    for (const auto& group : groups) {
      if (group.slice.count != n) continue;  // one component of each roller
      double most = 0.0, miss = 0.0, spread = 0.0;
      for (int i = 0; i < n; ++i) {
        const auto at = [&](const std::vector<double>& of, int k) {
          return of[static_cast<std::size_t>(group.slice.first + k % n)];
        };
        most = std::max(most, std::abs(at(here, i)));
        miss = std::max(miss, std::abs(at(there, i) - at(here, i + 1)));
        spread = std::max(spread, std::abs(at(here, i) - at(here, i + 1)));
      }
      // Rounding, or all rollers alike: says nothing.
      if (most < 1e-9 * largest[group.unit] || !(spread > 1e-3 * most)) continue;
      CAPTURE(code, group.name, most, miss, spread);
      CHECK(miss < 1e-5 * most);
      ++compared;
    }
    CHECK(compared >= 3);
  }
}
