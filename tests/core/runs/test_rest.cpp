#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "dynamics/rest_equilibrium.hpp"
#include "dynamics/roller_start.hpp"
#include "results/results_h5.hpp"
#include "runs/rest_watch.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

/// Bearings at rest (runs/rest_watch.hpp, dynamics/rest_equilibrium.hpp).
using namespace adore;

namespace {

/// 10 ms of the ball example without speeds, weight and cage.
deck::Deck resting(const testing::Options& more = {}) {
  deck::Deck deck = deck::new_deck("ball");
  deck.set_all(testing::Options{{"rpm1", "0"},
                                {"rpm2", "0"},
                                {"nCseg", "0"},
                                {"gravityVecZ", "0"},
                                {"kPltFreq", "1"},
                                {"kNumPltElem", "1"},
                                {"kPltElemInd", "1"},
                                {"fTime", "1145"}});
  deck.set_all(more);
  return deck;
}

constexpr std::array kTypes{"ball", "cylindrical", "tapered", "spherical", "spherical-tapered"};

/// The example of a type without speeds.
deck::Deck still(const std::string& type, const testing::Options& more = {}) {
  deck::Deck deck = deck::new_deck(type);
  deck.set_all(testing::Options{
      {"rpm1", "0"}, {"rpm2", "0"}, {"kPltFreq", "1"}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}});
  deck.set_all(more);
  return deck;
}

runs::Prepared prepared(const deck::Deck& deck) {
  runs::DeckRequest request;
  request.text = deck::write_deck(deck);
  return runs::prepare(request);
}

/// Race loads of the static solution: outer and inner race of each element [N].
std::vector<double> static_loads(const runs::Prepared& of) {
  std::vector<double> out;
  if (of.roller_scene)
    for (const auto& roller : of.roller_scene->solution.rollers)
      for (const auto& race : roller.race) out.push_back(race.load);
  else
    for (const auto& ball : of.start.balls) out.insert(out.end(), ball.Q.begin(), ball.Q.end());
  return out;
}

testing::Ran run_until(const deck::Deck& deck, const std::filesystem::path& folder,
                       const std::string& until, const testing::Options& options = {}) {
  std::filesystem::create_directories(folder);
  deck::write_deck(deck, folder / "DATA.txt");
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.until = until;
  request.options = options;
  testing::Ran out;
  out.outcome = runs::run(request);
  out.report = nlohmann::json::parse(testing::read_bytes(folder / "RUN.json"));
  return out;
}

bool has_rest(const testing::Ran& ran) {
  for (const auto& finding : ran.report.at("findings"))
    if (finding.at("code") == "run.rest") return true;
  return false;
}

}  // namespace

TEST_CASE("rest: bearing at rest → at most 100 steps, its loads stay, and a note",
          "[physics][runs]") {
  const testing::TemporaryFolder folder;
  const testing::Ran ran = testing::run_deck(resting(), folder / "rest");
  CHECK(ran.outcome.status == runs::RunStatus::Done);
  CHECK(has_rest(ran));
  CHECK(ran.report.at("summary").at("time_s").get<double>() == Approx(0.01).epsilon(0.05));
  CHECK(ran.report.at("steps").get<int>() <= 100);
  const std::vector<double> load =
      results::H5Reader(folder / "rest" / "RESULTS.h5").read("contact.load");
  const std::size_t width = 24;
  REQUIRE(load.size() > 10 * width);
  for (std::size_t i = width; i < load.size(); ++i)
    CHECK(load[i] == Approx(load[i % width]).epsilon(1e-6).margin(1e-6));
}

TEST_CASE("rest: speed, vibration or load over time → integrated", "[physics][runs]") {
  const testing::TemporaryFolder folder;
  const testing::Options cases[] = {
      {{"rpm2", "1"}},
      {{"kVarSpeed", "1"}, {"raceAngAcc2", "1e6"}, {"endTime2", "1"}},
      {{"kVarSpeed", "2"}, {"raceSpeedAmp2", "20000"}, {"raceSpeedFreq2", "500"}},
      {{"kVarLoad", "2"}, {"raceVibAmp21", "2e-6"}, {"raceVibFreq1", "3000"}},
      {{"mode", "2"}, {"kVarLoad", "1"}, {"rotLoadFrac2", "1"}, {"rotLoadRpm2", "60000"}},
  };
  for (testing::Options moved : cases) {
    INFO(moved.back().first);
    moved.insert(moved.begin(), {"fTime", "20"});
    CHECK_FALSE(has_rest(testing::run_deck(resting(moved), folder / moved.back().first)));
  }
}

namespace {

/// 10 ms at rest: steps, status and loads.
void check_rest(const deck::Deck& deck, const std::filesystem::path& folder) {
  const testing::Ran ran = run_until(deck, folder, "0.01s");
  CHECK(ran.outcome.status == runs::RunStatus::Done);
  CHECK(has_rest(ran));
  CHECK(ran.report.at("steps").get<int>() <= 100);
  CHECK(ran.outcome.time == Approx(0.01));
  const std::vector<double> solved = static_loads(prepared(deck));
  const std::vector<double> load = results::H5Reader(folder / "RESULTS.h5").read("contact.load");
  REQUIRE(load.size() > solved.size());
  const double applied = std::max(std::abs(deck.real("appLoadX")), std::abs(deck.real("appLoadZ")));
  for (std::size_t i = 0; i < load.size(); ++i)
    CHECK(load[i] == Approx(solved[i % solved.size()]).margin(0.01 * applied));
}

}  // namespace

