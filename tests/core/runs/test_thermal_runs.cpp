#include "contact/groove.hpp"
#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "dynamics/effect_catalogue.hpp"
#include "results/results_h5.hpp"
#include "results/sol_file.hpp"
#include "results/static_tables.hpp"
#include "runs/thermal_run.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

using namespace adore;
using namespace adore::testing;
namespace fs = std::filesystem;

namespace {

fs::path folder(const std::string& name) {
  const fs::path out = fs::temp_directory_path() / ("adore_thermal_" + name);
  fs::remove_all(out);
  return out;
}

/// An example with the thermal analysis switched on: oil through the bearing, 320 K at its inlet.
deck::Deck warm(const std::string& name, const char* mode) {
  deck::Deck deck = deck::new_deck(name);
  deck.set("mode", mode);
  deck.set("kTherm", "1");
  deck.complete();
  for (const auto& [variable, value] : {std::pair{"kCoolant", "14"},
                                        {"kBaseTemp", "3"},
                                        {"kHTC", "0"},
                                        {"kGeoMod", "1"},
                                        {"kMatPropMod", "0"},
                                        {"baseTemp", "320.0"},
                                        {"cFlowRate", "2.0e-5"},
                                        {"reHTC", "0.0"},
                                        {"cageHTC", "0.0"},
                                        {"aveTime", "2.0e-4"},
                                        {"skipTime", "0.0"}})
    deck.set(variable, value);
  deck.complete();
  return deck;
}

deck::Deck moving(const std::string& name) {
  deck::Deck deck = warm(name, "0");
  deck.set("maxStps", "400");
  deck.set("nStps", "10");
  deck.set("kPltFreq", "20");
  deck.set("kPrtFreq", "100");
  return deck;
}

}  // namespace

TEST_CASE("kTherm, quasi-static: temperatures, friction and their network are printed",
          "[physics][thermal]") {
  for (const char* name : {"ball", "cylindrical"}) {
    INFO(name);
    // Around it as warm as its coolant: nothing in it can be colder.
    const Ran ran = run_deck(warm(name, "-1"), folder(std::string("static_") + name), false,
                             {{"ambientTemperature", "320"}});
    CHECK(ran.outcome.status == runs::RunStatus::Done);
    CHECK_THAT(ran.print, Catch::Contains("THERMAL STEADY STATE") &&
                              Catch::Contains("FRICTION: ESTIMATE FROM THE EQUILIBRIUM") &&
                              Catch::Contains("coolant exit"));
    const auto& summary = ran.report.at("summary");
    const double power = summary.at("friction_power_W").get<double>();
    CHECK(power > 0.0);
    CHECK(summary.at("element_temperature_K").get<double>() > 320.0);
    CHECK(summary.at("coolant_exit_temperature_K").get<double>() > 320.0);
    for (const auto& value : ran.report.at("played_no_part"))
      CHECK(value.at("variable").get<std::string>() != "kTherm");
  }
}

TEST_CASE("kTherm, motion: warms by steps, closes its ledger and stores nine more values",
          "[physics][thermal]") {
  const fs::path where = folder("moving");
  const Ran ran = run_deck(moving("ball"), where);
  INFO(ran.outcome.message);
  CHECK(ran.outcome.status == runs::RunStatus::Done);
  CHECK_THAT(ran.print, Catch::Contains("THERMAL STEP"));
  CHECK_THAT(ran.print, Catch::Contains("changes of geometry and material by thermal steps"));
  const results::SolFile power = results::read_sol(where / "SOL7");
  CHECK(power.header.value_count == 26);
  const auto& first = power.steps.front().values;
  const auto& last = power.steps.back().values;
  constexpr std::size_t kElement = 13, kInlet = 17, kHeat = 22;  // values 14, 18 and 23
  CHECK(first[kElement] == Approx(293.15).margin(30.0));
  CHECK(last[kElement] > 320.0);
  CHECK(last[kInlet] == Approx(320.0).epsilon(1e-6));
  CHECK(last[kHeat] > 0.0);
  CHECK(std::abs(ran.outcome.energy_residual) < 1e-3 * ran.outcome.energy_scale);
}

