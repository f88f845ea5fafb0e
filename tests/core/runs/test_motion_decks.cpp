#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "runs/check.hpp"
#include "runs/plan.hpp"
#include "runs/prepare.hpp"
#include "runs/run.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <numbers>

/// Decks that let races move, excite or suppress motions, and the constrained modes.
using namespace adore;
using deck::Deck;
using testing::Ran;
using testing::run_deck;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

Deck ball(const Sets& sets) {
  Deck deck = deck::new_deck("ball");
  Sets all{{"maxStps", "40"},
           {"nStps", "2"},
           {"kPltFreq", "10"},
           {"kNumPltElem", "2"},
           {"kPltElemInd", "1,15"}};
  all.insert(all.end(), sets.begin(), sets.end());
  deck.set_all(all);
  return deck;
}

/// The inner race carried by the bearing itself: free along all axes, driven at its speed.
const Sets kShaft{{"kDCR", "1"}, {"kFD12", "0"}, {"kFD22", "0"}, {"kFD32", "0"}};

Sets with(Sets sets, const Sets& more) {
  sets.insert(sets.end(), more.begin(), more.end());
  return sets;
}

runs::DeckRequest request_of(const Deck& deck) {
  runs::DeckRequest request;
  request.text = deck::write_deck(deck);
  return request;
}

runs::Prepared prepared(const Sets& sets) { return runs::prepare(request_of(ball(sets))); }

std::string refusal(const Sets& sets) {
  try {
    (void)prepared(sets);
  } catch (const InputError& error) {
    return error.what();
  }
  return "was accepted";
}

std::string warnings(const Sets& sets) {
  std::string out;
  for (const Issue& issue : prepared(sets).input.warnings)
    out += issue.variable + " " + issue.message + "\n";
  return out;
}

}  // namespace

TEST_CASE("ball deck: every excitation and constraint → runs, energy ledger closes",
          "[validation][motions]") {
  const testing::TemporaryFolder folder;
  const std::pair<const char*, Sets> cases[] = {
      {"rotating load", {{"kVarLoad", "1"}, {"rotLoadFrac2", "0.5"}, {"rotLoadRpm2", "10000"}}},
      {"vibration",
       {{"kVarLoad", "2"},
        {"raceVibAmp12", "1e-7"},
        {"raceVibAmp31", "2e-7"},
        {"raceVibFreq1", "900"},
        {"raceVibFreq2", "500"}}},
      {"ramp from rest",
       {{"kVarSpeed", "1"}, {"rpm2", "0"}, {"raceAngAcc2", "1e6"}, {"endTime2", "0.5"}}},
      {"speed through zero",
       {{"kVarSpeed", "2"}, {"raceSpeedAmp2", "20000"}, {"raceSpeedFreq2", "900"}}},
      {"turning frame",
       {{"kRotFrame", "1"},
        {"brgOrbitRad", "0.05"},
        {"brgAngVel", "2000"},
        {"brgLoadFrac1", "0.3"},
        {"brgLoadFrac2", "0.5"}}},
      {"shaft-like", with(kShaft, {{"kRaceIP2", "1"},
                                   {"raceMass2", "0.8"},
                                   {"raceMIx2", "6e-4"},
                                   {"raceMIy2", "5e-4"},
                                   {"raceMIz2", "5e-4"},
                                   {"raceGeoCenZ2", "-2e-6"}})},
      {"shaft under a load that turns",
       with(kShaft, {{"kVarLoad", "1"}, {"rotLoadFrac2", "1"}, {"rotLoadRpm2", "10000"}})},
      {"run-up of a shaft",
       with(kShaft, {{"kVarSpeed", "1"}, {"raceAngAcc2", "1e6"}, {"endTime2", "1"}})},
      {"floating",
       {{"kDCR", "1"},
        {"kFD11", "0"},
        {"kFD21", "0"},
        {"kFD31", "0"},
        {"kMD11", "0"},
        {"kMD22", "0"},
        {"kMD32", "0"}}},
      {"kDOF 1", {{"kDOF", "1"}}},
      {"kDOF 2", {{"kDOF", "2"}}},
      {"kDOF 3", {{"kDOF", "3"}}},
      {"kDOF 4", {{"kDOF", "4"}}},
      {"kDOF 5", {{"kDOF", "5"}}},
      {"mode 1", {{"mode", "1"}}},
      {"mode 2", {{"mode", "2"}}},
      {"mode 2, axial held", {{"mode", "2"}, {"kDOF", "1"}}},
      {"mode 1 in a turning frame",
       {{"mode", "1"}, {"kRotFrame", "1"}, {"brgOrbitRad", "0.05"}, {"brgAngVel", "2000"}}},
      {"unbalanced cage",
       {{"kCageIP", "1"},
        {"cageMass", "0.02"},
        {"cageMIx", "2e-5"},
        {"cageMIy", "1.2e-5"},
        {"cageMIz", "1.1e-5"},
        {"cageGeoCenZ", "1e-5"},
        {"cageFrameY", "0.2"}}},
      {"conical cage", {{"cageConeAng", "3"}}},
  };
  for (const auto& [name, sets] : cases) {
    INFO(name);
    const Ran ran = run_deck(ball(sets), folder / name);
    CHECK(ran.outcome.status == runs::RunStatus::Done);
    CHECK(ran.outcome.steps == 40);
    CHECK(std::abs(ran.outcome.energy_residual) < 1e-4 * ran.outcome.energy_scale);
    CHECK(ran.report.at("status") == "done");
  }
}

