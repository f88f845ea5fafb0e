#include "deck/templates.hpp"
#include "setup/build_bearing.hpp"
#include "thermal/steady_state.hpp"
#include "thermal/time_line.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace adore;

namespace {

constexpr int kNoBase = static_cast<int>(thermal::BaseNode::None);

using Settings = std::vector<std::pair<std::string, std::string>>;

/// A template with a thermal analysis, no coolant, the given place at room temperature.
/// @param base BaseNode::None: ambient only
bearing::Bearing warm(const std::string& type, int base, const Settings& settings = {}) {
  deck::Deck deck = deck::new_deck(type);
  Settings all{{"mode", "-1"},       {"kTherm", "1"},
               {"kCoolant", "0"},    {"kBaseTemp", std::to_string(base)},
               {"kHTC", "0"},        {"kGeoMod", "1"},
               {"kMatPropMod", "0"}, {"baseTemp", "293.15"},
               {"aveTime", "1e-3"},  {"skipTime", "0"}};
  all.insert(all.end(), settings.begin(), settings.end());
  for (int pass = 0; pass < 2; ++pass) {  // some settings ask for records that others fill
    for (const auto& [name, value] : all)
      if (deck.has(name)) deck.set(name, value);
    deck.complete();
  }
  bearing::Bearing out = setup::build_bearing(deck);
  out.thermal->base = base;
  return out;
}

Settings in_oil(const std::string& code) {
  return {{"kTrac", code}, {"reRaceFilm", "1e-8"}, {"strParam", "10"}};
}

double difference(const thermal::SteadyState& steady) {
  return steady.heat.bulk.race[1] - steady.heat.bulk.race[0];
}

/// 6208: nine balls, C3 clearance, 2 kN radial, mineral oil without flow.
Settings deep_groove(const std::string& rpm) {
  Settings out = in_oil("1");
  for (const auto& [name, value] : Settings{{"freeConAng", "0"},
                                            {"freeIntCls", "2.5e-5"},
                                            {"nRe", "9"},
                                            {"appLoadX", "0"},
                                            {"appLoadZ", "2000"},
                                            {"rpm2", rpm}})
    out.emplace_back(name, value);
  return out;
}

}  // namespace

TEST_CASE(
    "steady state: 6208 in mineral oil, air around housing and shaft → inner ring 5 to 15 K "
    "hotter",
    "[physics][thermal]") {
  for (const char* rpm : {"3000", "5000", "7000"}) {
    INFO(rpm << " rpm");
    const thermal::SteadyState steady =
        thermal::solve_steady_state(warm("ball", kNoBase, deep_groove(rpm)));
    CHECK(difference(steady) > 5.0);
    CHECK(difference(steady) < 15.0);
    CHECK(steady.heat.bulk.race[0] > 300.0);
    CHECK(steady.heat.bulk.race[0] < 360.0);
  }
}

TEST_CASE(
    "steady state: ten runs with a cooled housing → inner ring 0 to 25 K hotter; with a cooled "
    "shaft → the outer one; slow → no difference",
    "[physics][thermal]") {
  std::mt19937 random(17);
  const auto between = [&](double low, double high) {
    return std::to_string(std::uniform_real_distribution<double>(low, high)(random));
  };
  const char* types[] = {"ball", "cylindrical", "tapered", "spherical-tapered", "ball"};
  for (int run = 0; run < 10; ++run) {
    const std::string type = types[run % 5];
    Settings settings{{"rpm2", between(500.0, 6000.0)}, {"appLoadZ", between(300.0, 3000.0)}};
    if (run >= 5)
      for (const auto& one : in_oil(run % 2 == 0 ? "4" : "1")) settings.push_back(one);
    INFO(type << ", run " << run << ", " << settings[0].second << " rpm, " << settings[1].second
              << " N");
    const auto cooled = [&](std::size_t place) {
      bearing::Bearing b = warm(type, kNoBase, settings);
      b.thermal->surroundings.conductance[1 - place] = 0.0;
      return thermal::solve_steady_state(b);
    };
    const thermal::SteadyState housing = cooled(0), shaft = cooled(1);
    CHECK(difference(housing) > 0.0);
    CHECK(difference(housing) < 25.0);
    CHECK(difference(shaft) < 0.0);
    for (const thermal::SteadyState* one : {&housing, &shaft}) {
      double left = 0.0;
      for (const thermal::NodeFlow& flow : one->heat.leaving) left += flow.heat;
      CHECK(left == Approx(one->friction.power()).epsilon(1e-6));
      for (const thermal::NodeTemperature& node : one->heat.nodes)
        CHECK(node.temperature >= 293.15 - 1e-9);
    }
    // The place of kBaseTemp at room temperature instead of ambient.
    CHECK(difference(thermal::solve_steady_state(warm(type, 1, settings))) > 0.0);
    CHECK(difference(thermal::solve_steady_state(warm(type, 5, settings))) < 0.0);
    settings[0].second = "0.01";
    CHECK(std::abs(difference(cooled(0))) < 0.05);
  }
}

TEST_CASE("steady state: three start temperatures → one result", "[physics][thermal]") {
  for (const char* type : {"ball", "cylindrical"}) {
    std::vector<thermal::BulkTemperatures> found;
    for (const double start : {260.0, 293.15, 370.0}) {
      bearing::Bearing b = warm(type, 1, in_oil("4"));
      thermal::BulkTemperatures{{start, start}, start, start, start, start, start}.set(b);
      found.push_back(thermal::solve_steady_state(b).heat.bulk);
    }
    for (const thermal::BulkTemperatures& one : found) {
      const auto a = one.list(), first = found.front().list();
      for (std::size_t k = 0; k < a.size(); ++k) CHECK(a[k] == Approx(first[k]).margin(0.1));
    }
  }
}

TEST_CASE(
    "time line: ends in the steady state, closes its balance, and does not depend on its step",
    "[physics][thermal]") {
  const bearing::Bearing b = warm("ball", kNoBase, deep_groove("3000"));
  const thermal::ThermalTransient line = thermal::solve_thermal_transient(b),
                                  fine = thermal::solve_thermal_transient(b, {}, {}, 0.5);
  REQUIRE(line.settled);
  REQUIRE(fine.settled);
  const thermal::SteadyState steady = thermal::solve_steady_state(b);
  CHECK(line.points.back().bulk.race[1] == Approx(steady.heat.bulk.race[1]).margin(0.3));
  CHECK(line.points.back().time > 100.0);
  CHECK(line.points.front().time == 0.0);
  // Temperature of the inner race after 300 s, by linear interpolation.
  const auto at = [](const thermal::ThermalTransient& of) {
    for (std::size_t i = 1; i < of.points.size(); ++i)
      if (of.points[i].time >= 300.0) {
        const thermal::ThermalTransientPoint &from = of.points[i - 1], &to = of.points[i];
        return from.bulk.race[1] +
               (to.bulk.race[1] - from.bulk.race[1]) * (300.0 - from.time) / (to.time - from.time);
      }
    return 0.0;
  };
  CHECK(at(line) == Approx(at(fine)).margin(0.5));
}