TEST_CASE("RUN.json: network of a motion's last thermal step, with the values of SOL7",
          "[physics][thermal]") {
  const fs::path where = folder("network");
  deck::Deck deck = moving("ball");
  deck.set("maxStps", "150");
  REQUIRE(run_deck(deck, where).outcome.status == runs::RunStatus::Done);
  const results::StaticTables all = results::read_static_tables(where / "RUN.json");
  const results::StaticTable* network = all.find("thermal network");
  REQUIRE(network != nullptr);
  const auto& last = results::read_sol(where / "SOL7").steps.back().values;
  // Values 14 to 17, and those of the thermal step: coolant inlet and exit.
  for (const auto& [value, column] : {std::pair{14, "rolling elements"},
                                      {15, "mean of the outer race"},
                                      {16, "mean of the inner race"},
                                      {17, "cage"},
                                      {18, "coolant inlet"},
                                      {19, "coolant exit"}}) {
    INFO(value << " " << column);
    REQUIRE(network->find(column) != nullptr);
    // Temperatures of the bearing follow the mean of fluctuating heat.
    CHECK(last[static_cast<std::size_t>(value - 1)] ==
          Approx(network->find(column)->values.front()).margin(value < 18 ? 0.5 : 1e-4));
  }
  // Balance: what is made is what leaves.
  double made = 0.0, left = 0.0;
  for (const results::StaticColumn& column : network->columns) {
    if (column.name.rfind("made ", 0) == 0) made += column.values.front();
    if (column.name.rfind("leaves to ", 0) == 0) left += column.values.front();
  }
  CHECK(made > 0.0);
  CHECK(left == Approx(made).epsilon(1e-9));
}

TEST_CASE("RESULTS.h5: temperatures of rings, elements, cage, housing, shaft and films",
          "[physics][thermal]") {
  for (const bool ladder : {false, true}) {
    INFO("ladder " << ladder);
    const fs::path where = folder("h5_temperatures");
    deck::Deck deck = moving("ball");
    deck.set("maxStps", "150");
    deck.set("kPltFreq", "2");
    std::map<std::string, std::string> options;
    if (ladder) options["thermalModel"] = "ladder";
    REQUIRE(run_deck(deck, where, false, {options.begin(), options.end()}).outcome.status ==
            runs::RunStatus::Done);
    const results::StaticTables all = results::read_static_tables(where / "RUN.json");
    const results::StaticTable* network = all.find("thermal network");
    REQUIRE(network != nullptr);
    const results::H5Reader h5(where / "RESULTS.h5");
    for (const auto& [id, node] : {std::pair{"thermal.outer_film", "film of the outer race"},
                                   {"thermal.inner_film", "film of the inner race"},
                                   {"thermal.outer_raceway", "outer raceway"},
                                   {"thermal.inner_raceway", "inner raceway"}}) {
      INFO(id);
      REQUIRE(h5.find(id) != nullptr);
      CHECK(h5.find(id)->unit == "K");
      const std::vector<double> values = h5.read(id);
      const bool film = std::string(id).ends_with("film");
      CHECK(std::isnan(values.front()) == film);  // not computed before the first step
      if (film && ladder)
        CHECK(std::isnan(values.back()));
      else if (const results::StaticColumn* column = network->find(node))
        CHECK(values.back() == Approx(column->values.front()).margin(1e-9));
      else
        CHECK(ladder);
    }
    const double hottest = ladder ? 400.0 : h5.read("thermal.inner_film").back();
    for (const char* id :
         {"race.temperature", "power.element_temperature", "power.cage_temperature",
          "thermal.housing_mean", "thermal.shaft_mean", "thermal.medium"}) {
      INFO(id);
      REQUIRE(h5.find(id) != nullptr);
      for (const double kelvin : h5.read(id)) {
        CHECK(kelvin > 285.0);
        CHECK(kelvin < std::max(hottest, 321.0) + 5.0);
      }
    }
  }
}

TEST_CASE("thermal network: receives all heat of the ledger, from any source", "[unit][thermal]") {
  for (const char* type : {"ball", "cylindrical"}) {
    runs::LoadedDeck input;
    input.deck = moving(type);
    const runs::Prepared prepared = runs::prepare(std::move(input));
    runs::ThermalRun run(prepared);
    double each = 1.0, all = 0.0;
    scene::Snapshot at;
    run.start(0.0, at.energy);
    constexpr double kWindow = 2.0e-4;  // aveTime
    for (const scene::LedgerTerm* term : dynamics::energy_terms()) {
      if (term->kind != scene::LedgerKind::Heat) continue;
      for (int race = 0; race < (term->per_race() ? 2 : 1); ++race) {
        at.energy.add(*term, each * kWindow, race);
        all += each;
        each += 0.25;
      }
    }
    at.time = kWindow;
    CHECK(run.close(at, {}).heat.sources.total() == Approx(all).epsilon(1e-12));
  }
}

