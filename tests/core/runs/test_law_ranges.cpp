#include "base/validity.hpp"
#include "core/runs/deck_runs.hpp"
#include "deck/deck.hpp"
#include "deck/templates.hpp"
#include "runs/law_ranges.hpp"
#include "runs/prepare.hpp"
#include "runs/run.hpp"
#include "tribology/lubricant.hpp"
#include "tribology/lubricant_range.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

// Laws outside their range of validity (base/validity.hpp, runs/law_ranges.hpp).

using namespace adore;
using deck::Deck;
using testing::Ran;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

Sets hot(double kelvin) {
  Sets out;
  for (const char* name : {"raceTemp1", "raceTemp2", "reTemp", "cageTemp", "hsngTemp", "shftTemp"})
    out.emplace_back(name, fmt::format("{:.3f}", kelvin));
  return out;
}
Sets operator+(Sets a, const Sets& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
Sets oil(const char* code) {
  return {{"kTrac", code}, {"reRaceFilm", "1.0e-8"}, {"strParam", "10.0"}};
}

struct Scene {
  const char* type = "ball";
  Sets sets;
  Sets options;
};

Ran run_scene(const Scene& scene, const char* mode, const std::filesystem::path& folder) {
  Deck deck = deck::new_deck(scene.type);
  deck.set("mode", mode);
  deck.complete();
  const bool moves = std::string(mode) != "-1";
  if (moves) {
    for (const auto& [name, value] : Sets{{"maxStps", "3"}, {"nStps", "1"}, {"kPltFreq", "1"}})
      deck.set(name, value);
  }
  deck.complete();
  for (const auto& [name, value] : scene.sets) {
    deck.set(name, value);
    deck.complete();
  }
  std::filesystem::create_directories(folder);
  deck::write_deck(deck, folder / "DATA.txt");
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.options = scene.options;
  Ran out;
  out.outcome = runs::run(request);
  out.report = nlohmann::json::parse(testing::read_bytes(folder / "RUN.json"));
  out.print = testing::read_bytes(folder / "PRINT.txt");
  return out;
}

bool says(const runs::RunOutcome& outcome, const std::string& text) {
  return std::any_of(outcome.warnings.begin(), outcome.warnings.end(), [&](const Issue& issue) {
    return issue.message.find(text) != std::string::npos;
  });
}

/// A scene outside each range.
struct Left {
  const char* id;
  Scene scene;
  bool of_motion = true;                 ///< reported with body and time in motion
  const char* in_other_words = nullptr;  ///< a remark in more detail
};

std::vector<Left> left_ranges() {
  const Sets heavy{{"appLoadX", "12000.0"}}, heaviest{{"appLoadX", "30000.0"}};  // 2.2, 2.8 GPa
  const Sets thick = oil("2") + hot(250.0) + Sets{{"rpm2", "1000.0"}},
             crushed{{"appLoadX", "150000.0"}};
  const Sets medium{{"kChrn", "5"}, {"denRatio", "1.0"}, {"visRatio", "1.0"}};  // liquid nitrogen
  const Sets warm{{"kTherm", "1"},       {"kMatPropMod", "1"}, {"kBaseTemp", "1"},
                  {"baseTemp", "620.0"}, {"aveTime", "0.001"}, {"skipTime", "0.0005"}};
  return {
      {"film.thickness", {"ball", thick, {}}, true, "times the radius of the contacting bodies"},
      {"film.viscosity", {"ball", thick, {}}, true, "has a calculated viscosity of"},
      {"film.speed", {"ball", oil("4"), {}}},
      {"film.load", {"ball", oil("4"), {}}},
      {"film.ellipticity", {"ball", oil("4") + Sets{{"raceCurFac1", "0.51"}}, {}}},
      {"film.material", {"ball", oil("2") + hot(330.0), {}}},
      {"film.heating", {"ball", oil("1") + hot(290.0), {}}},
      {"traction.pressure", {"ball", oil("11") + heavy, {}}},
      {"traction.unmeasured", {"ball", oil("18"), {}}},
      {"traction.temperature", {"ball", oil("4") + hot(470.0), {}}},
      {"traction.coefficient",
       {"ball", oil("4") + heavy + hot(343.15), {{"filmStressLimit", "off"}}}},
      {"traction.impossible",
       {"ball",
        oil("4") + hot(375.0) + heaviest,
        {{"filmStressLimit", "off"}, {"ballFriction", "spin-rule"}}}},
      {"rolling.strips", {"ball", oil("2") + hot(290.0), {}}, false, "rolling resistance"},
      {"drag.temperature", {"ball", medium, {}}, true, "are known from"},
      {"drag.reynolds", {"ball", medium, {}}},
      {"drag.spin", {"ball", medium, {}}},
      {"hydro.taylor",
       {"ball", oil("4") + hot(440.0) + Sets{{"kGsHydro", "1"}, {"rpm2", "30000.0"}}, {}}},
      {"hydro.length",
       {"ball",
        oil("4") + Sets{{"kGsHydro", "1"}, {"cageWidth", "0.08"}, {"cageGsWidth[1]", "0.04"}},
        {}}},
      {"hertz.ellipse", {"ball", crushed, {}}, true, "more than half the ball radius"},
      {"hertz.width", {"cylindrical", {{"appLoadZ", "300000.0"}}, {}}},
      {"hertz.shoulder", {"ball", crushed, {}}, true, "shoulder"},
      {"hertz.yield", {"ball", crushed, {}}, true, "yield"},
      // Barrels in windows with 1 mm of clearance: their normal loads turn them out of line.
      {"guidance.skew",
       {"spherical",
        oil("5") + Sets{{"bPocCls1", "1.0e-3"},
                        {"rpm2", "5000.0"},
                        {"appLoadZ", "8000.0"},
                        {"maxStps", "1200"},
                        {"kPltFreq", "20"}},
        {}}},
      {"cage.yield",
       {"ball",
        {{"rpm2", "21000.0"}, {"appLoadX", "394.0"}, {"appLoadZ", "693.0"}, {"maxStps", "40"}},
        {}},
       true,
       "yields"},
      {"materials.temperature", {"ball", warm + hot(620.0), {}}, true, "outside the known range"},
      {"materials.tempering", {"ball", hot(480.0), {}}},
      {"conformity.groove", {"ball", {{"raceCurFac1", "0.65"}}, {}}, false},
      {"life.pressure", {"ball", crushed, {}}},
      {"life.load", {"ball", heaviest, {}}, false},  // P = 0.72 C
  };
}

/// Ranges outside which a deck is rejected.
std::vector<Left> refused_ranges() {
  return {{"film.separation", {"ball", oil("2") + hot(225.0) + Sets{{"rpm2", "1000.0"}}, {}}}};
}

}  // namespace