TEST_CASE("roller deck: constraints, turning frame and given inertia → energy ledger closes",
          "[validation][motions][rollers]") {
  const testing::TemporaryFolder folder;
  const auto cylindrical = [](const Sets& sets) {
    Deck deck = deck::new_deck("cylindrical");
    deck.set_all(with(
        {{"maxStps", "40"}, {"nStps", "2"}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}}, sets));
    return deck;
  };
  const double plain = run_deck(cylindrical({}), folder / "plain").outcome.energy_scale;
  const std::pair<const char*, Sets> cases[] = {
      {"kDOF 2", {{"kDOF", "2"}}},
      {"kDOF 4", {{"kDOF", "4"}}},
      {"kDOF 5", {{"kDOF", "5"}}},
      {"turning frame",
       {{"kRotFrame", "1"},
        {"brgOrbitRad", "0.05"},
        {"brgAngVel", "2000"},
        {"brgLoadFrac2", "0.5"}}},
      {"shaft-like", kShaft},
      {"mode 1", {{"mode", "1"}}},
      {"mode 2", {{"mode", "2"}}},
      {"lightly loaded rollers held", {{"qFac", "0.1"}}},
      {"twice the inertia",
       {{"kReIP", "2"},
        {"bReMass", "0.018"},
        {"bReMIx", "2.7e-7"},
        {"bReMIy", "3.5e-7"},
        {"bReMIz", "3.5e-7"}}},
  };
  for (const auto& [name, sets] : cases) {
    const Ran ran = run_deck(cylindrical(sets), folder / name);
    INFO(name << ": residual " << ran.outcome.energy_residual << " of " << ran.outcome.energy_scale
              << " J, plain " << plain << " J");
    CHECK(ran.outcome.status == runs::RunStatus::Done);
    CHECK(std::abs(ran.outcome.energy_residual) < 1e-4 * ran.outcome.energy_scale);
    CHECK(ran.outcome.energy_scale != plain);  // it acts
  }
}

TEST_CASE("free race: rotating fraction of its radial load turns at its speed", "[unit][motions]") {
  constexpr double kShare = 0.4, kSpeed = 9000.0 * std::numbers::pi / 30.0, kMass = 0.8;
  const runs::Prepared p = prepared(with(kShaft, {{"kRaceIP2", "1"},
                                                  {"raceMass2", "0.8"},
                                                  {"raceMIx2", "6e-4"},
                                                  {"raceMIy2", "5e-4"},
                                                  {"raceMIz2", "5e-4"},
                                                  {"appLoadY", "300"},
                                                  {"appLoadZ", "500"},
                                                  {"kVarLoad", "1"},
                                                  {"rotLoadFrac2", "0.4"},
                                                  {"rotLoadRpm2", "9000"}}));
  dynamics::System system = runs::make_system(p);
  const std::vector<double> y = system.initial_state();
  std::vector<double> at_start(y.size()), later(y.size());
  system.set_start(0.0, y);
  int first = -1;
  for (const dynamics::StateLayout::Group& group : system.layout().groups())
    if (group.name == "inner race.velocity") first = group.slice.first;
  REQUIRE(first >= 0);
  system.rhs(0.0, y.data(), at_start.data());
  // The same state at another time: what differs is the load.
  for (const double turn : {0.5, 2.0, 4.5}) {
    system.rhs(turn / kSpeed, y.data(), later.data());
    const auto change = [&](int k) {
      const auto at = static_cast<std::size_t>(first + k);
      return kMass * (later[at] - at_start[at]);
    };
    const double c = std::cos(turn) - 1.0, s = std::sin(turn);
    CHECK(change(0) == Approx(0.0).margin(1e-6));
    CHECK(change(1) == Approx(kShare * (c * 300.0 - s * 500.0)).epsilon(1e-9));
    CHECK(change(2) == Approx(kShare * (s * 300.0 + c * 500.0)).epsilon(1e-9));
  }
}