namespace {

/// Constant heat in halves to both races of `steps` windows. @return the inner race after each [K]
std::vector<double> warmed(runs::ThermalRun& run, const runs::Prepared& prepared, double window,
                           int steps, const std::function<double(int)>& power) {
  const scene::LedgerTerm* heat = nullptr;
  for (const scene::LedgerTerm* term : dynamics::energy_terms())
    if (term->id == "heat") heat = term;
  REQUIRE(heat != nullptr);
  scene::Snapshot at;
  run.start(0.0, at.energy);
  std::vector<double> out;
  for (int n = 1; n <= steps; ++n) {
    at.time = n * window;
    for (int race = 0; race < 2; ++race) at.energy.add(*heat, 0.5 * power(n) * window, race);
    (void)run.close(at, runs::race_conductance(prepared));
    out.push_back(run.bulk().race[1]);
  }
  return out;
}

runs::Prepared still_air(const char* type, const std::map<std::string, std::string>& options) {
  runs::LoadedDeck input;
  input.deck = moving(type);
  for (const auto& [name, value] :
       {std::pair{"kCoolant", "0"}, {"kBaseTemp", "0"}, {"kGeoMod", "0"}})
    input.deck.set(name, value);
  input.deck.complete();
  input.option_values = options;
  input.option_values["thermalBase"] = "none";
  return runs::prepare(std::move(input));
}

}  // namespace

TEST_CASE(
    "thermalTransient: a bearing that conducts well, little cooling → one capacity, "
    "T = T0 + Q/G (1 - exp(-G t/C))",
    "[physics][thermal]") {
  constexpr double kWindow = 2.0e-4, kConductance = 0.02, kHeat = 0.4;
  constexpr int kSteps = 120, kStepsOfTimeConstant = 40;
  for (const char* type : {"ball", "cylindrical"}) {
    INFO(type);
    const runs::Prepared at_rest = still_air(type, {});
    const bearing::Bearing& b = at_rest.as_built;
    const bearing::Envelope& e = b.envelope;
    const auto capacity = [](const bearing::Material& m, double inside, double outside,
                             double width) {
      return m.density * m.specific_heat * 0.25 * std::numbers::pi *
             (outside * outside - inside * inside) * width;
    };
    std::array<double, 2> raceway{};
    if (b.rollers()) {
      raceway = {b.rollers()->race_radius(0), b.rollers()->race_radius(1)};
    } else {
      const contact::GrooveGeometry g = contact::groove_geometry(b.balls());
      raceway = {g.centre_radius[0] + g.groove_radius[0], g.centre_radius[1] - g.groove_radius[1]};
    }
    const double C =
        capacity(b.race_material[0], 2.0 * raceway[0], e.outer_diameter, e.race_width[0]) +
        capacity(b.race_material[1], e.bore, 2.0 * raceway[1], e.race_width[1]) +
        capacity(b.mounting.housing, e.outer_diameter, e.housing_diameter, e.race_width[0]) +
        capacity(b.mounting.shaft, e.shaft_bore, e.bore, e.race_width[1]) +
        b.element_count() * b.element_inertia.mass * b.element_material.specific_heat +
        b.cage->inertia.mass * b.cage->material.specific_heat;
    const double step = C / kConductance / kStepsOfTimeConstant;
    const runs::Prepared prepared =
        still_air(type, {{"thermalTransient", "on"},
                         {"thermalAcceleration", std::to_string(step / kWindow)},
                         {"housingCooling", std::to_string(kConductance)},
                         {"shaftCooling", "0"}});
    runs::ThermalRun run(prepared);
    const std::vector<double> found =
        warmed(run, prepared, kWindow, kSteps, [](int) { return kHeat; });
    const double rise = kHeat / kConductance, start = b.race_temperature[1];
    for (const int n : {10, 40, 80, 120}) {
      INFO("step " << n);
      CHECK(
          found[static_cast<std::size_t>(n) - 1] - start ==
          Approx(rise * (1.0 - std::exp(-double(n) / kStepsOfTimeConstant))).margin(0.025 * rise));
    }
  }
}

