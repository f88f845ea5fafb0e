#include "base/errors.hpp"
#include "deck/reader.hpp"
#include "setup/build_bearing.hpp"
#include "statics/ball_statics.hpp"
#include "support/paths.hpp"
#include "thermal/bearing_heat.hpp"
#include "thermal/operating.hpp"
#include "thermal/relaxation.hpp"
#include "thermal/steady_state.hpp"
#include "tribology/fluid.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace adore;
using bearing::Bearing;
using thermal::BearingHeat;
using thermal::HeatSources;

namespace {

Bearing example(const std::string& name = "ball") {
  const deck::ReadResult read =
      deck::read_deck(adore::test::source_dir().string() + "/resources/decks/" + name + ".txt");
  REQUIRE(read.ok());
  Bearing b = setup::build_bearing(read.deck);
  b.envelope.shaft_bore = 0.3 * b.envelope.bore;
  b.envelope.housing_diameter = 1.5 * b.envelope.outer_diameter;
  b.thermal = bearing::ThermalInputs{};
  b.thermal->coolant = 1;
  b.thermal->base = 3;
  b.thermal->base_temperature = 320.0;
  b.thermal->flow = 1e-5;
  b.thermal->geometry_every = 1;
  b.lubrication = bearing::Lubrication{1, 1e-8, 10.0, {}};
  return b;
}

const HeatSources kHeat{{60.0, 80.0}, {3.0, 0.0}, {0.0, 0.0}, 5.0, 20.0};

}  // namespace

TEST_CASE("network: no heat, coolant and room at one temperature → all parts have it",
          "[physics][thermal]") {
  for (const int coolant : {0, 1, 14}) {
    Bearing b = example();
    b.room_temperature = 320.0;
    b.thermal->coolant = coolant;
    if (coolant == 0) b.thermal->base = 0;
    const BearingHeat heat = thermal::solve_bearing_heat(b, {}, 400.0);
    for (const double T : heat.bulk.list()) CHECK(T == Approx(320.0).epsilon(1e-14));
    CHECK(heat.temperature.coolant_out == Approx(320.0).epsilon(1e-14));
    CHECK(std::abs(heat.imbalance()) < 1e-9);
  }
}

/// The same with the manual's ladder.
Bearing with_ladder(Bearing b) {
  b.thermal->model = bearing::ThermalModel::Ladder;
  return b;
}

TEST_CASE("ladder: any coolant and base → all heat leaves, base temperature is met",
          "[physics][thermal]") {
  for (const int coolant : {0, 1, 2, 3, 5, 13, 14})
    for (const int base : {0, 1, 2, 3, 4, 5}) {
      if (coolant == 0 && (base == 2 || base == 3)) continue;
      INFO("kCoolant " << coolant << ", kBaseTemp " << base);
      Bearing b = with_ladder(example());
      b.thermal->coolant = coolant;
      b.thermal->base = base;
      b.thermal->base_temperature = coolant == 3 ? 95.0 : coolant == 5 ? 80.0 : 320.0;
      b.room_temperature = 60.0;  // colder than all: the guard does not act
      b.thermal->density = 900.0;
      b.thermal->viscosity = 0.01;
      b.thermal->specific_heat = 2000.0;
      b.thermal->conductivity = 0.14;
      if (coolant == 13) b.thermal->flow = 1e-2;
      const BearingHeat heat = thermal::solve_bearing_heat(b, kHeat, 400.0);
      CHECK(std::abs(heat.imbalance()) < 1e-10 * kHeat.total());
      const thermal::NetworkTemperatures& T = heat.temperature;
      const double at_base[] = {T.outer_interface, T.housing,         T.coolant_out,
                                T.coolant_in,      T.inner_interface, T.shaft};
      CHECK(at_base[base] == Approx(b.thermal->base_temperature).epsilon(1e-12));
      // Heat runs down: races and elements above the coolant, housing and shaft below the races.
      CHECK(T.element >= T.coolant_mean);
      CHECK(T.cage >= T.coolant_mean);
      CHECK(T.housing < T.outer_raceway);
      CHECK(T.shaft < T.inner_raceway);
      if (coolant == 0) continue;
      REQUIRE(heat.coolant);
      // The coolant warms by what it takes.
      CHECK((T.coolant_out - T.coolant_in) * heat.coolant->mass_flow *
                heat.coolant->specific_heat ==
            Approx(heat.flows.coolant).epsilon(1e-9));
    }
}