TEST_CASE("validity: every range of the register has law, unit, source and consequence",
          "[unit][validity]") {
  std::set<std::string> ids, laws;
  for (const validity::Range& range : validity::ranges()) {
    CAPTURE(range.id);
    CHECK(ids.insert(range.id).second);
    laws.insert(range.id.substr(0, range.id.find('.')));
    CHECK_FALSE(range.law.empty());
    CHECK_FALSE(range.quantity.empty());
    CHECK_FALSE(range.source.empty());
    CHECK_FALSE(range.consequence.empty());
    CHECK(range.per > 0.0);
    CHECK((!std::isnan(range.bounds.least) || !std::isnan(range.bounds.most) ||
           !range.bound.empty()));
  }
  for (const char* law :
       {"film", "traction", "drag", "hydro", "hertz", "conformity", "materials", "life"})
    CHECK(laws.count(law) == 1);
  CHECK_THROWS_AS(validity::range("no.such"), InternalError);
}

TEST_CASE("validity watch: values inside → nothing; outside → worst value, body and time",
          "[unit][validity]") {
  validity::RangeMonitor watch;
  const validity::Range& range = validity::range("film.material");
  const auto offer = [&](double value, double time, const char* body) {
    watch.offer(range, value, time, [&] { return std::string(body); });
  };
  offer(4000.0, 0.0, "a");
  offer(std::nan(""), 0.0, "a");
  CHECK(watch.findings().empty());
  offer(7000.0, 1.0, "b");
  offer(9000.0, 2.0, "c");
  offer(8000.0, 3.0, "d");
  REQUIRE(watch.findings().size() == 1);
  const validity::Finding& found = watch.findings()[0];
  CHECK(found.value == 9000.0);
  CHECK(found.body == "c");
  CHECK(found.time == 2.0);
  CHECK(found.instants == 3);
  CHECK_THAT(found.text(), Catch::Contains("9000") && Catch::Contains("t = 2 s") &&
                               Catch::Contains("2300 to 6800"));
}

