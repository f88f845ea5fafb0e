#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/sol_file.hpp"
#include "runs/prepare.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// Outputs and continuations of all five types of bearing in motion; crowned raceways and uneven
/// guide lands from decks.
using namespace adore;
using deck::Deck;
using testing::Ran;
using testing::refusal_of;
using testing::run_deck;
namespace fs = std::filesystem;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

constexpr std::array<const char*, 5> kTypes{"ball", "cylindrical", "spherical", "tapered",
                                            "spherical-tapered"};

Deck deck_of(const char* type, const Sets& sets = {}) {
  Deck deck = deck::new_deck(type);
  deck.set_all(Sets{{"maxStps", "20"},
                    {"nStps", "2"},
                    {"kPltFreq", "10"},
                    {"kAGraf", "10"},
                    {"kLifeFreq", "10"},
                    {"kPrtFreq", "10"},
                    {"kPrtOpt", "1"}});
  deck.set_all(sets);
  return deck;
}

std::string why_not(const Deck& deck, const fs::path& folder) {
  try {
    (void)run_deck(deck, folder);
  } catch (const InputError& refused) {
    return refused.what();
  }
  return "was accepted";
}

bool has_section(const std::string& print, const std::string& text) {
  return print.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("every type: plot files, pages and averages are written", "[validation][outputs]") {
  for (const char* type : kTypes) {
    const testing::TemporaryFolder folder;
    const Ran ran = run_deck(deck_of(type), folder / "run");
    const bool rollers = std::string(type) != "ball";
    INFO(type);
    // Element 1, the cage and both races, SOL7, the animation.
    const results::SolFile element = results::read_sol(folder / "run/SOL1");
    CHECK(element.header.value_count == (rollers ? 54 : 38));
    CHECK(element.header.title == "Rolling Element 1");
    REQUIRE(element.steps.size() == 3);  // steps 0, 10 and 20
    for (const results::SolStep& step : element.steps)
      CHECK(step.values.size() == static_cast<std::size_t>(rollers ? 54 : 38));
    for (const char* name : {"SOL2", "SOL3", "SOL4", "SOL7"}) {
      INFO(name);
      CHECK(results::read_sol(folder / "run" / name).steps.size() == 3);
    }
    CHECK(fs::file_size(folder / "run/SOL8") > 1000);
    CHECK(fs::file_size(folder / "run/RESULTS.h5") > 1000);
    for (const char* text :
         {"STEP 0", "STEP 10", "STEP 20", "TIME STEP SUMMARY", "outer race contacts",
          "inner race contacts", "heat, cage pockets",
          "Orbital velocity ratio, average over elements and time",
          "Cage angular velocity ratio, average over time", "Cage whirl ratio, average over time",
          "Power loss, average over time", "Average wear rate, rolling element 1",
          "Average wear rate, outer race", "Average wear rate, inner race",
          "Average wear rate, cage"}) {
      INFO(text);
      CHECK(has_section(ran.print, text));
    }
    // Element 1 wears, and the orbit follows the cage.
    const auto number_behind = [&](const std::string& name) {
      const std::size_t at = ran.print.rfind(name);
      return at == std::string::npos ? 0.0 : std::stod(ran.print.substr(at + name.size()));
    };
    CHECK(number_behind("Average wear rate, rolling element 1") > 0.0);
    CHECK(number_behind("Average wear rate, inner race") >
          number_behind("Average wear rate, rolling element 1") / 30.0);
    const double orbit = number_behind("Orbital velocity ratio, average over elements and time");
    CHECK(orbit > 0.3);
    CHECK(orbit < 0.5);
    CHECK(number_behind("Cage angular velocity ratio, average over time") ==
          Approx(orbit).margin(0.02));
  }
}

TEST_CASE("every type: run ends by steps or time, whichever comes first", "[validation][outputs]") {
  for (const char* type : kTypes) {
    const testing::TemporaryFolder folder;
    const Ran whole = run_deck(deck_of(type), folder / "whole");
    const double scale = whole.report.at("scales").at("time [s]").get<double>();
    const Ran part =
        run_deck(deck_of(type, {{"fTime", fmt::format("{}", 0.5 * whole.outcome.time / scale)}}),
                 folder / "part");
    INFO(type);
    CHECK(whole.outcome.steps == 20);
    CHECK(part.outcome.time == Approx(0.5 * whole.outcome.time).epsilon(1e-9));
    CHECK(part.outcome.steps < 20);
  }
}

TEST_CASE("every type: continued where it stopped, only as the same type",
          "[validation][outputs]") {
  for (const char* type : kTypes) {
    const testing::TemporaryFolder folder;
    INFO(type);
    const Ran whole = run_deck(deck_of(type, {{"maxStps", "40"}}), folder / "whole");
    (void)run_deck(deck_of(type), folder / "parts");
    const bool rollers = std::string(type) != "ball";
    const auto more = [&](const Sets& sets) {
      Sets all{{"kIcOpt", "1"}};
      all.insert(all.end(), sets.begin(), sets.end());
      return deck_of(type, all);
    };
    // Another bearing: by what differs.
    for (const auto& [variable, value] : {std::pair{"bReDia", rollers ? "0.0094" : "0.0126"},
                                          {"kReMat", "101"},
                                          {"cageWidth", "0.0181"},
                                          {"cageDen", ""},
                                          {"shftID", "0.011"}}) {
      if (*value == '\0') continue;
      const std::string why = why_not(more({{variable, value}}), folder / "parts");
      INFO(variable << ": " << why);
      CHECK_THAT(why, Catch::Contains(variable) && Catch::Contains("kIcOpt = -1"));
    }
    const Deck nominal = deck::new_deck(type);
    const std::string fewer = fmt::format("{}", nominal.integer("nRe") - 1);
    CHECK_THAT(why_not(more({{"nRe", fewer}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}}),
                       folder / "parts"),
               Catch::Contains("nRe"));
    // From FINAL of another count no new run starts either: its bodies have no state.
    CHECK_THAT(
        why_not(
            deck_of(type,
                    {{"kIcOpt", "-1"}, {"nRe", fewer}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}}),
            folder / "parts"),
        !Catch::Contains("was accepted"));
    // Nor from that of another type with as many elements.
    for (const char* other : kTypes) {
      if (std::string(other) == type) continue;
      const std::string count = fmt::format("{}", nominal.integer("nRe"));
      const std::string why = why_not(
          deck_of(other,
                  {{"kIcOpt", "-1"}, {"nRe", count}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}}),
          folder / "parts");
      INFO(other << ": " << why);
      CHECK_THAT(why, !Catch::Contains("was accepted"));
      if (std::string(type) == "cylindrical" && std::string(other) == "tapered")
        CHECK_THAT(why, Catch::Contains("kBrg: 2 (cylindrical roller) before") &&
                            Catch::Contains("kIcOpt = 0"));
    }
    // The same one, and then under another load and speed.
    const Ran parts = run_deck(more({}), folder / "parts");
    CHECK(parts.outcome.steps == whole.outcome.steps);
    CHECK(parts.outcome.time == Approx(whole.outcome.time).epsilon(1e-5));
    const std::string faster = fmt::format("{}", nominal.real("rpm2") * 0.9);
    const std::string heavier = fmt::format("{}", nominal.real("appLoadZ") + 100.0);
    const Ran changed = run_deck(more({{"rpm2", faster}, {"appLoadZ", heavier}}), folder / "parts");
    CHECK_THAT(changed.print, Catch::Contains("with a changed deck") && Catch::Contains("rpm2: ") &&
                                  Catch::Contains("appLoadZ: "));
  }
}

