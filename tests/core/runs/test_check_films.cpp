#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "runs/check.hpp"
#include "runs/disk_use.hpp"
#include "tribology/fluid.hpp"
#include "tribology/lubricant.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <typeinfo>

/// What a run refuses of oils that are too thick, and that `adore check` says the same.
using namespace adore;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

deck::Deck deck_of(std::string_view name, const Sets& sets) {
  deck::Deck deck = deck::new_deck(name);
  for (const auto& [variable, value] : sets) {
    deck.set(variable, value);
    deck.complete();
  }
  return deck;
}

Sets with(Sets sets, const Sets& more) {
  sets.insert(sets.end(), more.begin(), more.end());
  return sets;
}

/// Temperatures of races and elements, in kelvin or degrees Rankine.
Sets at(double kelvin, deck::UnitSystem units = deck::UnitSystem::SI) {
  const double T = units == deck::UnitSystem::SI ? kelvin : 1.8 * kelvin;
  Sets out;
  for (const char* name : {"raceTemp1", "raceTemp2", "reTemp"})
    out.emplace_back(name, fmt::format("{:.2f}", T));
  return out;
}

Sets in_oil(int code) {
  return {{"kTrac", std::to_string(code)}, {"reRaceFilm", "1.0e-8"}, {"strParam", "10.0"}};
}

runs::DeckRequest request_of(const deck::Deck& deck) {
  runs::DeckRequest request;
  request.text = deck::write_deck(deck);
  request.deck = "DATA.txt";
  request.in_memory = true;
  return request;
}

