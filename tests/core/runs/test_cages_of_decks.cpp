#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/channels.hpp"
#include "results/full_precision.hpp"
#include "results/h5_file.hpp"
#include "results/sol_file.hpp"
#include "runs/motion_watch.hpp"
#include "runs/prepare.hpp"
#include "runs/run.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

/// Decks with segmented cages, without cage, and with unbalanced elements.
using namespace adore;
using deck::Deck;
using testing::Ran;
using testing::refusal_of;
using testing::run_deck;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

/// Later values replace earlier ones.
Sets with(Sets sets, const Sets& more) {
  for (const auto& [name, value] : more) {
    const auto found =
        std::find_if(sets.begin(), sets.end(), [&](const auto& set) { return set.first == name; });
    if (found == sets.end())
      sets.emplace_back(name, value);
    else
      found->second = value;
  }
  return sets;
}

Deck deck_of(const char* type, const Sets& sets) {
  Deck deck = deck::new_deck(type);
  deck.set_all(with({{"maxStps", "30"}, {"nStps", "2"}, {"kPltFreq", "10"}}, sets));
  return deck;
}

/// Three segments of four pockets, cut between the pockets (or through them).
Sets segments(bool through) {
  const std::string sign = through ? "-" : "";
  return {{"nCseg", "3"},           {"cageAngCut", "1"},
          {"lSeg[1]", sign + "2"},  {"lSeg[2]", sign + "6"},
          {"lSeg[3]", sign + "10"}, {"avRatio[1]", "0.98"},
          {"avRatio[2]", "1"},      {"avRatio[3]", "1.02"},
          {"kNumPltElem", "3"},     {"kPltElemInd", "1,13,15"}};
}

}  // namespace

TEST_CASE("segmented cage: deck runs, and its files have every segment", "[validation][cage]") {
  for (const bool through : {false, true}) {
    const testing::TemporaryFolder folder;
    const fs::path here = folder / "run";
    const Ran ran = run_deck(deck_of("ball", segments(through)), here);
    INFO("through pockets " << through);
    // Segments at speeds of their own collide at once: 2e-5 at the tolerance of the example deck.
    CHECK(std::abs(ran.outcome.energy_residual) < 1e-4 * ran.outcome.energy_scale);
    // Element 13 is segment 1, 15 segment 3; both have four pockets, cut ones four and a half more.
    const results::SolFile sol = results::read_sol(here / "SOL2");
    CHECK(sol.header.segments == 3);
    CHECK(sol.header.per_segment == 4);
    CHECK(sol.header.title == "Cage Segment 1");
    CHECK(sol.header.value_count == 24 + 4 * (through ? 5 : 4));
    CHECK(results::read_sol(here / "SOL3").header.title == "Cage Segment 3");
    for (const char* text :
         {"segment 3", "Segments 3 and 1", "Initial state of the cage segment 2"})
      CHECK_THAT(ran.print, Catch::Contains(text));
    CHECK((ran.print.find("end 3") != std::string::npos) == through);
    // The first segment begins with element 2: RESULTS.h5 says so, and gives every file its digits.
    for (const char* name : {"SOL1", "SOL2", "SOL3"}) {
      results::SolFile file = results::read_sol(here / name);
      CHECK(results::use_full_precision(file).why_not == "");
    }
    results::SolFile third = results::read_sol(here / "SOL3");
    (void)results::use_full_precision(third);
    CHECK(third.header.first_pocket == 1);
    std::vector<std::size_t> rows;  // of the forces in its pockets: elements 10, 11, 12, 1
    for (const results::SolColumn& column : results::sol_columns(third.header))
      if (column.id.starts_with("pocket.force.")) rows.push_back(column.at);
    rows.resize(4);
    CHECK(rows == std::vector<std::size_t>{9, 10, 11, 0});
  }
}