TEST_CASE("row without the thrust that it needs → rejected with its load, in every mode",
          "[validation][rollers]") {
  for (const char* type : {"tapered", "spherical-tapered"})
    for (const char* mode : {"-1", "0", "1", "2"}) {
      const auto with = [&](const char* thrust) {
        return refusal_of(
            deck_of(type, {{"mode", mode}, {"appLoadX", thrust}, {"appLoadZ", "2000"}}));
      };
      INFO(type << ", mode " << mode << ": " << with("100"));
      CHECK_THAT(with("100"), Catch::Contains("appLoadX = 100") && Catch::Contains("at least") &&
                                  Catch::Contains("kFS1"));
      CHECK(with("1500") == "was accepted");
    }
}

TEST_CASE("free race of every type: mean of the specified load", "[physics][runs][motions][slow]") {
  constexpr double kMass = 0.5;
  for (const char* type : kTypes) {
    const testing::TemporaryFolder folder;
    Deck deck = deck::new_deck(type);
    deck.set_all(Sets{{"kDCR", "1"},
                      {"kFD22", "0"},
                      {"kFD32", "0"},
                      {"kRaceIP2", "1"},
                      {"raceMass2", fmt::format("{}", kMass)},
                      {"raceMIx2", "4e-4"},
                      {"raceMIy2", "3e-4"},
                      {"raceMIz2", "3e-4"},
                      {"nStps", "2"}});  // a mean of stored steps
    // Nothing holds the inner race of the cylindrical example along x.
    if (std::string(type) != "cylindrical") deck.set("kFD12", "0");
    deck::write_deck(deck, folder / "DATA.txt");
    runs::RunRequest request;
    request.deck = folder / "DATA.txt";
    const double time = 0.5 * 60.0 / deck.real("rpm2");
    request.until = fmt::format("{}s", time);
    REQUIRE(runs::run(request).status == runs::RunStatus::Done);
    // Newton: what the elements carried on the mean is the load less the race's change of momentum
    // over the time; it starts at rest.
    const std::string state = testing::read_bytes(folder / "FINAL");
    double momentum = 0.0, asked = 0.0, off = 0.0;
    bool differs = false;
    const auto report = nlohmann::json::parse(testing::read_bytes(folder / "RUN.json"))
                            .at("load carried by the elements");
    for (int k = 1; k <= 3; ++k) {
      const std::size_t at = state.find(fmt::format(" inner race.velocity[{}]", k));
      REQUIRE(at != std::string::npos);
      const std::size_t line = state.rfind('\n', at) + 1;
      const double change = kMass * std::stod(state.substr(line, at - line));
      momentum = std::hypot(momentum, change);
      const std::string axis(1, "xyz"[k - 1]);
      if (!report.contains("asked " + axis + " [N]")) continue;  // its place is given
      if (k == 1 && std::string(type) == "cylindrical") continue;
      // The report has it from the contacts, at the steps that are stored.
      const double mean = report.at("mean " + axis + " [N]").get<double>();
      const double load = report.at("asked " + axis + " [N]").get<double>();
      off = std::hypot(off, mean - (load - change / time));
      differs = differs || mean != load;
    }
    for (const char* load : {"appLoadX", "appLoadY", "appLoadZ"})
      asked = std::hypot(asked, deck.real(load));
    INFO(type << ": momentum " << momentum << " N s over " << time << " s, load " << asked << " N");
    CHECK(momentum > 0.0);
    CHECK(momentum / time < 0.005 * asked);
    CHECK(off < 0.01 * asked);
    CHECK(differs);
  }
}