TEST_CASE(
    "validity: each law outside its range, modes -1, 0, 1 and 2 → reported with the worst "
    "value, body and time",
    "[validation][validity][slow]") {
  const testing::TemporaryFolder folder;
  std::set<std::string> left_out;
  for (const validity::Range& range : validity::ranges()) left_out.insert(range.id);
  for (const Left& left : refused_ranges()) {
    left_out.erase(left.id);
    for (const char* mode : {"-1", "0", "1", "2"}) {
      CAPTURE(left.id, mode);
      CHECK_THROWS_AS(run_scene(left.scene, mode, folder / (std::string(left.id) + mode)),
                      InputError);
    }
  }
  for (const Left& left : left_ranges()) {
    left_out.erase(left.id);
    const validity::Range& range = validity::range(left.id);
    for (const char* mode : {"-1", "0", "1", "2"}) {
      const bool moves = std::string(mode) != "-1";
      if (range.motion_only && !moves) continue;
      CAPTURE(left.id, mode);
      const Ran ran = run_scene(left.scene, mode, folder / (std::string(left.id) + mode));
      const bool reported = ran.report.contains("outside_validity");
      CHECK(reported);
      if (!reported) continue;
      bool found = false, at_time = false;
      for (const auto& one : ran.report["outside_validity"]) {
        if (one["range"] != left.id) continue;
        found = true;
        at_time = at_time || one["time_s"].is_number();
        CHECK_FALSE(one["body"].get<std::string>().empty());
        const validity::Bounds bounds{
            one["least_si"].is_null() ? validity::kNoBound : one["least_si"].get<double>(),
            one["most_si"].is_null() ? validity::kNoBound : one["most_si"].get<double>()};
        CHECK_FALSE(bounds.contains(one["value_si"].get<double>()));
      }
      CHECK(found);
      CHECK(at_time == (moves && left.of_motion));
      CHECK((says(ran.outcome, range.quantity) ||
             (left.in_other_words != nullptr && says(ran.outcome, left.in_other_words))));
      if (moves && left.of_motion) CHECK(says(ran.outcome, "t = "));
    }
  }
  CHECK(left_out == std::set<std::string>{});
}

TEST_CASE(
    "friction coefficients: oil film above 0.3 → exit 3; limited → trusted; of the deck → note",
    "[validation][validity]") {
  const testing::TemporaryFolder folder;
  // 3.1 GPa: 0.31 without the limit by balance of friction (race control: 0.39), 0.05 with it; at
  // 2.2 GPa 0.19.
  const Sets heavy = oil("4") + hot(375.0) + Sets{{"appLoadX", "40000.0"}};
  const Sets doubtful = oil("4") + hot(343.15) + Sets{{"appLoadX", "12000.0"}};
  for (const char* mode : {"-1", "0", "1", "2"}) {
    CAPTURE(mode);
    const std::string name = mode;
    const Ran limited = run_scene({"ball", heavy, {}}, mode, folder / ("limited" + name));
    CHECK(limited.outcome.status == runs::RunStatus::Done);
    CHECK_FALSE(says(limited.outcome, "friction coefficient 0."));
    const Ran free =
        run_scene({"ball", heavy, {{"filmStressLimit", "off"}}}, mode, folder / ("free" + name));
    CHECK(free.outcome.status == runs::RunStatus::Untrusted);
    CHECK_THAT(free.outcome.message,
               Catch::Contains("friction coefficient") && Catch::Contains("cannot be trusted"));
    CHECK(free.report["status"] == "untrusted");
    CHECK(says(free.outcome, "filmStressLimit = off"));
    CHECK_THAT(free.print, Catch::Contains("filmStressLimit = off"));
    const Ran between = run_scene({"ball", doubtful, {{"filmStressLimit", "off"}}}, mode,
                                  folder / ("between" + name));
    CHECK(between.outcome.status == runs::RunStatus::Done);
    std::set<std::string> judged;
    for (const auto& one : between.report["outside_validity"])
      judged.insert(one["range"].get<std::string>());
    CHECK(judged.count("traction.coefficient") == 1);
    CHECK(judged.count("traction.impossible") == 0);
    CHECK(says(between.outcome, "No measured oil film has such a friction coefficient"));
    // A curve of the deck: 0.5 everywhere.
    const Ran dry = run_scene(
        {"ball",
         {{"kTracType", "2"}, {"reRaceTC1", "0.5"}, {"reRaceTC2", "0.5"}, {"reRaceTC3", "0.0"}},
         {}},
        mode, folder / ("dry" + name));
    CHECK(dry.outcome.status == runs::RunStatus::Done);
    CHECK(says(dry.outcome, "Largest friction coefficient from the deck or a user routine: 0.5"));
  }
}

