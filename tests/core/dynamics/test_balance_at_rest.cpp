#include "roller_scene.hpp"
#include "statics/race_text.hpp"
#include "statics/roller_equilibrium.hpp"
#include "statics/roller_report.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

/// Mode 2 without friction beside the equilibrium of statics.
///
/// At a share of centrifugal force of 1 %, under a load that is the same all round (thrust, or
/// preload of rows that carry none). Balls spin about the bearing axis here: what statics make of a
/// gyroscopic moment is carried by friction. Barrels lean on their grooves: a guide ring, which
/// statics can hold them by (RollerOptions::guide), is not there. The centrifugal force is that of
/// statics, which is at the pitch circle (take_orbits).
/// A radial load squeezes rollers that nothing rubs along the races. Their azimuths change and
/// barrels skew, which statics take as given: with those of the motion it has the loads of the
/// motion.
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
  double mass = 0.0, orbit = 0.0, centrifugal = 0.0;  ///< of an element [kg, rad/s, N]
  std::array<double, 3> load{};                       ///< asked [N]
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
  out.mass = b.element_inertia.mass;
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
      roller_scene::scene_of(b, mode_2(roller_scene::races_only()), 9, 0.0, {}, false));
  out.orbit = scene->rollers->solution.orbital_speed;
  out.centrifugal = scene->rollers->solution.centrifugal_force;
  out.system = [scene] { return std::move(scene->system); };
  out.solve = [b](double first) {
    statics::RollerOptions options;
    options.slices = 9;
    options.guide = false;
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

double largest(const Loads& loads) {
  double most = 0.0;
  for (const std::array<double, 2>& of : loads) most = std::max({most, of[0], of[1]});
  return most;
}
double largest_off(const Snapshot& now, const Loads& solved) {
  double off = 0.0;
  for (std::size_t i = 0; i < solved.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j)
      off = std::max(off, std::abs(now.elements[i].race[j].load - solved[i][j]));
  return off;
}

double share_of(const Case& of) { return of.centrifugal / largest(of.solve(0.0)); }

/// Slows each orbit, so that the centrifugal force where the element stands is that of statics.
/// @param pull centrifugal force over the mass [m/s²]
void take_orbits(const dynamics::System& system, double pull, std::vector<double>& y) {
  const auto of = [&](const std::string& name) {
    for (const dynamics::StateLayout::Group& group : system.layout().groups())
      if (group.name == name) return y.data() + group.slice.first;
    throw std::runtime_error(name);
  };
  for (int i = 0; i < system.bearing().element_count(); ++i) {
    double& orbit = of("element.theta_dot")[i];
    const double slower = std::sqrt(pull / of("element.r")[i]);
    REQUIRE(slower == Approx(orbit).epsilon(1e-3));
    orbit = slower;
  }
}

/// The largest over 40 of the times in which a departure of the race decays (50 µs).
Compared compare(const Case& of) {
  dynamics::System system = of.system();
  std::vector<double> y = system.initial_state();
  system.set_start(0.0, y);
  system.between_steps(0.0, y);
  const Snapshot start = system.snapshot(0.0, y);
  take_orbits(system, of.centrifugal / of.mass, y);
  constexpr int parts = 5;
  const double part = 2e-3 / parts;
  Compared out;
  for (int n = 1; n <= parts; ++n) {
    y = fixture::run(system, y, part, 1e-10).y;
    if (n == 1) continue;  // the slower orbits are a departure of 1e-4, which decays meanwhile
    const Snapshot now = system.snapshot(n * part, y);
    const Loads solved = of.solve(now.elements[0].theta - start.elements[0].theta);
    const double most = largest(solved);
    out.loads = std::max(out.loads, largest_off(now, solved) / most);
    out.share = of.centrifugal / most;
    for (std::size_t k = 0; k < 3; ++k)
      if (!of.given[k])
        out.asked =
            std::max(out.asked,
                     std::abs(now.races[1].applied_force[static_cast<int>(k)] - of.load[k]) / most);
  }
  return out;
}

constexpr std::array<const char*, 5> kTypes{"ball", "cylindrical", "tapered", "spherical",
                                            "spherical-tapered"};

}  // namespace

TEST_CASE("mode 2 without friction has the loads of statics at 1 % of centrifugal force",
          "[physics][constrained][rollers][slow]") {
  for (const char* type : kTypes) {
    // The speed at which the share is that: it goes with the square.
    const double trial = 1000.0, share = 0.01;
    const double fastest = trial * std::sqrt(share / share_of(case_of(type, trial)));
    const Compared one = compare(case_of(type, fastest));
    INFO(type << ", share " << one.share << ": loads within " << one.loads << ", asked load within "
              << one.asked);
    CHECK(one.share == Approx(share).epsilon(0.05));
    CHECK(one.loads < 1e-6);
    CHECK(one.asked < 1e-7);  // at most 1e-8 with vectors of eight, 4e-8 without
  }
}