TEST_CASE("ladder: solid or hollow shaft → no node is colder than the coldest given temperature",
          "[physics][thermal]") {
  int guarded = 0;
  for (const double bore : {0.0, 0.5})
    for (const int coolant : {0, 1, 2, 3, 5, 13, 14})
      for (const int base : {0, 1, 2, 3, 4, 5})
        for (const double heat_share : {0.01, 1.0, 5.0}) {
          if (coolant == 0 && (base == 2 || base == 3)) continue;
          INFO("kCoolant " << coolant << ", kBaseTemp " << base << ", heat x " << heat_share);
          Bearing b = with_ladder(example());
          b.envelope.shaft_bore = bore * b.envelope.bore;
          b.thermal->coolant = coolant;
          b.thermal->base = base;
          b.thermal->base_temperature = coolant == 3 ? 95.0 : coolant == 5 ? 80.0 : 320.0;
          b.thermal->density = 900.0;
          b.thermal->viscosity = 0.01;
          b.thermal->specific_heat = 2000.0;
          b.thermal->conductivity = 0.14;
          if (coolant == 13) b.thermal->flow = 1e-2;
          HeatSources sources = kHeat;
          for (double* q : {&sources.race[0], &sources.race[1], &sources.land[0],
                            &sources.element_cage, &sources.churning})
            *q *= heat_share;
          const BearingHeat heat = thermal::solve_bearing_heat(b, sources, 400.0);
          const thermal::NetworkTemperatures& T = heat.temperature;
          const double base_and_room = std::min(b.thermal->base_temperature, b.room_temperature),
                       coldest =
                           heat.coolant ? std::min(base_and_room, T.coolant_in) : base_and_room;
          for (const double node : {T.element, T.cage, T.inner_raceway, T.inner_interface, T.shaft,
                                    T.outer_raceway, T.outer_interface, T.housing})
            CHECK(node >= coldest - 1e-6);
          CHECK(std::abs(heat.imbalance()) < 1e-10 * sources.total());
          const bool acted = heat.clamped || heat.turned_back[0] + heat.turned_back[1] > 0.0;
          bool noted = false;
          for (const adore::Finding& note : heat.notes)
            noted = noted || note.code == "thermal.ladder";
          CHECK(noted == acted);
          if (acted) ++guarded;
        }
  CHECK(guarded > 5);
}

TEST_CASE("network: any coolant, base, shaft and heat → balance, maximum principle, base is met",
          "[physics][thermal]") {
  std::mt19937 random(5);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (const char* type : {"ball", "cylindrical", "tapered"})
    for (const int coolant : {0, 1, 2, 3, 5, 13, 14})
      for (const int base : {0, 1, 2, 3, 4, 5})
        for (int trial = 0; trial < 4; ++trial) {
          if (coolant == 0 && (base == 2 || base == 3)) continue;
          INFO(type << ", kCoolant " << coolant << ", kBaseTemp " << base << ", trial " << trial);
          Bearing b = example(type);
          b.envelope.shaft_bore = trial % 2 == 0 ? 0.0 : between(0.1, 0.8) * b.envelope.bore;
          b.thermal->coolant = coolant;
          b.thermal->base = base;
          b.thermal->base_temperature = coolant == 3   ? 95.0
                                        : coolant == 5 ? 80.0
                                                       : between(280.0, 360.0);
          b.thermal->density = 900.0;
          b.thermal->viscosity = 0.01;
          b.thermal->specific_heat = 2000.0;
          b.thermal->conductivity = 0.14;
          if (coolant == 13) b.thermal->flow = 1e-2;
          b.mounting.fit = {between(-3e-5, 3e-5), between(-3e-5, 3e-5)};
          HeatSources sources;
          const double size = std::pow(10.0, between(-2.0, 2.0));
          for (double* q : {&sources.race[0], &sources.race[1], &sources.land[0],
                            &sources.flange[1], &sources.element_cage, &sources.churning})
            *q = size * between(0.0, 1.0);
          const BearingHeat heat = thermal::solve_bearing_heat(b, sources, between(0.0, 2000.0));
          const thermal::NetworkTemperatures& T = heat.temperature;
          const double at_base[] = {T.outer_interface, T.housing,         T.coolant_out,
                                    T.coolant_in,      T.inner_interface, T.shaft};
          CHECK(at_base[base] == Approx(b.thermal->base_temperature).epsilon(1e-9));
          double left = 0.0;
          for (const thermal::NodeFlow& one : heat.leaving) left += one.heat;
          CHECK(left == Approx(sources.total()).margin(1e-8 + 1e-6 * sources.total()));
          CHECK(std::abs(heat.imbalance()) < 1e-7 * sources.total() + 1e-7);
          double coldest = std::min(b.thermal->base_temperature, b.room_temperature);
          if (coolant >= 3 && coolant <= 7) coldest = b.thermal->base_temperature;
          if (base == 2) coldest = std::min(coldest, T.coolant_in);
          for (const thermal::NodeTemperature& node : heat.nodes) {
            INFO(node.name);
            if (node.name != "ambient") CHECK(node.temperature >= coldest - 1e-9);
          }
        }
}