TEST_CASE("traction: statics and start of motion → the same friction coefficients within 5 %",
          "[validation][film]") {
  // Σ heat over Σ load × slip of each race. 12 kN of thrust: 2 GPa and more, most films limited.
  // Slip is the same in both where the spin of both races is the larger part (an axis between those
  // of race control, 22.7 and 35 degrees): the statics lets a contact creep until it carries no
  // force, a motion that is not yet balanced rolls without creep. A race that controls has slip of
  // its curvature alone, a quarter more without creep; the axis of least heat in oil lies nearer to
  // it (slip 2.7 % apart). Motion uses the nodes of statics.
  for (const char* code : {"1", "3", "4", "5", "10", "11", "18"}) {
    const auto prepared = [&](const char* mode) {
      Deck deck = deck::new_deck("ball");
      deck.set("mode", mode);
      deck.complete();
      for (const auto& [name, value] :
           oil(code) + hot(343.15) +
               Sets{{"appLoadX", "12000.0"}, {"kAngVel", "2"}, {"angVelOrient", "30.5"}}) {
        deck.set(name, value);
        deck.complete();
      }
      runs::DeckRequest request;
      request.text = deck::write_deck(deck);
      request.options = {{"ellipseMajor", "30"}, {"ellipseMinor", "8"}};
      return runs::prepare(request);
    };
    const runs::Prepared still = prepared("-1"), moving = prepared("0");
    dynamics::System system = runs::make_system(moving);
    const scene::Snapshot start = system.snapshot(0.0, system.initial_state());
    for (std::size_t race = 0; race < 2; ++race) {
      double heat = 0.0, slip = 0.0, still_heat = 0.0, still_slip = 0.0;
      for (const scene::ElementSnapshot& one : start.elements) {
        heat += one.race[race].heat;
        slip += one.race[race].load_slip;
      }
      for (const statics::FrictionOfContact& one : still.friction->race[race]) {
        still_heat += one.spin + one.sliding;
        still_slip += one.load_slip;
      }
      CAPTURE(code, race, heat, slip, still_heat, still_slip);
      REQUIRE(slip > 0.0);
      REQUIRE(still_slip > 0.0);
      CHECK(slip == Approx(still_slip).epsilon(0.02));
      CHECK(heat / slip == Approx(still_heat / still_slip).epsilon(0.05));
    }
  }
}

TEST_CASE("oils with several codes: coefficients of all codes and the recommended one are noted",
          "[validation][film]") {
  const testing::TemporaryFolder folder;
  const Ran ran = run_scene({"ball", oil("4"), {}}, "-1", folder / "spread");
  for (const char* part : {"kTrac 4", "kTrac 10", "kTrac 11 ", "kTrac 12 (recommended)"}) {
    CHECK(says(ran.outcome, part));
    CHECK_THAT(ran.print, Catch::Contains("recommended"));
  }
  const Ran mineral = run_scene({"ball", oil("1"), {}}, "-1", folder / "one");
  CHECK_FALSE(says(mineral.outcome, "recommended"));
}

TEST_CASE("continued run: ranges left before the continuation → still reported, worst value kept",
          "[validation][validity]") {
  const testing::TemporaryFolder folder;
  Deck deck = deck::new_deck("ball");
  for (const auto& [name, value] :
       oil("4") + hot(375.0) + Sets{{"appLoadX", "30000.0"}, {"maxStps", "3"}, {"nStps", "1"}}) {
    deck.set(name, value);
    deck.complete();
  }
  deck::write_deck(deck, folder / "DATA.txt");
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.options = {{"filmStressLimit", "off"}};
  CHECK(runs::run(request).status == runs::RunStatus::Untrusted);
  // The film is bounded from here on.
  request.options.clear();
  request.go_on = true;
  deck.set("maxStps", "6");
  deck::write_deck(deck, folder / "DATA.txt");
  const runs::RunOutcome outcome = runs::run(request);
  CHECK(outcome.status == runs::RunStatus::Untrusted);
  CHECK_THAT(outcome.message, Catch::Contains("friction coefficient"));
}