TEST_CASE("crowned raceways: decks run, and the crown acts", "[validation][rollers]") {
  for (const char* type : {"cylindrical", "tapered"}) {
    const testing::TemporaryFolder folder;
    INFO(type);
    const auto pressure = [&](const char* name, const Sets& sets) {
      Sets all{{"mode", "-1"}};
      all.insert(all.end(), sets.begin(), sets.end());
      return run_deck(deck_of(type, all), folder / name).report.at("summary").dump();
    };
    const std::string flat = pressure("flat", {});
    CHECK(pressure("land only", {{"raceCenLen2", "0.004"}}) == flat);
    CHECK(pressure("crown", {{"raceCrn2", "1"}, {"raceCenLen2", "0.002"}}) != flat);
    const Ran ran = run_deck(deck_of(type, {{"raceCrn1", "2"},
                                            {"raceCrn2", "1"},
                                            {"raceCenLen2", "0.002"},
                                            {"intMet", "5"},
                                            {"stpMax", "0.5"},
                                            {"tol", "1e-6"}}),
                             folder / "motion");
    CHECK(std::abs(ran.outcome.energy_residual) < 1e-5 * ran.outcome.energy_scale);
    CHECK_THAT(ran.print, Catch::Contains("Crown radius of the inner race"));
    CHECK_THAT(
        refusal_of(deck_of(type, {{"raceCrn2", "0.003"}})),
        Catch::Contains("raceCrn2") && Catch::Contains("would end within the raceway width"));
  }
}