TEST_CASE(
    "network: housing cooled → inner ring is the hotter one; shaft cooled → the outer ring; "
    "no heat → no difference",
    "[physics][thermal]") {
  for (const char* type : {"ball", "cylindrical", "tapered", "spherical"}) {
    INFO(type);
    const auto difference = [&](int base, double share) {
      Bearing b = example(type);
      b.thermal->coolant = 0;
      b.thermal->base = base;
      b.thermal->base_temperature = b.room_temperature;
      // Nothing but the base cools.
      b.thermal->surroundings.conductance = {0.0, 0.0};
      HeatSources q;
      q.race = {20.0 * share, 25.0 * share};
      const BearingHeat heat = thermal::solve_bearing_heat(b, q, 0.4 * b.speed[1]);
      return heat.bulk.race[1] - heat.bulk.race[0];
    };
    CHECK(difference(1, 1.0) > 0.0);
    CHECK(difference(5, 1.0) < 0.0);
    CHECK(std::abs(difference(1, 1e-6)) < 1e-3 * difference(1, 1.0));
    CHECK(difference(1, 0.0) == Approx(0.0).margin(1e-9));
  }
}

TEST_CASE("cryogenic coolants: coolant temperature kept, extrapolation reported",
          "[physics][thermal]") {
  Bearing b = example();
  b.thermal->coolant = 4;  // hydrogen
  b.thermal->base_temperature = 22.0;
  b.thermal->flow = 1e-3;
  const BearingHeat cold = thermal::solve_bearing_heat(b, kHeat, 3000.0);
  for (const adore::Finding& note : cold.notes) CHECK(note.code != "thermal.coolant_range");
  CHECK(cold.temperature.coolant_in == Approx(22.0));
  CHECK(cold.bulk.element < 60.0);
  CHECK(cold.coolant->provenance == tribology::fluid_properties(4, 22.0).provenance);
  b.thermal->base_temperature = 300.0;  // no liquid any more
  const BearingHeat warm = thermal::solve_bearing_heat(b, kHeat, 3000.0);
  REQUIRE_FALSE(warm.notes.empty());
  CHECK_THAT(warm.notes.front().message,
             Catch::Contains("the properties at the nearer limit are used"));
  CHECK(warm.notes.front().code == "thermal.coolant_range");
  CHECK(warm.notes.front().measured.value_or(0.0) > warm.notes.front().limit.value_or(1e9));
}

TEST_CASE("network: hollow shaft, oil at 330 K, room at 293 K → no node below the room",
          "[physics][thermal]") {
  Bearing b = example();
  b.envelope.shaft_bore = 0.02;
  b.thermal->base_temperature = 330.0;
  b.thermal->flow = 3e-5;
  b.lubrication = bearing::Lubrication{4, 1e-8, 10.0, {}};
  const thermal::SteadyState steady = thermal::solve_steady_state(b);
  for (const thermal::NodeTemperature& node : steady.heat.nodes)
    CHECK(node.temperature >= 293.15 - 1e-9);
  CHECK(steady.heat.temperature.shaft > 300.0);
}