TEST_CASE("segmented cage: run continues from its last state", "[validation][cage]") {
  const testing::TemporaryFolder folder;
  const Sets sets = segments(true);
  const Ran whole = run_deck(deck_of("ball", with(sets, {{"maxStps", "40"}})), folder / "whole");
  (void)run_deck(deck_of("ball", with(sets, {{"maxStps", "20"}})), folder / "parts");
  Deck rest = deck_of("ball", with(sets, {{"maxStps", "20"}, {"kIcOpt", "1"}}));
  const Ran parts = run_deck(rest, folder / "parts");
  CHECK(parts.outcome.steps == whole.outcome.steps);
  CHECK(parts.outcome.time == Approx(whole.outcome.time).epsilon(1e-6));
}

namespace {

/// Accurate enough to tell a missing item of the ledger; the examples' own settings are quicker.
const Sets kAccurate{{"intMet", "5"}, {"stpMax", "0.5"}, {"tol", "1e-6"}};

}  // namespace

TEST_CASE("rollers with segments or without cage: run, and energy ledger closes",
          "[validation][cage][rollers]") {
  for (const char* type : {"cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    const testing::TemporaryFolder folder;
    for (const bool cage : {true, false}) {
      const Sets sets = cage
                            ? Sets{{"nRe", "12"},       {"nCseg", "2"},       {"cageAngCut", "0.5"},
                                   {"lSeg[1]", "1"},    {"lSeg[2]", "7"},     {"avRatio[1]", "1"},
                                   {"avRatio[2]", "1"}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}}
                            : Sets{{"nCseg", "0"}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}};
      const Ran ran =
          run_deck(deck_of(type, with(sets, kAccurate)), folder / (cage ? "segments" : "none"));
      INFO(type << (cage ? " in segments" : " without cage") << ": residual "
                << ran.outcome.energy_residual << " of " << ran.outcome.energy_scale);
      CHECK(std::abs(ran.outcome.energy_residual) < 1e-5 * ran.outcome.energy_scale);
    }
  }
}

TEST_CASE("elements in balance: cut pockets and no cage → run", "[validation][cage][held]") {
  for (const char* type : {"ball", "cylindrical", "tapered"})
    for (const bool cage : {true, false})
      for (const auto& [name, value] :
           {std::pair{"mode", "1"}, std::pair{"mode", "2"}, std::pair{"qFac", "0.05"}}) {
        const testing::TemporaryFolder folder;
        const Sets cut{{"nRe", "12"},       {"nCseg", "2"},       {"cageAngCut", "0.5"},
                       {"lSeg[1]", "-1"},   {"lSeg[2]", "-7"},    {"avRatio[1]", "1"},
                       {"avRatio[2]", "1"}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}};
        const Sets sets =
            cage ? cut : Sets{{"nCseg", "0"}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}};
        const Ran ran =
            run_deck(deck_of(type, with(with(sets, kAccurate), {{name, value}})), folder / "run");
        INFO(type << ", " << name << " = " << value << (cage ? " in segments" : " without cage")
                  << ": residual " << ran.outcome.energy_residual << " of "
                  << ran.outcome.energy_scale);
        CHECK(std::abs(ran.outcome.energy_residual) < 1e-5 * ran.outcome.energy_scale);
      }
}

TEST_CASE("unequal, unbalanced and single deviating elements: run from decks",
          "[validation][rigid]") {
  const Sets ball{{"bReMass", "8.4e-3"}, {"bReMIx", "1.3e-7"},   {"bReMIy", "1.35e-7"},
                  {"bReMIz", "1.4e-7"},  {"bReGeoCenX", "1e-6"}, {"bReGeoCenZ", "2e-6"},
                  {"bReFrameY", "5"}};
  const Sets roller{{"bReMass", "8e-3"},  {"bReMIx", "1.2e-7"},   {"bReMIy", "1.4e-7"},
                    {"bReMIz", "1.5e-7"}, {"bReGeoCenX", "1e-5"}, {"bReGeoCenY", "2e-6"},
                    {"bReFrameX", "20"}};
  const std::pair<const char*, Sets> motions[] = {
      {"free", {}},
      {"mode 1", {{"mode", "1"}}},
      {"light ones held", {{"qFac", "0.05"}}},
      {"kDOF 2", {{"kDOF", "2"}}},
      {"mode 2, kDOF 4", {{"mode", "2"}, {"kDOF", "4"}}},
      {"kDOF 5", {{"kDOF", "5"}}}};
  for (const char* code : {"1", "2"})
    for (const auto& [type, sets] : {std::pair{"ball", ball}, {"tapered", roller}})
      for (const auto& [motion, more] : motions) {
        const testing::TemporaryFolder folder;
        const Ran ran =
            run_deck(deck_of(type, with(with(with({{"kReIP", code}}, sets), kAccurate), more)),
                     folder / "run");
        INFO(type << ", kReIP = " << code << ", " << motion);
        CHECK(std::abs(ran.outcome.energy_residual) < 1e-5 * ran.outcome.energy_scale);
      }
}