namespace {

/// What statics take as given: azimuth and skew of each roller [rad].
struct Places {
  std::vector<double> azimuth, skew;
};

/// Loads of statics with rollers at these places, from the solution of a bearing whose rollers are
/// near them.
Loads solve_at(const bearing::Bearing& b, const statics::RollerOptions& options,
               const Places& places) {
  statics::RollerModel model = statics::make_roller_model(b, options);
  const statics::RaceLoadCase task = statics::race_load_case(b.constraints);
  statics::set_load_floors(model, statics::force_scale(statics::race_scales(model), task, 0.0));
  const statics::RollerSolution near = statics::solve_roller_statics(b, options);
  model.azimuth = places.azimuth;
  statics::RollerRace state;
  for (Eigen::Index k = 0; k < 5; ++k) state.q(k) = near.displacement[static_cast<std::size_t>(k)];
  for (std::size_t i = 0; i < places.azimuth.size(); ++i) {
    statics::RollerState roller;
    roller.number = i;
    roller.sin = std::sin(places.azimuth[i]);
    roller.cos = std::cos(places.azimuth[i]);
    roller.skew_sin = std::sin(places.skew[i]);
    roller.skew_cos = std::cos(places.skew[i]);
    state.elements.push_back(roller);
  }
  REQUIRE(statics::solve_race_with_fallback(model, task, state).converged);
  Loads loads;
  for (const statics::RollerState& roller : state.elements) {
    const statics::StaticRoller at = statics::report_roller(model, state.q, roller);
    std::array<double, 2>& of = loads.emplace_back();
    for (std::size_t j = 0; j < 2; ++j)
      for (const double load : at.race[j].slice_load) of[j] += load;
  }
  return loads;
}

/// Largest differences from statics over the largest load, and how far rollers have gone [rad].
struct Squeezed {
  double start = 0.0;     ///< what the loads of the start have
  double equal = 0.0;     ///< with rollers at equal pitches
  double straight = 0.0;  ///< with rollers at their azimuths without skew
  double own = 0.0;       ///< with rollers where they are
  double apart = 0.0, skew = 0.0;
};

Squeezed squeeze(const bearing::Bearing& b) {
  roller_scene::Scene scene =
      roller_scene::scene_of(b, mode_2(roller_scene::races_only()), 9, 0.0, {}, false);
  dynamics::System& system = scene.system;
  std::vector<double> y = system.initial_state();
  system.set_start(0.0, y);
  system.between_steps(0.0, y);
  const Snapshot start = system.snapshot(0.0, y);
  const statics::RollerOptions options = scene.rollers->options;
  const double pitch = 2.0 * std::numbers::pi / b.element_count();
  constexpr int parts = 10;
  const double part = 2e-3 / parts;
  Squeezed out;
  for (int n = 1; n <= parts; ++n) {
    y = fixture::run(system, y, part, 1e-10).y;
    const Snapshot now = system.snapshot(n * part, y);
    Places own, straight, equal;
    for (std::size_t i = 0; i < now.elements.size(); ++i) {
      own.azimuth.push_back(now.elements[i].theta);
      own.skew.push_back(std::asin(now.elements[i].x_axis[1]));
      equal.azimuth.push_back(now.elements[0].theta + pitch * static_cast<double>(i));
      out.apart = std::max(out.apart, std::abs(own.azimuth[i] - equal.azimuth[i]));
      out.skew = std::max(out.skew, std::abs(own.skew[i]));
    }
    straight.azimuth = own.azimuth;
    straight.skew = equal.skew = std::vector<double>(own.skew.size(), 0.0);
    const Loads there = solve_at(b, options, own);
    const auto off = [&](const Snapshot& of, const Loads& solved) {
      return largest_off(of, solved) / largest(there);
    };
    out.start = std::max(out.start, off(start, there));
    out.equal = std::max(out.equal, off(now, solve_at(b, options, equal)));
    out.straight = std::max(out.straight, off(now, solve_at(b, options, straight)));
    out.own = std::max(out.own, off(now, there));
  }
  return out;
}

}  // namespace

TEST_CASE("mode 2 of rollers that a radial load squeezes along has the loads of statics there",
          "[physics][constrained][rollers][slow]") {
  for (bearing::Bearing b :
       {roller_bearings::cylindrical(1.0, -1e-5), roller_bearings::tapered(1.0),
        roller_bearings::spherical(1.0, -1e-5), roller_bearings::spherical_tapered(1.0)}) {
    b.constraints.load[2] = 1500.0;
    if (b.constraints.load[0] > 0.0) b.constraints.load[0] = 4000.0;
    const Squeezed of = squeeze(b);
    INFO("type " << static_cast<int>(b.type) << ": rollers " << of.apart
                 << " rad out of their pitch, skewed by " << of.skew << " rad; loads off by "
                 << of.equal << " with equal pitch, " << of.straight << " without skew, " << of.own
                 << " where they are; those of the start are off by " << of.start);
    CHECK(of.equal > 1e-5);
    CHECK(of.own < 1e-6);
    // What the wedge between eccentric races skews barrels on a rib by counts.
    if (b.type == bearing::Type::SphericalTapered) CHECK(of.straight > 2e-6);
  }
}