TEST_CASE("coolant without heat capacity → error with the variables to change", "[unit][thermal]") {
  Bearing b = example();
  b.thermal->convection_given = true;
  CHECK_THROWS_WITH(thermal::solve_bearing_heat(b, kHeat, 400.0),
                    Catch::Contains("reHTC") && Catch::Contains("cageHTC"));
  b = example();
  b.mounting.shaft.conductivity = 0.0;
  CHECK_THROWS_WITH(thermal::solve_bearing_heat(b, kHeat, 400.0), Catch::Contains("shftTC"));
}

TEST_CASE("steady state: fixed point of temperatures, loads, friction and heat",
          "[physics][thermal]") {
  for (const char* name : {"ball", "cylindrical", "tapered"}) {
    INFO(name);
    const Bearing b = example(name);
    const thermal::SteadyState steady = thermal::solve_steady_state(b);
    CHECK(steady.change < 0.01);
    CHECK(steady.friction.power() > 0.0);
    CHECK(steady.heat.sources.total() == Approx(steady.friction.power()).epsilon(1e-12));
    CHECK(std::abs(steady.heat.imbalance()) < 1e-9 * steady.friction.power());
    CHECK(steady.heat.bulk.element > b.thermal->base_temperature);
    CHECK(steady.gain < 1.0);
    // Once more from what it found.
    const thermal::SteadyState again = thermal::solve_steady_state(steady.as_built);
    CHECK(again.passes <= 2);
    const auto first = steady.heat.bulk.list(), second = again.heat.bulk.list();
    for (std::size_t k = 0; k < first.size(); ++k)
      CHECK(second[k] == Approx(first[k]).margin(0.03));
    // The geometry is that of these temperatures.
    CHECK(steady.operating.race_temperature[1] == steady.as_built.race_temperature[1]);
  }
}

TEST_CASE("steady state: more flow → colder, more load → hotter; standstill → coolant temperature",
          "[physics][thermal]") {
  Bearing b = example();
  const double one = thermal::solve_steady_state(b).heat.bulk.element;
  b.thermal->flow *= 5.0;
  CHECK(thermal::solve_steady_state(b).heat.bulk.element < one);
  b = example();
  for (double& load : b.constraints.load) load *= 3.0;
  CHECK(thermal::solve_steady_state(b).heat.bulk.element > one);
  b = example();
  b.speed = {0.0, 0.0};
  b.thermal->surroundings.ambient = 320.0;
  const thermal::SteadyState rest = thermal::solve_steady_state(b);
  CHECK(rest.friction.power() == 0.0);
  for (const double T : rest.heat.bulk.list()) CHECK(T == Approx(320.0).epsilon(1e-12));
}

TEST_CASE("steady state: fixed geometry → only the oil follows the temperatures",
          "[physics][thermal]") {
  Bearing b = example();
  b.thermal->geometry_every = 0;
  const thermal::SteadyState fixed = thermal::solve_steady_state(b);
  const Bearing cold = thermal::operating_bearing(b);
  CHECK(fixed.operating.balls().clearance == cold.balls().clearance);
  CHECK(fixed.operating.element_temperature > b.element_temperature);
}

TEST_CASE("steady state: clamped bearing without heat path → runaway, with a message",
          "[physics][thermal]") {
  // Stiff housing held cold, a hot inner ring: the clearance is lost with every kelvin.
  Bearing b = example("cylindrical");
  b.thermal->coolant = 0;
  b.thermal->base = 1;  // housing outside
  b.thermal->base_temperature = 293.15;
  b.lubrication.reset();
  b.race_traction = {bearing::TractionCurve::Form::Exponential, 0.0, 0.0, 0.0, 0.5, 0.0};
  b.mounting.fit = {2e-5, 6e-5};
  b.speed[1] *= 20.0;
  CHECK_THROWS_WITH(thermal::solve_steady_state(b),
                    Catch::Contains("thermal analysis: no steady state") &&
                        Catch::Contains("Increase the coolant flow"));
}

