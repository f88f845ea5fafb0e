#include "bearing/material_laws.hpp"
#include "contact/groove.hpp"
#include "deck/templates.hpp"
#include "results/results_h5.hpp"
#include "runs/prepare.hpp"
#include "setup/build_bearing.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_model.hpp"
#include "statics/roller_statics.hpp"
#include "support/paths.hpp"
#include "thermal/operating.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// The datum of displacements (decision 140): a displacement that a mount holds is one of the
/// bearing on the bench, and what grows, grows against it.
using namespace adore;
using bearing::Bearing;

namespace {

using Sets = std::vector<std::pair<const char*, const char*>>;

Bearing built(const char* type, const Sets& sets) {
  deck::Deck deck = deck::new_deck(type);
  deck.set("mode", "-1");
  deck.complete();
  for (const auto& [name, value] : sets) deck.set(name, value);
  deck.complete();
  return setup::build_bearing(deck);
}

/// Nothing turns, nothing presses, everything is held at (x, 0, z).
Bearing held(const char* type, double x, double z) {
  Bearing b = built(type, {{"rpm1", "0.0"}, {"rpm2", "0.0"}});
  b.constraints.displacement_given.fill(true);
  b.constraints.load.fill(0.0);
  b.mounting.fit = {0.0, 0.0};
  b.constraints.displacement = {x, 0.0, z, 0.0, 0.0};
  return b;
}

struct Found {
  statics::RaceResult race;
  std::array<double, 2> first{};  ///< loads of the element at azimuth 0, outer and inner [N]
};

Found solve(const Bearing& as_built) {
  const Bearing b = thermal::operating_bearing(as_built);
  if (b.rollers()) {
    const auto s = statics::solve_roller_statics(b);
    return {s, {s.rollers[0].race[0].load, s.rollers[0].race[1].load}};
  }
  const auto s = statics::solve_ball_statics(b);
  return {s, s.balls[0].Q};
}

void warm(Bearing& b, int race, double kelvin) {
  b.race_temperature[static_cast<std::size_t>(race)] += kelvin;
  (race == 0 ? b.mounting.housing_temperature : b.mounting.shaft_temperature) += kelvin;
}

/// A given displacement that loads each type at rest.
struct Case {
  const char* type;
  double x, z;
};
constexpr Case kHeld[] = {{"ball", 2e-5, 0.0},        {"deep-groove-6205", 1.2e-4, 1e-5},
                          {"cylindrical", 0.0, 4e-5}, {"spherical", 5e-5, 5e-5},
                          {"tapered", 4e-5, 0.0},     {"spherical-tapered", 4e-5, 0.0}};

}  // namespace

TEST_CASE("datum: inner ring and shaft warm → held preload rises (study of the manual)",
          "[physics][datum]") {
  Sets sets{{"rpm2", "0.0"}, {"appLoadZ", "0.0"}, {"appLoadX", "200.0"}};
  const auto preload = statics::solve_ball_statics(thermal::operating_bearing(built("ball", sets)));
  CHECK(preload.displacement[0] == Approx(5.0307e-6).epsilon(1e-4));
  sets.insert(sets.end(), {{"kFS1", "1"}, {"appDispX", "5.0307e-6"}});
  Bearing b = built("ball", sets);
  CHECK(solve(b).race.load[0] == Approx(200.0).epsilon(1e-4));
  warm(b, bearing::kInner, 40.0);
  CHECK(solve(b).race.load[0] == Approx(2567.0).epsilon(0.01));  // an independent solver
}

TEST_CASE("datum: 30208, growth loads held cones like the equal displacement", "[physics][datum]") {
  const Sets sets{{"rpm2", "0.0"},     {"kFS1", "1"},       {"kFS3", "1"},
                  {"appLoadX", "0.0"}, {"appLoadZ", "0.0"}, {"appDispX", "15e-6"}};
  const Bearing cold = built("tapered-30208", sets);
  CHECK(solve(cold).race.load[0] == Approx(2790.0).epsilon(0.005));
  Bearing b = cold;
  warm(b, bearing::kInner, 60.0);
  const Bearing operating = thermal::operating_bearing(b);
  const double lost = *operating.operating->axial_setting;
  CHECK(lost == Approx(72.5e-6).epsilon(0.01));
  const double force = solve(b).race.load[0];
  CHECK(force == Approx(20100.0).epsilon(0.03));
  Bearing further = cold;
  further.constraints.displacement[0] += lost;
  CHECK(force == Approx(solve(further).race.load[0]).epsilon(0.03));
  Bearing open = cold;
  warm(open, bearing::kOuter, 60.0);
  CHECK(std::abs(solve(open).race.load[0]) < 1e-6);
}

TEST_CASE("datum: growth by u = displacement by u, all types, both races", "[physics][datum]") {
  for (const Case& c : kHeld)
    for (int race = 0; race < 2; ++race) {
      INFO(c.type << ", race " << race);
      Bearing grown = held(c.type, c.x, c.z);
      grown.mounting.fit[static_cast<std::size_t>(race)] = 1.5e-5;
      const Bearing operating = thermal::operating_bearing(grown);
      const double u = operating.operating->raceway[static_cast<std::size_t>(race)].total();
      REQUIRE(std::abs(u) > 2e-6);
      REQUIRE((race == 0) == (u < 0.0));
      const Found by_growth = solve(grown);
      const Found by_displacement = solve(held(c.type, c.x, c.z + std::abs(u)));
      const Found before = solve(held(c.type, c.x, c.z));
      REQUIRE(by_displacement.first[0] > 1.05 * before.first[0]);
      for (std::size_t j = 0; j < 2; ++j)
        CHECK(by_growth.first[j] == Approx(by_displacement.first[j]).epsilon(2e-3));
    }
}

