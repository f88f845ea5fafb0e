#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/sol_file.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Bearings in oil where it fails them, and elements that are held in balance in oil.
using namespace adore;
using deck::Deck;
using testing::Ran;
using testing::run_deck;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

Deck in_oil(const char* name, const Sets& sets) {
  Deck deck = deck::new_deck(name);
  deck.set("kTrac", "3");
  deck.complete();
  deck.set("reRaceFilm", "1.0e-8");
  deck.set("strParam", "10.0");
  for (const auto& [variable, value] : sets) {
    deck.set(variable, value);
    deck.complete();
  }
  return deck;
}

double summary(const Ran& ran, const char* key) { return ran.report.at("summary").at(key); }

void check_ledger(const Ran& ran) {
  CHECK(ran.outcome.status == runs::RunStatus::Done);
  CHECK(std::abs(ran.outcome.energy_residual) < 1e-4 * ran.outcome.energy_scale);
}

runs::Prepared equilibrium(const char* name, Sets sets) {
  sets.insert(sets.begin(), {"kTracType", "1"});
  runs::LoadedDeck input;
  input.path = runs::kStandardInput;
  input.deck = in_oil(name, sets);
  return runs::prepare(std::move(input));
}

}  // namespace

// Contact vibration carries next to no heat: elements in balance dissipate what free ones do.
TEST_CASE("quasi-static balls in oil: modes 1 and 2 and qFac → heat of mode 0",
          "[physics][film][slow]") {
  const testing::TemporaryFolder folder;
  const auto heat = [&](const char* name, Sets sets) {
    sets.emplace_back("maxStps", "300");
    sets.emplace_back("nStps", "10");
    sets.emplace_back("kPltFreq", "50");
    const Ran ran = run_deck(in_oil("ball", sets), folder / name);
    check_ledger(ran);
    CHECK_THAT(ran.print, Catch::Contains("Lubricant films"));
    return summary(ran, "mean_power_loss_W");
  };
  const double free = heat("free", {});
  CAPTURE(free);
  CHECK(heat("mode1", {{"mode", "1"}}) == Approx(free).epsilon(0.03));
  CHECK(heat("mode2", {{"mode", "2"}}) == Approx(free).epsilon(0.15));  // the race floats
  CHECK(heat("qfac", {{"qFac", "0.5"}}) == Approx(free).epsilon(0.03));
}

TEST_CASE("film that collapses while the bearing stops → run continues",
          "[validation][film][slow]") {
  const testing::TemporaryFolder folder;
  // 10000 rpm to nothing within 5 ms, then 1 ms at rest.
  const Ran ran = run_deck(in_oil("ball", {{"kVarSpeed", "1"},
                                           {"raceAngAcc2", "-2.0e6"},
                                           {"startTime2", "0.0005"},
                                           {"endTime2", "0.0055"},
                                           {"maxStps", "1000"},
                                           {"nStps", "10"},
                                           {"kPltFreq", "50"}}),
                           folder / "stop");
  check_ledger(ran);
  CHECK(std::isfinite(summary(ran, "mean_power_loss_W")));
  CHECK(ran.print.find("nan") == std::string::npos);
}

TEST_CASE("starved bearing → more sliding heat, thinner films", "[physics][film]") {
  const auto solve = [](const char* meniscus) {
    return equilibrium("angular-218", {{"strParam", meniscus},
                                       {"reRaceTC2", "0.1"},
                                       {"reRaceTC3", "0.08"},
                                       {"reRaceTC4", "0.5"},
                                       {"reRaceFilm", "1.5e-7"},
                                       {"kStif", "0"}});
  };
  const runs::Prepared flooded = solve("10.0"), starved = solve("0.05");
  const auto sliding = [](const runs::Prepared& p) {
    const statics::FrictionOfContact outer = p.friction->of_race(0), inner = p.friction->of_race(1);
    return outer.sliding + outer.spin + inner.sliding + inner.spin;
  };
  const auto thinnest = [](const runs::Prepared& p) {
    return p.statics.films->race[1].front().film.minimum;
  };
  CHECK(thinnest(starved) < 0.5 * thinnest(flooded));
  CHECK(sliding(starved) > 1.2 * sliding(flooded));
}