TEST_CASE("incompatible values → rejected with the variable; open conditions → reported",
          "[unit][motions]") {
  CHECK_THAT(refusal({{"kDOF", "6"}}), Catch::Contains("kDOF") && Catch::Contains("ADRX1"));
  const Sets vibrating = with(kShaft, {{"kVarLoad", "2"}, {"raceVibAmp32", "1e-6"}});
  CHECK_THAT(refusal(vibrating), Catch::Contains("raceVibAmp32") && Catch::Contains("kFD32"));
  // A load turns where the race is free along y and z, a place where it is free along neither.
  CHECK_THAT(refusal({{"kDCR", "1"}, {"kFD22", "0"}, {"kVarLoad", "1"}, {"rotLoadFrac2", "0.1"}}),
             Catch::Contains("rotLoadFrac2") && Catch::Contains("kFD22"));
  CHECK(refusal(with(kShaft, {{"kVarLoad", "1"}, {"rotLoadFrac2", "0.1"}})) == "was accepted");
  CHECK_THAT(refusal({{"kDCR", "1"}, {"kMD12", "0"}, {"kVarSpeed", "1"}, {"raceAngAcc2", "1"}}),
             Catch::Contains("raceAngAcc2") && Catch::Contains("kMD12"));
  CHECK_THAT(warnings({{"kDCR", "1"}, {"kMD12", "0"}}),
             Catch::Contains("kMD12") && Catch::Contains("friction slows it down"));
  CHECK_THAT(refusal({{"mode", "1"}, {"kDOF", "5"}}), Catch::Contains("kDOF"));
  CHECK_THAT(refusal({{"mode", "2"}, {"kDCR", "1"}, {"kMD22", "0"}, {"kMD32", "0"}}),
             Catch::Contains("kMD22") && Catch::Contains("mode = 2"));
  CHECK_THAT(refusal({{"mode", "2"}, {"kVarLoad", "2"}, {"raceVibAmp12", "1e-6"}}),
             Catch::Contains("raceVibAmp12"));
  CHECK_THAT(refusal({{"mode", "2"}, {"kFS2", "1"}, {"kVarLoad", "1"}, {"rotLoadFrac2", "0.1"}}),
             Catch::Contains("rotLoadFrac2") && Catch::Contains("kFS2"));
  CHECK_THAT(refusal({{"mode", "1"}, {"kDCR", "1"}, {"kFD12", "0"}}),
             Catch::Contains("kFD12") && Catch::Contains("in mode 1, a race cannot accelerate"));
  CHECK_THAT(warnings({{"mode", "1"}, {"kRaceIP2", "1"}}),
             Catch::Contains("kRaceIP2") && Catch::Contains("no effect"));
  // The plan tells the same.
  const runs::Prepared shaft = prepared(kShaft);
  const std::string plan = runs::plan_text(shaft, shaft.plan);
  CHECK_THAT(plan, Catch::Contains("free along x, y and z, fixed about x, y and z"));
  CHECK_THAT(plan, Catch::Contains("races that move under loads"));
  CHECK(shaft.plan.race_motions.free[1]->force == bearing::Vec3(1500.0, 0.0, 500.0));
  const runs::Prepared floating = prepared({{"kDCR", "1"}, {"kFD31", "0"}});
  CHECK(floating.plan.race_motions.free[0]->force == bearing::Vec3(0.0, 0.0, -500.0));
  const runs::Prepared constrained = prepared({{"mode", "2"}});
  CHECK_THAT(runs::plan_text(constrained, constrained.plan),
             Catch::Contains("in force balance along x, y and z"));
}