TEST_CASE("rest: examples without speeds → at most 100 steps, loads of the statics",
          "[physics][runs]") {
  const testing::TemporaryFolder folder;
  for (const std::string type : kTypes) {
    INFO(type);
    check_rest(still(type), folder / type);
  }
}

TEST_CASE("rest: types, lubrication, gravity and loads → at most 100 steps, loads of the statics",
          "[physics][runs][slow][nightly]") {
  const testing::TemporaryFolder folder;
  const testing::Options lubricants[] = {
      {{"kTrac", "0"}}, {{"kTrac", "4"}, {"reRaceFilm", "1e-8"}, {"strParam", "10"}}};
  const testing::Options gravities[] = {
      {{"gravityVecZ", "-9.81"}}, {{"gravityVecZ", "0"}}, {{"gravityVecX", "-9.81"}}};
  int number = 0;
  for (const std::string type : kTypes)
    for (const testing::Options& lubricant : lubricants)
      for (const testing::Options& gravity : gravities)
        for (const char* axial : {"0", "200", "1500"})
          for (const char* radial : {"0", "3000"}) {
            const bool thrust_needed = type == "tapered" || type == "spherical-tapered";
            const std::string x = axial, z = radial;
            if ((x == "0" && (z == "0" || thrust_needed)) ||
                (type == "cylindrical" && x == "1500") || (x == "200" && z == "3000"))
              continue;
            testing::Options more = lubricant;
            more.insert(more.end(), gravity.begin(), gravity.end());
            more.insert(more.end(), {{"appLoadX", x}, {"appLoadZ", z}});
            INFO(type << " kTrac=" << lubricant[0].second << " " << gravity[0].first << "="
                      << gravity[0].second << " X=" << x << " Z=" << z);
            check_rest(still(type, more), folder / std::to_string(number++));
          }
}

TEST_CASE("rest: displaced or moving bodies → no rest position", "[physics][runs]") {
  const std::string type = GENERATE("ball", "cylindrical");
  CAPTURE(type);
  const runs::Prepared deck = prepared(still(type));
  dynamics::System system = runs::make_system(deck);
  const std::vector<double> start = system.initial_state();
  std::vector<double> rest = start;
  REQUIRE(runs::start_at_rest(deck, system, rest));
  const auto index_of = [&](const std::string& name) {
    for (int i = 0; i < system.layout().controlled_size(); ++i)
      if (system.layout().component_name(i).starts_with(name)) return static_cast<std::size_t>(i);
    FAIL("no component " << name);
    return std::size_t{0};
  };
  const auto rests = [&](std::vector<double> y) { return find_rest(system, y, {}).found; };
  const auto changed = [&](const std::string& name, double by) {
    std::vector<double> y = rest;
    y[index_of(name)] += by;
    return y;
  };
  CHECK(rests(rest));
  CHECK_FALSE(rests(start));  // the cage falls
  CHECK_FALSE(rests(changed("element.theta_dot[1]", 1e-6)));
  CHECK_FALSE(rests(changed("cage.velocity[2]", 1e-9)));
  CHECK_FALSE(rests(changed("cage.position[3]", 1e-5)));  // raised
  CHECK_FALSE(rests(changed("element.r[1]", 1e-7)));      // turning point of a vibration
  // Turning point of a cage that swings on its guide or on its elements.
  for (const double angle : {0.02, 0.1}) {
    std::vector<double> y = rest;
    const double radius = std::abs(rest[index_of("cage.position[3]")]);
    y[index_of("cage.position[2]")] += radius * std::sin(angle);
    y[index_of("cage.position[3]")] += radius * (1.0 - std::cos(angle));
    CHECK_FALSE(rests(y));
  }
  if (type == "cylindrical")  // A roller without load rolls back to its pocket.
    for (const double by : {-2e-4, 2e-4}) CHECK_FALSE(rests(changed("element.theta[5]", by)));
}

TEST_CASE("rest: 0.0001 rpm → integrated, shaft angle of the speed", "[physics][runs]") {
  const testing::TemporaryFolder folder;
  const testing::Ran ran = run_until(still("ball", {{"rpm2", "1e-4"}}), folder / "slow", "0.001s");
  CHECK(ran.outcome.status == runs::RunStatus::Done);
  CHECK_FALSE(has_rest(ran));
  CHECK(ran.outcome.revolutions == Approx(1e-4 / 60.0 * 1e-3));
}

TEST_CASE("rest: startAtRest=off → the cage falls", "[physics][runs]") {
  const testing::TemporaryFolder folder;
  const testing::Ran ran =
      run_until(still("ball"), folder / "falling", "0.002s", {{"startAtRest", "off"}});
  CHECK(ran.outcome.status == runs::RunStatus::Done);
  CHECK_FALSE(has_rest(ran));
  const std::vector<double> z =
      results::H5Reader(folder / "falling" / "RESULTS.h5").read("cage.position");
  REQUIRE(z.size() > 6);
  CHECK(z[z.size() - 1] - z[2] == Approx(-0.5 * 9.81 * 4e-6).epsilon(0.05));
}

TEST_CASE("rest: continued run → still at rest", "[physics][runs]") {
  const testing::TemporaryFolder folder;
  (void)run_until(still("cylindrical"), folder / "run", "0.005s");
  runs::RunRequest request;
  request.deck = folder / "run" / "DATA.txt";
  request.until = "0.01s";
  request.go_on = true;
  const runs::RunOutcome more = runs::run(request);
  CHECK(more.status == runs::RunStatus::Done);
  CHECK(more.steps <= 150);
}