TEST_CASE("starved bearing: thermal steady state of mode -1 → warmer", "[physics][film][thermal]") {
  const auto settled = [](const char* meniscus) {
    return equilibrium("angular-218", {{"kTherm", "1"},
                                       {"kCoolant", "14"},
                                       {"kBaseTemp", "3"},
                                       {"kHTC", "0"},
                                       {"kGeoMod", "1"},
                                       {"kMatPropMod", "0"},
                                       {"baseTemp", "320.0"},
                                       {"cFlowRate", "2.0e-5"},
                                       {"reHTC", "0.0"},
                                       {"cageHTC", "0.0"},
                                       {"aveTime", "2.0e-4"},
                                       {"skipTime", "0.0"},
                                       {"strParam", meniscus},
                                       {"reRaceTC2", "0.1"},
                                       {"reRaceTC3", "0.08"},
                                       {"reRaceTC4", "0.5"},
                                       {"reRaceFilm", "1.5e-7"},
                                       {"kStif", "0"}});
  };
  const runs::Prepared flooded = settled("10.0"), starved = settled("0.05");
  REQUIRE(flooded.thermal);
  REQUIRE(starved.thermal);
  CHECK(starved.thermal->friction.power() > 1.2 * flooded.thermal->friction.power());
  CHECK(starved.bearing.element_temperature > flooded.bearing.element_temperature + 2.0);
  CHECK(starved.bearing.race_temperature[0] > flooded.bearing.race_temperature[0] + 2.0);
}

// Steel balls that liquid oxygen brakes, on a solid film: 50 N of thrust let them lag, 1500 N drive
// them.
TEST_CASE("skidding bearing: load increases → recovers", "[physics][film]") {
  const testing::TemporaryFolder folder;
  const auto skid = [&](const char* name, const char* first, const char* then) {
    Deck deck = deck::new_deck("lox-turbopump");
    for (const auto& [variable, value] : Sets{{"kReMat", "103"},
                                              {"appLoadX", first},
                                              {"appLoadZ", "0.0"},
                                              {"denRatio", "0.5"},
                                              {"kPltFreq", "20"}})
      deck.set(variable, value);
    const auto orbit = [&](const char* thrust, const char* until, bool go_on) {
      deck.set("appLoadX", thrust);
      std::filesystem::create_directories(folder / name);
      deck::write_deck(deck, folder / name / "DATA.txt");
      runs::RunRequest request;
      request.deck = folder / name / "DATA.txt";
      request.until = until;
      request.go_on = go_on;
      // Balls start rolling. The friction equilibrium at 50 N is a deep skid already.
      request.options.emplace_back("ballFriction", "spin-rule");
      const runs::RunOutcome out = runs::run(request);
      INFO(out.message);
      CHECK(out.status == runs::RunStatus::Done);
      CHECK(std::abs(out.energy_residual) < 1e-3 * out.energy_scale);
      constexpr std::size_t kOrbital = 3;  // orbital velocity of ball 1 [rpm]
      return results::read_sol(folder / name / "SOL1").steps.back().values[kOrbital];
    };
    const double before = orbit(first, "8rev", false);
    return std::pair(before, orbit(then, "16rev", true));
  };
  const auto [light, still_light] = skid("light", "50.0", "50.0");
  const auto [lagging, driven] = skid("rises", "50.0", "1500.0");
  const double rolling = skid("heavy", "1500.0", "1500.0").second;
  CAPTURE(light, still_light, lagging, driven, rolling);
  CHECK(lagging == light);
  CHECK(lagging < 0.97 * rolling);
  CHECK(still_light < 0.97 * rolling);
  CHECK(driven == Approx(rolling).epsilon(0.01));
}

// The law of kTrac 1 has no limit: at 2.7 GPa its film would carry many times its load.
TEST_CASE("friction of an equilibrium: bounded at the highest pressures", "[physics][film]") {
  for (const char* load : {"1400.0", "2800.0", "8000.0"}) {
    CAPTURE(load);
    const runs::Prepared p = equilibrium("deep-groove-6205", {{"kTrac", "1"},
                                                              {"appLoadZ", load},
                                                              {"rpm2", "500.0"},
                                                              {"reRaceTC2", "0.1"},
                                                              {"reRaceTC3", "0.08"},
                                                              {"reRaceTC4", "0.5"}});
    double carried = 0.0;  // what all contacts would slide with, at the largest slip of each
    for (const statics::StaticBall& ball : p.statics.balls) carried += ball.Q[0] + ball.Q[1];
    CHECK(p.friction->torque() > 0.0);
    CHECK(p.friction->torque() < 0.11 * carried * 0.5 * p.bearing.balls().diameter);
  }
}