/// Empty: a run begins.
std::string end_of_preparation(const runs::DeckRequest& request) {
  try {
    (void)runs::prepare(request);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

std::string errors_of(const runs::CheckReport& report) {
  std::string out;
  for (const Issue& issue : report.issues)
    if (issue.severity == Severity::Error) out += issue.text() + "\n";
  return out;
}

bool says(const runs::CheckReport& report, Severity severity, const std::string& phrase) {
  return std::any_of(report.issues.begin(), report.issues.end(), [&](const Issue& issue) {
    return issue.severity == severity && issue.text().find(phrase) != std::string::npos;
  });
}

runs::CheckReport checked(std::string_view name, const Sets& sets) {
  return runs::check(request_of(deck_of(name, sets)));
}

struct Agreement {
  int good = 0, refused = 0;
};

/// check() and the preparation of a run, for one of `every` combinations of example deck, lubricant
/// and temperature.
Agreement check_agreement(int every) {
  Agreement out;
  int number = 0;
  for (const deck::TemplateInfo& info : deck::templates())
    for (const int code : tribology::lubricant_codes())
      for (const double kelvin : {95.0, 223.15, 330.0}) {
        if (number++ % every != 0) continue;
        CAPTURE(info.name, code, kelvin);
        const deck::UnitSystem units = deck::new_deck(info.name).units();
        runs::DeckRequest request = request_of(
            deck_of(info.name, with(with({{"mode", "-1"}}, in_oil(code)), at(kelvin, units))));
        // Films are the subject; friction equilibria in oil that is nearly solid take seconds.
        request.options.emplace_back("ballFriction", "spin-rule");
        const runs::CheckReport report = runs::check(request);
        const std::string end = end_of_preparation(request);
        CHECK(report.ok() == end.empty());
        if (end.empty()) {
          ++out.good;
        } else {
          ++out.refused;
          INFO(end);
          CHECK(errors_of(report).find(end) != std::string::npos);
        }
        if (kelvin > 300.0) CHECK(report.ok());
      }
  return out;
}

}  // namespace

TEST_CASE("check and run: agree on every example deck in every lubricant, cold and warm",
          "[validation][film][check][slow][nightly]") {
  const auto [good, refused] = check_agreement(1);
  CAPTURE(good, refused);
  CHECK(refused > 150);
  CHECK(good > 300);
}

TEST_CASE("check and run: agree on one combination of four of deck, lubricant and temperature",
          "[validation][film][check][slow]") {
  const auto [good, refused] = check_agreement(4);
  CAPTURE(good, refused);
  CHECK(refused > 37);
  CHECK(good > 75);
}

TEST_CASE("check: oil too thick for a film → error with the lubricant", "[physics][film][check]") {
  for (const char* type : {"ball", "cylindrical", "tapered", "spherical", "spherical-tapered"})
    for (const char* mode : {"-1", "0"}) {
      CAPTURE(type, mode);
      const Sets oil = with({{"mode", mode}}, in_oil(4));
      const runs::CheckReport cold = checked(type, with(oil, at(95.0)));
      CHECK_FALSE(cold.ok());
      CHECK(says(cold, Severity::Error, "record 10.0, kTrac = 4: "));
      CHECK(says(cold, Severity::Error, "is a glass"));
      CHECK(checked(type, with(oil, at(330.0))).ok());
      CHECK_THAT(
          testing::refusal_of(deck_of(type, with(oil, at(95.0)))),
          Catch::Contains("record 10.0, kTrac = 4: ") && Catch::Contains("or set kTrac = 0"));
    }
}

TEST_CASE("check: film too thick for its formula → warning", "[physics][film][check]") {
  // Between the range of the fits and the end: some temperature of these has it.
  bool warned = false;
  for (double kelvin = 200.0; kelvin < 280.0 && !warned; kelvin += 4.0) {
    const runs::CheckReport report =
        checked("ball", with(with({{"mode", "-1"}}, in_oil(4)), at(kelvin)));
    warned =
        report.ok() && says(report, Severity::Warning, "times the radius of the contacting bodies");
  }
  CHECK(warned);
}

TEST_CASE("check: cold oil without a film → no error", "[physics][film][check]") {
  const Sets cold = with(in_oil(4), at(95.0));
  // No oil before the contacts: whatever it is, it acts on nothing.
  for (const char* mode : {"-1", "0"}) {
    CAPTURE(mode);
    CHECK(checked("ball", with({{"mode", mode}, {"kTrac", "4"}}, with(cold, {{"strParam", "0.0"}})))
              .ok());
  }
  // Nor does its rolling resistance: a motion in it closes its energy.
  const testing::TemporaryFolder folder;
  const deck::Deck dry = deck_of(
      "ball", with(with({{"mode", "0"}}, cold),
                   {{"strParam", "0.0"}, {"maxStps", "30"}, {"nStps", "10"}, {"tol", "1.0e-7"}}));
  const testing::Ran ran = testing::run_deck(dry, folder / "dry");
  INFO(ran.outcome.message);
  CHECK(ran.outcome.status == runs::RunStatus::Done);
  CHECK(ran.print.find("strParam = 0, no oil at the contact inlets") != std::string::npos);
  // At rest an equilibrium has no film; a motion would turn in it later.
  const Sets rest{{"rpm1", "0.0"}, {"rpm2", "0.0"}};
  CHECK(checked("ball", with({{"mode", "-1"}}, with(cold, rest))).ok());
  CHECK_FALSE(checked("ball", with({{"mode", "0"}}, with(cold, rest))).ok());
}

namespace {

void check_thick_oil(const char* type) {
  const Sets thermal{{"mode", "0"},        {"kTherm", "1"},         {"kCoolant", "14"},
                     {"kBaseTemp", "3"},   {"kHTC", "0"},           {"kGeoMod", "0"},
                     {"baseTemp", "330."}, {"cFlowRate", "1.0e-5"}, {"aveTime", "2.0e-5"},
                     {"skipTime", "0.0"}};
  const testing::TemporaryFolder folder;
  const Sets warmed = with(with(thermal, in_oil(4)), at(155.0));
  const runs::CheckReport report = checked(type, warmed);
  INFO(to_text({report.issues.begin(), report.issues.end()}));
  CHECK(report.ok());
  CHECK(says(report, Severity::Warning, "until thermal steps have warmed the oil"));
  // The same without thermal steps is refused.
  CHECK_FALSE(checked(type, with(warmed, {{"kTherm", "0"}})).ok());
  CHECK(says(checked(type, with(warmed, at(95.0))), Severity::Error, "is a glass"));
  // It warms: the temperatures settle, the energy closes. Windows are 1/90 of the passing of an
  // element, so that the mean heat is followed slowly (decision 812).
  const testing::Ran ran = testing::run_deck(
      deck_of(type, with(warmed, {{"maxStps", "600"}, {"nStps", "10"}})), folder / type);
  INFO(ran.outcome.message);
  CHECK(ran.outcome.status == runs::RunStatus::Done);
  CHECK(ran.print.find("temperatures settled at thermal step") != std::string::npos);
}

}  // namespace

TEST_CASE("check: rollers, thermal steps from oil too thick for a film → allowed, a glass → error",
          "[physics][film][check][thermal]") {
  check_thick_oil("cylindrical");
}

TEST_CASE("check: balls, thermal steps from oil too thick for a film → allowed, a glass → error",
          "[physics][film][check][thermal][slow][nightly]") {
  check_thick_oil("ball");
}

TEST_CASE("run: thermal steps that cool the oil into a glass → run ends with that message",
          "[physics][film][thermal]") {
  const Sets cooled{{"mode", "0"},        {"kTherm", "1"},         {"kCoolant", "4"},
                    {"kBaseTemp", "3"},   {"kHTC", "0"},           {"kGeoMod", "0"},
                    {"baseTemp", "100."}, {"cFlowRate", "1.0e-3"}, {"aveTime", "2.0e-6"},
                    {"skipTime", "0.0"},  {"maxStps", "100"},      {"nStps", "10"},
                    {"reHTC", "1.0e6"},   {"cageHTC", "1.0e6"},    {"rpm2", "100.0"}};
  // Slow: at the deck's 10,000 rpm the oil, thicker and thicker, makes some kW and keeps itself
  // above its glass (130 K).
  const testing::TemporaryFolder folder;
  const testing::Ran ran =
      testing::run_deck(deck_of("ball", with(with(cooled, in_oil(4)), at(330.0))), folder / "cold");
  CHECK(ran.outcome.status == runs::RunStatus::Failed);
  CHECK_THAT(ran.outcome.message,
             Catch::Contains("after thermal step") && Catch::Contains("is a glass"));
}

TEST_CASE("check: cold oil at the cage and in the cavity → checked too", "[physics][film][check]") {
  const Sets oil = with({{"mode", "0"}}, in_oil(4));
  const auto found = [&](const Sets& more) { return checked("ball", with(oil, more)); };
  const Sets films{{"kPocHydro", "1"}, {"pocLubFilm", "1.0e-4"}};
  CHECK(found(films).ok());
  const runs::CheckReport cold = found(with(films, {{"cageTemp", "95.0"}}));
  INFO(to_text({cold.issues.begin(), cold.issues.end()}));
  CHECK(says(cold, Severity::Error, "kPocHydro = 1: "));
  CHECK(says(cold, Severity::Error, "does not flow"));
  const runs::CheckReport churned = found({{"kChrn", "1"},
                                           {"denRatio", "0.1"},
                                           {"visRatio", "0.1"},
                                           {"raceTemp1", "95.0"},
                                           {"raceTemp2", "95.0"},
                                           {"reTemp", "95.0"},
                                           {"strParam", "0.0"}});
  INFO(to_text({churned.issues.begin(), churned.issues.end()}));
  CHECK(says(churned, Severity::Error, "kChrn = 1: "));
}

TEST_CASE("check: churning medium outside its range → warning", "[physics][check]") {
  const Sets churning{{"mode", "-1"}, {"kChrn", "14"}, {"denRatio", "0.1"}, {"visRatio", "0.1"}};
  CHECK(says(checked("ball", with(churning, at(450.0))), Severity::Warning,
             "the churning medium, are known from"));
  CHECK_FALSE(says(checked("ball", with(churning, at(320.0))), Severity::Warning,
                   "the churning medium, are known from"));
}

TEST_CASE("check: coolant without heat capacity → error before the run", "[unit][check][thermal]") {
  for (const char* mode : {"-1", "0"})
    for (const char* name : {"reHTC", "cageHTC"}) {
      CAPTURE(mode, name);
      Sets sets{{"mode", mode},          {"kTherm", "1"},      {"kCoolant", "14"},
                {"kBaseTemp", "3"},      {"baseTemp", "330."}, {"kHTC", "1"},
                {"cFlowRate", "1.0e-5"}, {"reHTC", "100."},    {"aveTime", "1.0e-4"},
                {"cageHTC", "100."}};
      {
        const runs::CheckReport good = checked("ball", sets);
        INFO(to_text({good.issues.begin(), good.issues.end()}));
        CHECK(good.ok());
      }
      sets.emplace_back(name, "0.0");
      CHECK(says(checked("ball", sets), Severity::Error,
                 std::string(name) + " = 0.0: prevents heat transfer to the coolant"));
    }
}

TEST_CASE("check: every lubricant, medium and coolant → provenance reported",
          "[validation][film][check][thermal]") {
  // A motion, whose listing has no page of friction and no network before its first thermal step.
  const auto said = [](const Sets& sets, const std::string& name, const std::string& what,
                       const std::string& provenance) {
    CAPTURE(name, what, provenance);
    CHECK((provenance == "seen" || provenance == "recalled" || provenance == "estimated"));
    const runs::CheckReport report = checked("ball", sets);
    INFO(to_text({report.issues.begin(), report.issues.end()}));
    CHECK(report.ok());
    const std::string start = "the properties of " + name + " (" + what + ") ";
    CHECK(says(report, Severity::Note, start + "are partly estimates") ==
          (provenance == "estimated"));
    CHECK(says(report, Severity::Note, start + "are partly not verified") ==
          (provenance == "recalled"));
  };
  int estimated = 0;
  for (const int code : tribology::lubricant_codes()) {
    const tribology::Lubricant& oil = tribology::lubricant(code);
    said(with({{"mode", "-1"}}, with(in_oil(code), at(330.0))), oil.name, "the lubricant",
         oil.provenance);
    for (const tribology::LubricantSource& source : oil.sources)
      estimated += source.provenance == "estimated" ? 1 : 0;
  }
  CHECK(estimated > 100);
  for (int code = 3; code <= 14; ++code) {
    const tribology::FluidProperties fluid = tribology::fluid_properties(code, 100.0);
    const std::string number = std::to_string(code);
    said({{"mode", "0"}, {"kChrn", number}, {"denRatio", "0.1"}, {"visRatio", "1.0"}}, fluid.name,
         "the churning medium", fluid.provenance);
    const double inlet = std::max(fluid.T_min + 5.0, 20.0);
    said({{"mode", "0"},
          {"kTherm", "1"},
          {"kCoolant", number},
          {"kBaseTemp", "3"},
          {"baseTemp", fmt::format("{}", inlet)},
          {"kHTC", "0"},
          {"cFlowRate", "1.0e-4"},
          {"aveTime", "1.0e-4"}},
         fluid.name, "the coolant", fluid.provenance);
  }
}

TEST_CASE("plan: motion with a thermal analysis → has a plan", "[unit][thermal]") {
  for (const char* type : {"ball", "cylindrical"}) {
    CAPTURE(type);
    const Sets sets{{"mode", "0"},           {"kTherm", "1"},       {"kCoolant", "14"},
                    {"kBaseTemp", "3"},      {"baseTemp", "330."},  {"kHTC", "0"},
                    {"cFlowRate", "1.0e-4"}, {"aveTime", "1.0e-4"}, {"kPltFreq", "1"}};
    const runs::Prepared prepared = runs::prepare(request_of(deck_of(type, sets)));
    const runs::DiskUse use = runs::disk_use(prepared, runs::plan_with_estimates(prepared));
    CHECK(use.total() > 1e3);
  }
}
