#include "roller_scene.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// Mode 2 without friction beside the equilibrium of statics.
///
/// At a share of centrifugal force of 1 % (spherical rollers: 1e-5, below). Under a load that is
/// the same all round (thrust, or preload of rows that carry none) the loads of a motion are
/// steady, and those of statics for good, centrifugal forces included; a radial load squeezes
/// rollers that nothing rubs along the races, out of any equilibrium. Balls spin about the bearing
/// axis here: what statics make of a gyroscopic moment is carried by friction. Statics hold what
/// the centrifugal force of an inclined row of barrels has along its axis by a guide
/// (roller_model.hpp), which a motion without friction does not have: of them the row stands at low
/// speed only.
using namespace adore;
using scene::Effect;
using scene::ScenePlan;
using scene::Snapshot;

namespace {

ScenePlan mode_2(ScenePlan plan) {
  for (const Effect effect : {Effect::ElementBalance, Effect::RaceBalance})
    plan.effects.push_back({effect, "", true, "test"});
  return plan;
}

/// Loads of statics with the first element at an azimuth, [element][race].
using Loads = std::vector<std::array<double, 2>>;

/// A bearing in mode 2, and what statics say.
struct Case {
  std::function<dynamics::System()> system;
  std::function<Loads(double)> solve;
  double orbit = 0.0, centrifugal = 0.0;  ///< [rad/s, N]
  std::array<double, 3> load{};           ///< asked [N]
  std::array<bool, 5> given{};
};

Case case_of(const std::string& type, double rpm) {
  Case out;
  bearing::Bearing b;
  if (type == "ball") {
    b = fixture::angular_contact(12);
    b.cage.reset();
    b.speed = {0.0, rpm * roller_bearings::kDegree * 6.0};
    b.spin_rule = bearing::SpinRule::Prescribed;
    b.spin_angle = 0.0;
  } else if (type == "cylindrical") {
    b = roller_bearings::cylindrical(rpm, -1e-5);
  } else if (type == "tapered") {
    b = roller_bearings::tapered(rpm);
  } else if (type == "spherical") {
    b = roller_bearings::spherical(rpm, -1e-5);
  } else {
    b = roller_bearings::spherical_tapered(rpm);
  }
  b.constraints.load[2] = 0.0;
  for (std::size_t k = 0; k < 3; ++k) out.load[k] = b.constraints.load[k];
  for (std::size_t k = 0; k < 5; ++k) out.given[k] = b.constraints.displacement_given[k];
  if (b.rollers() == nullptr) {
    const auto solved = [b](double first) {
      return fixture::statics_of(b, b.balls().contact_angle, statics::Control::FromBearing, first);
    };
    const auto start = solved(0.0);
    out.orbit = start.balls[0].orbital_speed;
    out.centrifugal = start.balls[0].centrifugal_force;
    out.system = [b, start] {
      return fixture::make_system(b, mode_2(fixture::plan_with({Effect::RaceContact})), start);
    };
    out.solve = [solved](double first) {
      Loads loads;
      for (const statics::StaticBall& ball : solved(first).balls)
        loads.push_back({ball.Q[0], ball.Q[1]});
      return loads;
    };
    return out;
  }
  const auto scene = std::make_shared<roller_scene::Scene>(
      roller_scene::scene_of(b, mode_2(roller_scene::races_only()), 9));
  out.orbit = scene->rollers->solution.orbital_speed;
  out.centrifugal = scene->rollers->solution.centrifugal_force;
  out.system = [scene] { return std::move(scene->system); };
  out.solve = [b](double first) {
    statics::RollerOptions options;
    options.slices = 9;
    options.first_azimuth = first;
    Loads loads;
    for (const statics::StaticRoller& roller : statics::solve_roller_statics(b, options).rollers) {
      std::array<double, 2>& of = loads.emplace_back();
      for (std::size_t j = 0; j < 2; ++j)
        for (const double load : roller.race[j].slice_load) of[j] += load;
    }
    return loads;
  };
  return out;
}

struct Compared {
  double share = 0.0;  ///< centrifugal force over the largest load
  double loads = 0.0;  ///< largest difference over the largest load
  double asked = 0.0;  ///< what the race lacks of its load, over the largest load of an element
};

double share_of(const Case& of) {
  double most = 0.0;
  for (const std::array<double, 2>& loads : of.solve(0.0))
    most = std::max({most, loads[0], loads[1]});
  return of.centrifugal / most;
}

/// After many of the times in which a departure of the race decays (50 µs).
Compared compare(const Case& of) {
  dynamics::System system = of.system();
  std::vector<double> y = system.initial_state();
  system.set_start(0.0, y);
  system.between_steps(0.0, y);
  const auto largest_off = [&](const Snapshot& now, const Loads& solved) {
    double most = 0.0, off = 0.0;
    for (std::size_t i = 0; i < solved.size(); ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        most = std::max(most, solved[i][j]);
        off = std::max(off, std::abs(now.elements[i].race[j].load - solved[i][j]));
      }
    return std::pair{off / most, most};
  };
  const Snapshot start = system.snapshot(0.0, y);
  const double end = 2e-3;
  const Snapshot now = system.snapshot(end, fixture::run(system, y, end, 1e-10).y);
  const auto [off, most] =
      largest_off(now, of.solve(now.elements[0].theta - start.elements[0].theta));
  Compared out;
  out.loads = off;
  out.share = of.centrifugal / most;
  for (std::size_t k = 0; k < 3; ++k)
    if (!of.given[k])
      out.asked = std::max(
          out.asked, std::abs(now.races[1].applied_force[static_cast<int>(k)] - of.load[k]) / most);
  return out;
}

constexpr std::array<const char*, 5> kTypes{"ball", "cylindrical", "tapered", "spherical",
                                            "spherical-tapered"};

}  // namespace

TEST_CASE("mode 2 without friction has the loads of statics at 1 % of centrifugal force",
          "[physics][constrained][rollers][slow]") {
  for (const char* type : kTypes) {
    // The speed at which the share is that: it goes with the square.
    const double trial = 1000.0, share = std::string(type) == "spherical" ? 1e-5 : 0.01;
    const double fastest = trial * std::sqrt(share / share_of(case_of(type, trial)));
    const Compared one = compare(case_of(type, fastest));
    INFO(type << ", share " << one.share << ": loads within " << one.loads << ", asked load within "
              << one.asked);
    CHECK(one.share == Approx(share).epsilon(0.05));
    CHECK(one.loads < (std::string(type) == "spherical-tapered" ? 5e-6 : 1e-6));
    CHECK(one.asked < 1e-8);
  }
}