TEST_CASE("thermalTransient: ends in the steady state of a run without it", "[physics][thermal]") {
  deck::Deck deck = moving("ball");
  deck.set("kCoolant", "0");
  deck.set("kBaseTemp", "0");
  deck.complete();
  deck.set("maxStps", "500");
  std::vector<double> inner;
  int count = 0;
  for (const Options& more :
       {Options{}, {{"thermalTransient", "on"}, {"thermalAcceleration", "1e6"}}}) {
    Options options{{"thermalBase", "none"}, {"shaftCooling", "0"}};
    options.insert(options.end(), more.begin(), more.end());
    const fs::path where = folder("transient" + std::to_string(count++));
    REQUIRE(run_deck(deck, where, false, options).outcome.status == runs::RunStatus::Done);
    inner.push_back(results::read_sol(where / "SOL7").steps.back().values[15]);
  }
  CHECK(inner[0] > 315.0);
  CHECK(inner[1] == Approx(inner[0]).margin(1.5));
}

TEST_CASE("heat that grows for four thermal steps → judged divergent, and the run continues",
          "[unit][thermal]") {
  const runs::Prepared prepared = still_air("ball", {});
  runs::ThermalRun run(prepared);
  std::vector<double> found;
  CHECK_NOTHROW(
      found = warmed(run, prepared, 2.0e-4, 9, [](int n) { return 5.0 * std::pow(1.25, n); }));
  CHECK(found.back() > found.front() + 4.0);
}

TEST_CASE("thermal steps: each variable acts", "[physics][thermal]") {
  struct Seen {
    int steps = 0, changes = 0;
    double first_change = 0.0, work = 0.0;
  };
  int count = 0;
  const auto seen = [&](std::initializer_list<std::pair<const char*, const char*>> sets) {
    deck::Deck deck = moving("ball");
    deck.set("maxStps", "500");
    for (const auto& [name, value] : sets) deck.set(name, value);
    const Ran ran = run_deck(deck, folder("acts" + std::to_string(++count)));
    REQUIRE(ran.outcome.status != runs::RunStatus::Failed);
    Seen out;
    const std::string change = "Geometry and material properties change with this step.";
    for (std::size_t at = ran.print.find("Step end"); at != std::string::npos;
         at = ran.print.find("Step end", at + 1)) {
      ++out.steps;
      const std::size_t next = ran.print.find("Step end", at + 1);
      const std::size_t found = ran.print.find(change, at);
      if (found == std::string::npos || found > next) continue;
      if (out.changes++ == 0) out.first_change = std::stod(ran.print.substr(at + 8));
    }
    const std::string label = "changes of geometry and material by thermal steps";
    const std::size_t at = ran.print.rfind(label);
    REQUIRE(at != std::string::npos);
    out.work = std::stod(ran.print.substr(at + label.size()));
    return out;
  };
  const Seen plain = seen({}), never = seen({{"kGeoMod", "0"}}), second = seen({{"kGeoMod", "2"}}),
             laws = seen({{"kMatPropMod", "1"}}), longer = seen({{"aveTime", "4.0e-4"}}),
             later = seen({{"skipTime", "1.0e-3"}});
  REQUIRE(plain.steps > 8);
  CHECK(plain.changes == plain.steps);
  CHECK(never.steps > 8);
  CHECK(never.changes == 0);
  CHECK(never.work == 0.0);
  CHECK(second.changes == second.steps / 2);
  CHECK(laws.changes == laws.steps);
  CHECK(std::abs(laws.work / plain.work - 1.0) > 1e-3);
  CHECK(2 * longer.steps <= plain.steps + 2);
  CHECK(longer.steps > 2);
  CHECK(later.changes > 0);
  CHECK(later.changes < later.steps);
  CHECK(later.first_change >= 1.0e-3 * (1.0 - 1e-9));
  CHECK(plain.first_change < 3e-4);
}