TEST_CASE("uneven guide lands: decks run, and the energy ledger closes", "[validation][cage]") {
  const Sets wild{{"avRatio", "1.3"},       {"wvRatio", "20"},        {"cageGcPos", "0,0,-5e-5"},
                  {"cageGsCls[1]", "2e-4"}, {"cageGsCls[2]", "2e-4"}, {"maxStps", "60"}};
  const Sets ellipse{
      {"kCageGsImp", "1"}, {"cageGsRadVar1[1]", "2e-5"}, {"cageGsRadVar2[1]", "-2e-5"}};
  const Sets waves{{"kRaceGsImp", "2"},       {"raceGsRadVar1[1]", "2e-5"},
                   {"raceGsRadVar2[1]", "3"}, {"raceGsRadVar1[2]", "1e-5"},
                   {"raceGsRadVar2[2]", "5"}, {"raceGsRadVar3[2]", "40"}};
  for (const char* type : {"ball", "cylindrical"}) {  // their examples have lands
    const testing::TemporaryFolder folder;
    std::string plain;
    for (const auto& [name, errors] :
         {std::pair{"round", Sets{}}, {"ellipse", ellipse}, {"waves", waves}}) {
      Deck deck = deck_of(type, wild);
      deck.set_all(errors);
      const Ran ran = run_deck(deck, folder / name);
      INFO(type << ", " << name << ": residual " << ran.outcome.energy_residual << " of "
                << ran.outcome.energy_scale);
      // A cage that is thrown about: round lands leave 1.4e-4 at the tolerance of the deck.
      CHECK(std::abs(ran.outcome.energy_residual) < 2e-4 * ran.outcome.energy_scale);
      const std::string cage = testing::read_bytes(folder / name / "FINAL");
      if (plain.empty())
        plain = cage;
      else
        CHECK(cage != plain);
      CHECK((ran.print.find("Smallest radial clearance at land 1 including form errors") !=
             std::string::npos) == !errors.empty());
    }
  }
  CHECK_THAT(refusal_of(deck_of(
                 "ball",
                 {{"kRaceGsImp", "2"}, {"raceGsRadVar1[1]", "1e-5"}, {"raceGsRadVar2[1]", "2.5"}})),
             Catch::Contains("raceGsRadVar2") && Catch::Contains("whole number"));
  CHECK_THAT(refusal_of(deck_of("ball", {{"kCageGsImp", "1"}, {"cageGsRadVar1[1]", "0.01"}})),
             Catch::Contains("cageGsRadVar1") && Catch::Contains("of at most"));
  // Deviations that use up the play: the start says so.
  const testing::TemporaryFolder folder;
  CHECK_THAT(why_not(deck_of("ball", {{"kCageGsImp", "1"}, {"cageGsRadVar1[1]", "3e-4"}}),
                     folder / "tight"),
             Catch::Contains("overlaps other bodies") && Catch::Contains("guide land 1"));
}