TEST_CASE("turning frame: loads the bearing by the fractions of the races", "[physics][motions]") {
  const Sets frame{
      {"kRotFrame", "1"}, {"brgOrbitRad", "0.1"}, {"brgAngVel", "1500"}, {"brgAngPos", "90"}};
  const auto load = [&](const char* outer, const char* inner) {
    const runs::Prepared p =
        prepared(with(frame, {{"brgLoadFrac1", outer}, {"brgLoadFrac2", inner}}));
    const double w = 1500.0 * std::numbers::pi / 30.0;
    return std::pair{p.bearing.constraints.load,
                     std::array<double, 2>{p.bearing.race_inertia[0].mass * w * w * 0.1,
                                           p.bearing.race_inertia[1].mass * w * w * 0.1}};
  };
  const auto [none, force] = load("0", "0");
  CHECK(none[1] == 0.0);
  // At 90 degrees outward is -y.
  CHECK(load("0", "0.5").first[1] == Approx(-0.5 * force[1]));
  CHECK(load("0.25", "0").first[1] == Approx(0.25 * force[0]));
  CHECK(load("0.25", "0").first[2] == Approx(500.0));
}

TEST_CASE("moving races: run continues where it stopped", "[validation][motions]") {
  const testing::TemporaryFolder folder;
  const Sets moving = with(kShaft, {{"kVarSpeed", "1"},
                                    {"raceAngAcc2", "1e6"},
                                    {"endTime2", "1"},
                                    {"raceAngAcc1", "-3e5"},
                                    {"endTime1", "1e-4"}});
  const Sets two{{"mode", "2"}};
  int k = 0;
  for (const Sets& sets : {moving, two}) {
    INFO("case " << k);
    const fs::path whole = folder / ("whole" + std::to_string(k)),
                   parts = folder / ("parts" + std::to_string(k));
    ++k;
    const Ran unbroken = run_deck(ball(sets), whole);
    Deck first = ball(sets);
    first.set("maxStps", "20");
    (void)run_deck(first, parts);
    const Ran rest = run_deck(ball(with(sets, {{"kIcOpt", "0"}})), parts, true);
    CHECK(rest.outcome.steps == 40);
    CHECK(rest.outcome.revolutions == Approx(unbroken.outcome.revolutions).epsilon(1e-12));
    CHECK(testing::read_bytes(whole / "SOL2") == testing::read_bytes(parts / "SOL2"));
    const auto state = [](const fs::path& file) {
      const std::string text = testing::read_bytes(file);
      return text.substr(0, text.find("\ndeck "));
    };
    CHECK(state(whole / "FINAL") == state(parts / "FINAL"));
  }
}

TEST_CASE("law of the races with zero amplitude → off, without cost", "[deck][motion]") {
  // Each code, what it would do, and a value with which it does that.
  const std::vector<std::tuple<Sets, std::string, Sets>> laws{
      {{{"kVarLoad", "1"}}, "rotating load", {{"rotLoadFrac2", "0.5"}, {"rotLoadRpm2", "9000"}}},
      {{{"kVarLoad", "2"}}, "race vibration", {{"raceVibAmp32", "1e-6"}, {"raceVibFreq2", "500"}}},
      {{{"kVarSpeed", "1"}}, "varying race speed", {{"raceAngAcc2", "100"}, {"endTime2", "1"}}},
      {{{"kVarSpeed", "2"}},
       "varying race speed",
       {{"raceSpeedAmp2", "10"}, {"raceSpeedFreq2", "50"}}},
      {{{"kRotFrame", "1"}}, "rotating base frame", {{"brgAngVel", "500"}}}};
  for (const auto& [code, name, acting] : laws)
    for (const bool acts : {false, true}) {
      const nlohmann::ordered_json plan =
          runs::plan(request_of(ball(acts ? with(code, acting) : code))).json;
      INFO(code.front().first << " = " << code.front().second << (acts ? ", acting" : ""));
      bool found = false;
      for (const auto& effect : plan.at("effects"))
        if (effect.at("name") == name) {
          found = true;
          CHECK(effect.at("on") == acts);
          const std::string because = effect.at("because");
          CHECK((because.find(" 0") != std::string::npos) != acts);
        }
      CHECK(found);
    }
}