TEST_CASE("datum: warm inner ring → held races loaded, warm outer ring → unloaded, all types",
          "[physics][datum]") {
  for (const Case& c : kHeld) {
    INFO(c.type);
    const Bearing cold = held(c.type, c.x, c.z);
    Bearing inner = cold, outer = cold, balls = cold;
    warm(inner, bearing::kInner, 20.0);
    warm(outer, bearing::kOuter, 20.0);
    balls.element_temperature += 20.0;
    const double before = solve(cold).first[0];
    CHECK(before > 0.0);
    CHECK(solve(inner).first[0] > 1.05 * before);
    CHECK(solve(outer).first[0] < 0.95 * before);
    CHECK(solve(balls).first[0] > before);
  }
}

TEST_CASE("datum: one temperature of all parts → roller bearings unchanged", "[physics][datum]") {
  for (const Case& c : kHeld) {
    const Bearing cold = held(c.type, c.x, c.z);
    if (!cold.rollers()) continue;
    INFO(c.type);
    Bearing b = cold;
    const double kelvin = 60.0;
    warm(b, bearing::kOuter, kelvin);
    warm(b, bearing::kInner, kelvin);
    b.element_temperature += kelvin;
    b.cage_temperature += kelvin;
    b.element_material = b.mounting.shaft = b.mounting.housing = b.race_material[1] =
        b.race_material[0];
    // Everything grows by g, the given displacement does not: loads fall by a few g.
    const double g = bearing::thermal_growth(b.element_material, b.element_temperature,
                                             b.room_temperature, false);
    REQUIRE(g > 5e-4);
    CHECK(solve(b).first[0] == Approx(solve(cold).first[0]).epsilon(10.0 * g));
  }
}

TEST_CASE("datum: balls given by their clearance → measured from opposed grooves",
          "[physics][datum]") {
  const Bearing middle = held("deep-groove-6205", 0.0, 3e-5);
  CHECK(solve(middle).race.load[0] == Approx(0.0).margin(1e-6));
  CHECK(solve(middle).race.load[2] > 100.0);
  const double right = solve(held("deep-groove-6205", 2e-4, 0.0)).race.load[0];
  CHECK(right > 10.0);
  CHECK(solve(held("deep-groove-6205", -2e-4, 0.0)).race.load[0] == Approx(-right));
  // Warm, too: the datum is the bench's.
  Bearing b = middle;
  warm(b, bearing::kInner, 20.0);
  CHECK(solve(b).race.load[0] == Approx(0.0).margin(1e-6));
}

TEST_CASE("datum: depends only on the deck's geometry", "[physics][datum]") {
  for (const Case& c : kHeld) {
    INFO(c.type);
    const Bearing cold = held(c.type, c.x, c.z);
    Bearing b = cold;
    warm(b, bearing::kInner, 50.0);
    b.mounting.fit = {1e-5, 2e-5};
    b.speed = {0.0, 800.0};
    const Bearing operating = thermal::operating_bearing(b);
    if (!b.rollers()) {
      CHECK(contact::groove_geometry(operating.balls()).centre_x ==
            contact::groove_geometry(cold.balls()).centre_x);
      continue;
    }
    const auto bench = statics::race_surfaces(cold);
    const auto free_again = statics::bench_races(b.type, operating.rollers()->unmounted_geometry());
    const auto grown = statics::race_surfaces(operating);
    for (std::size_t j = 0; j < 2; ++j) {
      CHECK(free_again[j].radius == bench[j].radius);
      CHECK(free_again[j].groove_x == bench[j].groove_x);
      CHECK(free_again[j].groove_centre_radius == bench[j].groove_centre_radius);
      CHECK(grown[j].mid_r - bench[j].mid_r ==
            Approx(operating.operating->raceway[j].total()).epsilon(1e-9));
    }
  }
}

TEST_CASE("datum: RESULTS.h5 has the race centers at zero displacement", "[unit][datum]") {
  const Bearing b = thermal::operating_bearing(built("ball", {{"raceTemp2", "350.0"}}));
  const auto geometry = results::geometry_of(b);
  const double D = 0.0127, sine = std::sin(25.0 * std::numbers::pi / 180.0);
  CHECK(geometry.at("outer_race_free_x") == Approx(-0.020 * D * sine));
  CHECK(geometry.at("inner_race_free_x") == Approx(0.015 * D * sine));
}

TEST_CASE("datum: dynamic run → held races carry the warm preload", "[physics][datum]") {
  const auto axial = [](const char* mode, const char* inner) {
    runs::DeckRequest request;
    request.deck = adore::test::source_dir() / "resources/decks/ball.txt";
    request.sets = {{"mode", mode},       {"rpm2", "1000.0"}, {"appLoadZ", "0.0"},
                    {"kFS1", "1"},        {"kFS3", "1"},      {"appDispX", "5.0307e-6"},
                    {"raceTemp2", inner}, {"shftTemp", inner}};
    const runs::Prepared p = runs::prepare(request);
    if (!p.control.dynamic) return p.statics.load[0];
    dynamics::System system = runs::make_system(p);
    const scene::Snapshot now = system.snapshot(0.0, system.initial_state());
    // Traction, which the statics leave out, carries up to a few parts in a thousand.
    CHECK(now.races[1].applied_force.x() == Approx(p.start.load[0]).epsilon(5e-3));
    CHECK(now.races[1].position.x() == Approx(5.0307e-6));
    return p.start.load[0];
  };
  const double cold = axial("0", "293.15"), warm = axial("0", "333.15");
  CHECK(warm > 8.0 * cold);
  CHECK(warm == Approx(axial("-1", "333.15")).epsilon(1e-3));  // but for the leaning of the loads
}