TEST_CASE("cage records: no value gives an impossible pocket", "[validation][cage]") {
  // Each is refused by its own name at both ends of the range that a cage can have.
  for (const char* type : kTypes) {
    const Deck nominal = deck::new_deck(type);
    const double wall = 0.5 * (nominal.real("cageDia1") - nominal.real("cageDia2"));
    const double width = nominal.real("cageWidth"), D = nominal.real("bReDia");
    const double share = 180.0 / static_cast<double>(nominal.integer("nRe"));
    struct Limit {
      const char* variable;
      double bad, good;
    };
    for (const Limit& limit : {Limit{"bPocThknsVar", -1.01 * wall, -0.5 * wall},
                               {"bPocThknsVar", -1e8, 1e-5},
                               {"bPocThknsVar", 1e8, 0.5 * wall},
                               {"bPocCenVar1", 0.51 * width, 1e-5},
                               {"bPocCenVar1", -1e8, -1e-5},
                               {"bPocCenVar2", 1.01 * share, 0.01},
                               {"bPocCenVar2", -1e8, -0.01},
                               {"bPocAngVar1", 45.0, 0.05},
                               {"bPocAngVar2", -80.0, 0.05},
                               {"bPocAngVar3", 1e8, 0.05},
                               {"bPocClsVar1", -1.1 * D, 1e-5},
                               {"bPocClsVar1", 1e8, 1e-5}})
      for (const char* code : {"1", "2"}) {
        const auto with = [&](double value) {
          return refusal_of(
              deck_of(type, {{"kCagePocImp", code}, {limit.variable, fmt::format("{}", value)}}));
        };
        INFO(type << ", kCagePocImp " << code << ", " << limit.variable << ": " << with(limit.bad));
        CHECK_THAT(with(limit.bad), Catch::Contains(limit.variable) && Catch::Contains("give"));
        CHECK(with(limit.good) == "was accepted");
      }
    CHECK_THAT(refusal_of(deck_of(type, {{"kCagePocImp", "3"}, {"bPocThknsVar", "1e3"}})),
               Catch::Contains("random deviation"));
    if (nominal.integer("nGL") == 0) continue;
    CHECK_THAT(refusal_of(deck_of(type, {{"cageGsPos[1]", "0.05"}})),
               Catch::Contains("puts the whole land outside the cage"));
    CHECK_THAT(refusal_of(deck_of(type, {{"cageGsDia[1]", "1e3"}})),
               Catch::Contains("outside the bearing"));
  }
}

TEST_CASE("cage cut into segments: keeps the start of the one-piece cage", "[unit][cage]") {
  Deck deck = deck_of("ball", {{"avRatio", "0.97"}, {"cageGcPos", "0,0,1e-5"}});
  deck.set_all(Sets{{"nRe", "12"},
                    {"nCseg", "3"},
                    {"cageAngCut", "1"},
                    {"lSeg[1]", "2"},
                    {"lSeg[2]", "6"},
                    {"lSeg[3]", "10"},
                    {"kNumPltElem", "1"},
                    {"kPltElemInd", "1"}});
  for (int k = 1; k <= 3; ++k) {
    CHECK(deck.real("avRatio", k) == 0.97);
    CHECK(deck.real("cageGcPos", k, 3) == 1e-5);
  }
  // What it was given itself it keeps, and the whole cage has its own record back.
  deck.set_all(Sets{{"avRatio[2]", "1.1"}});
  deck.set_all(Sets{{"nCseg", "1"}});
  CHECK(deck.real("avRatio") == 0.97);
  deck.set_all(Sets{{"nCseg", "3"}});
  CHECK(deck.real("avRatio", 2) == 1.1);
  // Without cage there was nothing to take over: the resting cage is warned of.
  bool warned = false;
  Deck resting = deck_of("ball", {{"avRatio", "0"}});
  for (const Issue& issue : deck::check_deck(resting))
    warned = warned || (issue.variable == "avRatio" && issue.severity == Severity::Warning);
  CHECK(warned);
}