TEST_CASE("network: rings end at the groove bottoms, as in the fits", "[physics][thermal]") {
  for (const double degrees : {0.0, 15.0, 40.0}) {
    Bearing b = example();
    b.balls().contact_angle = degrees * std::acos(-1.0) / 180.0;
    if (degrees == 0.0) b.balls().clearance = 4e-5;
    const BearingHeat heat = thermal::solve_bearing_heat(b, kHeat, 400.0);
    const Bearing operating = thermal::operating_bearing(b);
    REQUIRE(operating.operating);
    CHECK(heat.rings.outer.inner == Approx(operating.operating->raceway_radius[0]).epsilon(1e-14));
    CHECK(heat.rings.inner.outer == Approx(operating.operating->raceway_radius[1]).epsilon(1e-14));
  }
}

TEST_CASE("steady state: no node below absolute zero, for any data and any small flow",
          "[physics][thermal]") {
  int found = 0, refused = 0;
  constexpr int kAir = 13, kWater = 14;
  for (const auto& [coolant, base] : {std::pair{example().thermal->coolant, 0},
                                      {example().thermal->coolant, 1},
                                      {example().thermal->coolant, 2},
                                      {example().thermal->coolant, 3},
                                      {example().thermal->coolant, 4},
                                      {example().thermal->coolant, 5},
                                      {kAir, 0},
                                      {kAir, 2},
                                      {kAir, 5},
                                      {kWater, 0}})
    for (const double flow : {1e-9, 1e-8, 1e-7, 1e-6, 1e-5}) {
      INFO("kCoolant " << coolant << ", kBaseTemp " << base << ", cFlowRate " << flow);
      Bearing b = example();
      b.thermal->coolant = coolant;
      b.thermal->base = base;
      b.thermal->flow = flow;
      try {
        const thermal::SteadyState steady = thermal::solve_steady_state(b);
        ++found;
        const thermal::NetworkTemperatures& T = steady.heat.temperature;
        for (const double node :
             {T.coolant_in, T.coolant_mean, T.coolant_out, T.element, T.cage, T.outer_raceway,
              T.outer_interface, T.housing, T.inner_raceway, T.inner_interface, T.shaft})
          CHECK(node > 0.0);
      } catch (const SolverError& error) {
        ++refused;
        CHECK_THAT(error.what(), Catch::Contains("Increase the coolant flow (cFlowRate)"));
      }
    }
  CHECK(found > 0);
  CHECK(refused > 0);
}

TEST_CASE("relaxation: fluctuating heat → the mean; heat that falls steeply → the root",
          "[unit][thermal]") {
  using Field = thermal::Relaxation::Field;
  const auto run = [](bool averages, double gain, double amplitude) {
    thermal::Relaxation relaxation;
    relaxation.least = 0.02;
    relaxation.most = 1.0;
    relaxation.averages = averages;
    Field at;
    at.fill(320.0);
    double largest = 0.0;  // departure over the last period
    constexpr int kPeriod = 12, kSteps = 300;
    for (int n = 0; n < kSteps; ++n) {
      Field found;
      found.fill(300.0 + gain * (at[0] - 300.0) +
                 amplitude * std::cos(2.0 * std::numbers::pi * n / kPeriod));
      at = relaxation.step(at, found);
      if (n >= kSteps - kPeriod) largest = std::max(largest, std::abs(at[0] - 300.0));
    }
    return largest;
  };
  CHECK(run(true, -0.3, 20.0) < 2.0);
  CHECK(run(false, -0.3, 20.0) > 8.0);
  CHECK(run(true, -6.0, 0.0) < 0.01);
}

TEST_CASE(
    "describe_overheated_node(): film above 1000 K → its name, for any temperatures of the parts",
    "[unit][thermal]") {
  thermal::BearingHeat heat;
  heat.nodes = {{"outer raceway", 400.0}, {"film of the pockets", 2.8e5}, {"ambient", 293.0}};
  CHECK(thermal::describe_overheated_node(heat).find("film of the pockets") == 0);
  heat.nodes[1].temperature = 999.0;
  CHECK(thermal::describe_overheated_node(heat).empty());
}

TEST_CASE("network: pocket heat between bodies of low conductivity → a film out of range",
          "[physics][thermal]") {
  Bearing b = example();
  HeatSources sources;
  sources.element_cage = 500.0;
  b.cage->material.conductivity = 0.05;
  b.element_material.conductivity = 0.05;
  CHECK(thermal::describe_overheated_node(thermal::solve_bearing_heat(b, sources, 400.0))
            .find("film of the") == 0);
}