TEST_CASE("balls of unequal diameter: run from decks", "[validation][imperfections]") {
  const Sets random{{"kReGeoImp", "1"}, {"reDiaVar", "1e-6"}};
  const Sets listed{{"kReGeoImp", "2"}, {"reDiaVar1", "2e-6"}, {"reDiaVar4", "-1e-6"}};
  const std::pair<const char*, Sets> motions[] = {
      {"random", random},
      {"listed", listed},
      {"mode 1", with({{"mode", "1"}}, listed)},
      {"mode 2", with({{"mode", "2"}}, random)},
      {"light ones held", with({{"qFac", "0.05"}}, random)},
      {"wavy races", with({{"kRaceGeoImp1", "2"},
                           {"rndVar11", "1e-6"},
                           {"rndVar21", "7"},
                           {"cFacVar11", "0.002"},
                           {"cFacVar21", "3"}},
                          random)},
      {"segments", with(segments(true), listed)},
      {"without cage", with({{"nCseg", "0"}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}}, listed)},
      {"turning frame", with({{"kRotFrame", "1"}, {"brgAngVel", "500"}}, listed)},
      {"own inertia", with({{"kReIP", "1"},
                            {"bReMass", "8.4e-3"},
                            {"bReMIx", "1.3e-7"},
                            {"bReMIy", "1.3e-7"},
                            {"bReMIz", "1.3e-7"}},
                           random)}};
  for (const auto& [motion, sets] : motions) {
    const testing::TemporaryFolder folder;
    const Ran ran = run_deck(deck_of("ball", sets), folder / "run");
    INFO(motion << ": residual " << ran.outcome.energy_residual << " of "
                << ran.outcome.energy_scale);
    CHECK(ran.outcome.status == runs::RunStatus::Done);
    CHECK(std::abs(ran.outcome.energy_residual) < 1e-4 * ran.outcome.energy_scale);
  }
}

TEST_CASE("segments: unsupported features → rejected with the reason", "[unit][cage]") {
  CHECK_THAT(refusal_of(deck_of("ball", with(segments(false), {{"cageAngCut", "20"}}))),
             Catch::Contains("is wider than the bars") && Catch::Contains("give at most"));
  CHECK_THAT(refusal_of(deck_of("ball", with(segments(true), {{"cageAngCut", "20"}}))),
             Catch::Contains("touches the rolling element on both sides"));
}

TEST_CASE("cage: strain limit exceeded → reported as yielding", "[validation][cage]") {
  const testing::TemporaryFolder folder;
  const Sets wild{{"avRatio", "2.5"},  {"maxStps", "60"},  {"kCageMat", "1"},
                  {"cageDen", "7800"}, {"cageEM", "2e11"}, {"cagePR", "0.3"},
                  {"cageH", "20"},     {"cageTC", "40"},   {"cageSH", "450"}};
  const auto warnings = [&](const char* limit) {
    std::string out;
    const Ran ran = run_deck(deck_of("ball", with(wild, {{"cageESL", limit}})), folder / limit);
    for (const Issue& issue : ran.outcome.warnings) out += issue.message + "\n";
    return out;
  };
  CHECK_THAT(warnings("1e-5"), Catch::Contains("the cage (given in the deck) yields"));
  CHECK_THAT(warnings("0.5"), !Catch::Contains("The worst case is"));
}