TEST_CASE("thermal steps of every kind: continued after a break", "[physics][thermal]") {
  int count = 0;
  for (const auto& [name, value] : {std::pair{"kGeoMod", "2"},
                                    {"kMatPropMod", "1"},
                                    {"skipTime", "1.0e-3"},
                                    {"aveTime", "4.0e-4"}}) {
    INFO(name << " = " << value);
    deck::Deck whole = moving("ball");
    whole.set("maxStps", "300");
    whole.set(name, value);
    deck::Deck part = whole;
    part.set("maxStps", "170");
    const fs::path one = folder("every" + std::to_string(++count)),
                   two = folder("every_cut" + std::to_string(count));
    const Ran unbroken = run_deck(whole, one);
    REQUIRE(unbroken.outcome.status != runs::RunStatus::Failed);
    REQUIRE(run_deck(part, two).outcome.status != runs::RunStatus::Failed);
    const Ran joined = run_deck(whole, two, true);
    INFO(joined.outcome.message);
    REQUIRE(joined.outcome.status == unbroken.outcome.status);
    CHECK(read_bytes(one / "FINAL") == read_bytes(two / "FINAL"));
  }
}

TEST_CASE("thermal steps: run continued after a break → steps of an uninterrupted one",
          "[physics][thermal]") {
  // The longest step is of the time scale that the bearing had before it warmed up.
  for (const char* type : {"ball", "cylindrical", "tapered", "spherical", "spherical-tapered"}) {
    INFO(type);
    deck::Deck whole = moving(type);
    for (const auto& [variable, value] : {std::pair{"stpMax", "0.06"},
                                          {"kMatPropMod", "1"},
                                          {"aveTime", "5.0e-5"},
                                          {"nStps", "4"},
                                          {"maxStps", "200"}})
      whole.set(variable, value);
    deck::Deck part = whole;
    part.set("maxStps", "130");
    const fs::path one = folder(std::string("steps_") + type),
                   two = folder(std::string("steps_cut_") + type);
    const Ran unbroken = run_deck(whole, one);
    REQUIRE(unbroken.outcome.status != runs::RunStatus::Failed);
    REQUIRE(run_deck(part, two).outcome.status != runs::RunStatus::Failed);
    REQUIRE(run_deck(whole, two, true).outcome.status == unbroken.outcome.status);
    CHECK(read_bytes(one / "FINAL") == read_bytes(two / "FINAL"));
    // Temperatures, too, from the first step on that is stored after the cut.
    const results::SolFile a = results::read_sol(one / "SOL7"), b = results::read_sol(two / "SOL7");
    const auto columns = results::sol_columns(a.header);
    const results::H5Reader own(one / "RESULTS.h5"), joined(two / "RESULTS.h5");
    CHECK(own.geometry() == joined.geometry());
    std::size_t compared = 0;
    for (const auto& there : b.steps)
      for (const auto& here : a.steps)
        for (std::size_t c = 0; here.step == there.step && c < columns.size(); ++c) {
          if (columns[c].id == "power.life") continue;  // predicted at the cut once more
          INFO("step " << here.step << ", " << columns[c].id);
          CHECK(here.values[c] == there.values[c]);
          ++compared;
        }
    CHECK(compared > 9 * columns.size());
  }
}

TEST_CASE("continued run: temperatures are continued", "[physics][thermal]") {
  deck::Deck whole = moving("ball");
  const fs::path one = folder("whole"), two = folder("parts");
  const Ran unbroken = run_deck(whole, one);
  REQUIRE(unbroken.outcome.status == runs::RunStatus::Done);
  deck::Deck part = whole;
  part.set("maxStps", "250");
  REQUIRE(run_deck(part, two).outcome.status == runs::RunStatus::Done);
  const Ran joined = run_deck(whole, two, true);
  INFO(joined.outcome.message);
  REQUIRE(joined.outcome.status == runs::RunStatus::Done);
  CHECK(read_bytes(one / "FINAL") == read_bytes(two / "FINAL"));
  const auto a = results::read_sol(one / "SOL7").steps.back().values,
             b = results::read_sol(two / "SOL7").steps.back().values;
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    INFO("value " << k + 1);
    CHECK(a[k] == b[k]);
  }
}

TEST_CASE("temperatures that run away → run ends with their values", "[physics][thermal]") {
  deck::Deck deck = moving("ball");
  deck.set("kCoolant", "13");  // a breath of air
  deck.set("cFlowRate", "1.0e-7");
  deck.set("baseTemp", "320.0");
  // and none around housing and shaft
  const Options insulated{{"housingCooling", "0"}, {"shaftCooling", "0"}};
  const Ran ran = run_deck(deck, folder("runaway"), false, insulated);
  CHECK(ran.outcome.status == runs::RunStatus::Failed);
  CHECK_THAT(ran.outcome.message, Catch::Contains("thermal step") &&
                                      Catch::Contains("temperatures run away") &&
                                      Catch::Contains("Give more coolant"));
  // The same at rest.
  deck::Deck still = warm("ball", "-1");
  still.set("kCoolant", "13");
  still.set("cFlowRate", "1.0e-7");
  CHECK_THROWS_WITH(run_deck(still, folder("still_runaway"), false, insulated),
                    Catch::Contains("thermal analysis: no steady state"));
}