TEST_CASE("roller pocket: contact length is that of the guide faces", "[unit][cage]") {
  runs::DeckRequest request;
  request.text = deck::write_deck(deck_of("cylindrical", {}));
  bearing::Bearing bearing = runs::prepare(request).bearing;
  bearing.cage->material.elastic_strain_limit = 1e-9;
  scene::Snapshot at;
  at.elements.resize(static_cast<std::size_t>(bearing.element_count()));
  at.elements[2].pocket.resize(1);
  at.elements[2].pocket[0].force = 40.0;
  const auto pressure = [&](std::vector<double> lengths) {  // [MPa]
    bearing.cage->pocket_faces.clear();
    for (const double length : lengths)
      bearing.cage->pocket_faces.push_back({{}, {}, 1e-3, length});
    runs::MotionLimitMonitor watch(bearing);
    watch.check(at);
    for (const Finding& finding : watch.findings(results::UnitSystem::SI))
      if (const auto place = finding.message.find("at a pressure of "); place != std::string::npos)
        return std::stod(finding.message.substr(place + 17));
    return 0.0;
  };
  const double L = bearing.rollers()->length, whole = pressure({});
  // p = sqrt(q E*/(pi R)), q the force over the length.
  const double E_star = bearing::contact_modulus(bearing.element_material, bearing.cage->material);
  CHECK(whole == Approx(1e-6 * std::sqrt(40.0 / L * E_star * 2.0 / bearing.element_diameter() /
                                         std::numbers::pi))
                     .epsilon(1e-3));
  CHECK(pressure({L / 4.0}) == Approx(2.0 * whole).epsilon(1e-3));
  CHECK(pressure({L / 9.0, L / 4.0}) == Approx(2.0 * whole).epsilon(1e-3));
  CHECK(pressure({2.0 * L}) == Approx(whole).epsilon(1e-3));
}

TEST_CASE("cage without a guide land: passes through a race → reported", "[physics][cage][watch]") {
  runs::DeckRequest request;
  request.text = deck::write_deck(deck_of("spherical", {}));
  bearing::Bearing bearing = runs::prepare(request).bearing;
  REQUIRE(bearing.cage->lands.empty());
  bearing.cage->clearance_outer = 3e-3;
  bearing.cage->clearance_inner = 4e-3;
  const auto reported = [&](double away) {
    scene::Snapshot at;
    at.elements.resize(static_cast<std::size_t>(bearing.element_count()));
    at.cages.resize(1);
    at.races[0].position = at.races[1].position = scene::Vec3(0.0, 1e-3, 0.0);
    at.cages[0].position = scene::Vec3(0.0, 1e-3, -away);
    runs::MotionLimitMonitor watch(bearing);
    watch.check(at);
    return watch.findings(results::UnitSystem::SI);
  };
  CHECK(reported(1.49e-3).empty());
  REQUIRE(reported(1.51e-3).size() == 1);
  CHECK_THAT(reported(1.51e-3).front().message,
             Catch::Contains("outer race") && Catch::Contains("0.00151"));
  CHECK(reported(2.01e-3).size() == 2);
  bearing.cage->lands.emplace_back().guide = bearing::GuideLand::Guide::Outer;
  CHECK(reported(1.51e-3).empty());
}

TEST_CASE("centered cage overlapped by elements → rejected with the clearance",
          "[validation][cage]") {
  const auto refused = [](const Deck& deck) -> std::string {
    const testing::TemporaryFolder folder;
    try {
      (void)run_deck(deck, folder / "run");
    } catch (const InputError& error) {
      return error.what();
    }
    return "ran";
  };
  // No axial play in rectangular ball pockets, whatever record 9.6 does across the axis.
  CHECK_THAT(refused(deck_of("ball", {{"kPocType", "3"}, {"bPocCls2", "0"}})),
             Catch::Contains("bPocCls2") && Catch::Contains("more clearance"));
  CHECK_THAT(refused(deck_of("ball", {{"cageGcPos", "0,0,-3e-4"}})),
             Catch::Contains("smaller offsets and angles"));
}