TEST_CASE("medium: drag in decks of all types and modes, with its heat in the balance",
          "[physics][tribology]") {
  for (const auto& [name, mode, share] : {std::tuple{"ball", "0", "0.0"},
                                          {"ball", "0", "0.02"},
                                          {"ball", "1", "0.0"},
                                          {"ball", "2", "0.0"},
                                          {"cylindrical", "0", "0.0"},
                                          {"cylindrical", "1", "0.0"},
                                          {"spherical", "0", "0.0"},
                                          {"tapered", "0", "0.0"},
                                          {"spherical-tapered", "0", "0.0"}}) {
    INFO(name << ", mode " << mode << ", qFac " << share);
    deck::Deck deck = deck::new_deck(name);
    for (const auto& [variable, value] : {std::pair{"mode", mode},
                                          {"qFac", share},
                                          {"kChrn", "14"},
                                          {"maxStps", "60"},
                                          {"nStps", "10"},
                                          {"kPltFreq", "20"}})
      deck.set(variable, value);
    deck.complete();
    deck.set("denRatio", "0.5");
    deck.set("visRatio", "1.0");
    const fs::path where = folder("drag");
    const Ran ran = run_deck(deck, where);
    INFO(ran.outcome.message);
    CHECK(ran.outcome.status == runs::RunStatus::Done);
    const std::vector<double> last = results::read_sol(where / "SOL7").steps.back().values;
    CHECK(last.size() == 17);
    CHECK(last[1] > 0.0);  // churning fraction
    CHECK(last[1] < 1.0);
    CHECK(std::abs(ran.outcome.energy_residual) < 1e-3 * ran.outcome.energy_scale);
    CHECK_THAT(ran.print, Catch::Contains("drag of elements in the medium"));
  }
}

TEST_CASE("cage films: lands and pockets of any type act, also with quasi-static elements",
          "[physics][tribology]") {
  struct Case {
    const char *name, *lands, *pockets, *variable, *value;
  };
  for (const Case& one :
       {Case{"ball", "1", "1", "mode", "0"}, Case{"ball", "0", "1", "qFac", "0.5"},
        Case{"ball", "0", "1", "mode", "1"}, Case{"cylindrical", "1", "1", "mode", "0"},
        Case{"tapered", "0", "1", "mode", "0"}, Case{"spherical", "0", "1", "mode", "1"}}) {
    INFO(one.name << ", kGsHydro " << one.lands << ", " << one.variable << " = " << one.value);
    const auto ran = [&](const char* lands, const char* pockets) {
      deck::Deck deck = deck::new_deck(one.name);
      for (const auto& [variable, value] : {std::pair{"mode", "0"},
                                            {"kGsHydro", lands},
                                            {"kPocHydro", pockets},
                                            {"maxStps", "60"},
                                            {"nStps", "10"}})
        deck.set(variable, value);
      deck.set(one.variable, one.value);
      deck.complete();
      for (const char* viscosity : {"pocVis", "gsVis"})
        if (deck.has(viscosity)) deck.set(viscosity, "0.02");
      // Half of the clearance: walls on both sides are felt.
      if (deck.has("pocLubFilm")) deck.set("pocLubFilm", "1.0e-4");
      const Ran out = run_deck(deck, folder("films"));
      INFO(out.outcome.message);
      CHECK(out.outcome.status == runs::RunStatus::Done);
      CHECK(std::abs(out.outcome.energy_residual) < 1e-3 * out.outcome.energy_scale);
      return out;
    };
    const Ran wet = ran(one.lands, one.pockets), dry = ran("0", "0");
    CHECK_THAT(wet.print, Catch::Contains("heat, films in the pockets"));
    CHECK(dry.print.find("heat, films in the pockets") == std::string::npos);
    // The films act.
    CHECK(wet.report.at("summary").at("mean_power_loss_W") !=
          dry.report.at("summary").at("mean_power_loss_W"));
  }
}
