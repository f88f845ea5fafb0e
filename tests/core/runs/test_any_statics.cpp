#include "deck/check.hpp"
#include "deck/schema.hpp"
#include "deck/templates.hpp"
#include "runs/check.hpp"
#include "setup/build_bearing.hpp"
#include "setup/build_life.hpp"
#include "setup/run_control.hpp"
#include "setup/unused_values.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"
#include "thermal/operating.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace adore;

namespace {

constexpr const char* kTypes[] = {"ball", "cylindrical", "spherical", "tapered",
                                  "spherical-tapered"};

deck::Deck at_rest(const char* type) {
  deck::Deck deck = deck::new_deck(type);
  deck.set("mode", "-1");
  deck.complete();
  return deck;
}

std::array<double, 5> solution(const deck::Deck& deck) {
  const bearing::Bearing b = thermal::operating_bearing(setup::build_bearing(deck));
  if (b.rollers()) return statics::solve_roller_statics(b).displacement;
  return statics::solve_ball_statics(b).displacement;
}

/// What the model does not read of a deck.
std::vector<deck::NoPart> without_part(deck::Deck deck) {
  deck.reads = std::make_shared<deck::ReadLog>();
  (void)thermal::operating_bearing(setup::build_bearing(deck));
  (void)setup::build_run_control(deck);
  (void)setup::build_life_inputs(deck, {});
  return setup::find_unused_values(deck);
}

/// Everything that the checks say of a deck.
std::string remarks(const deck::Deck& deck) {
  std::string out;
  for (const Issue& issue : deck::check_deck(deck)) out += issue.text() + "\n";
  for (const Issue& issue : runs::check_model(deck)) out += issue.text() + "\n";
  return out;
}

/// Options of motion, cage, lubrication and traction: none is a part of the static equilibrium.
/// Materials and what shapes elements and races are.
bool moves_only(std::string_view record, std::string_view variable) {
  static const std::set<std::string_view> kOthers{"mode", "kStif", "kLifeCons", "kCageMat"};
  if (kOthers.count(variable) > 0) return false;
  if (record == "3.3") return variable == "kChrn";
  return record == "1" || record == "3.5" || record.starts_with("7.") || record == "10.0";
}

std::vector<std::string> codes(const deck::VariableSpec& variable) {
  std::vector<std::string> out;
  const auto add = [&](std::span<const deck::OptionSpec> options) {
    for (const deck::OptionSpec& option : options)
      out.emplace_back(option.code == "n" ? "3" : option.code);
  };
  add(variable.options);
  if (!variable.option_table.empty()) add(deck::option_table(variable.option_table));
  return out;
}

bool has_errors(const deck::Deck& deck) {
  const auto issues = deck::check_deck(deck);
  return std::any_of(issues.begin(), issues.end(),
                     [](const Issue& issue) { return issue.severity == Severity::Error; });
}

}  // namespace

TEST_CASE("statics of any deck: values of the motion only → left out and listed",
          "[physics][statics]") {
  for (const char* type : kTypes) {
    const auto base = solution(at_rest(type));
    std::set<std::string> named;
    int solved = 0;
    for (const deck::RecordSpec& record : deck::schema())
      for (const deck::VariableSpec& variable : record.variables) {
        if (!moves_only(record.id, variable.name)) continue;
        const std::string name(variable.name);
        for (const std::string& code : codes(variable)) {
          deck::Deck deck = at_rest(type);
          if (!deck.has(name)) continue;  // of a record that this deck has no use for
          if (name == "kPocHydro" || name == "kGsHydro" || name == "kChrn") deck.set("kTrac", "1");
          deck.set(variable.length == "1" ? name : name + "[1]", code);
          if (name == "kTrac" && code == "21") deck.set("oilGrade", "68");
          deck.complete();
          if (deck.has("baseTemp")) {  // record 9.7 has no defaults
            deck.set("baseTemp", "300.0");
            deck.set("aveTime", "1.0");
          }
          for (const char* ratio : {"denRatio", "visRatio"})  // neither has record 10.7B
            if (deck.has(ratio)) deck.set(ratio, "1.0");
          if (has_errors(deck)) continue;  // no such code for this type
          INFO(type << ": " << name << " = " << code << "\n" << remarks(deck));
          CHECK(solution(deck) == base);
          ++solved;
          for (const deck::NoPart& idle : without_part(deck)) {
            if (!setup::requests_effect(idle)) continue;
            named.insert(idle.variable);
            CHECK(idle.because != setup::kNoReason);
            CHECK_THAT(remarks(deck), Catch::Contains(idle.variable + " = " + idle.value) &&
                                          Catch::Contains("effect"));
          }
        }
      }
    INFO(type);
    CHECK(solved > 40);
    for (const char* must : {"kPocHydro", "kGsHydro", "kDOF"}) {
      INFO(must);
      CHECK(named.count(must) == 1);
    }
  }
}

TEST_CASE("statics of any deck: cut or conical cage and given inertia → no influence",
          "[physics][statics]") {
  for (const char* type : kTypes) {
    INFO(type);
    const deck::Deck plain = at_rest(type);
    const auto base = solution(plain);
    deck::Deck cut = plain;
    cut.set("nCseg", "2");
    cut.complete();
    if (!has_errors(cut)) {
      CHECK(solution(cut) == base);
      CHECK_THAT(remarks(cut), !Catch::Contains("nCseg"));  // its mass and plays are computed
    }
    deck::Deck bare = plain;
    bare.set("nCseg", "0");
    bare.complete();
    CHECK(solution(bare) == base);
  }
}

TEST_CASE("statics of any deck: deviations of pocket clearances → clearance of the cage",
          "[physics][cage]") {
  std::string said;
  const auto plays = [&](const char* code, const char* deviation) {
    deck::Deck deck = at_rest("ball");
    deck.set("kCagePocImp", code);
    deck.complete();
    deck.set("bPocClsVar1", deviation);
    deck.set("bPocCenVar1", "1e-4");
    CHECK_THAT(remarks(deck), Catch::Contains("bPocCenVar1 = 1.0e-04 ("));
    const auto fits = *thermal::operating_bearing(setup::build_bearing(deck)).operating;
    said = remarks(deck);
    for (const Finding& warning : fits.warnings) said += warning.message + "\n";
    return fits.plays;
  };
  const auto find = [](const std::vector<bearing::CageClearance>& all, const std::string& start) {
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const auto& play) { return play.name.starts_with(start); });
    REQUIRE(at != all.end());
    return at->free;
  };
  const double nominal = at_rest("ball").si("bPocCls1");
  CHECK(find(plays("2", "-0.0003"), "pocket clearance I") == Approx(nominal - 3e-4));
  CHECK_THAT(said, Catch::Contains("makes every pocket smaller than its rolling element"));
  const auto first = plays("1", "-0.0003");
  CHECK(find(first, "pocket clearance I") == Approx(nominal));
  CHECK(find(first, "pocket clearance I, pocket 1") == Approx(nominal - 3e-4));
  CHECK_THAT(said, Catch::Contains("pocket 1 of the cage clamps its rolling element"));
  const auto random = plays("3", "2e-5");
  CHECK(find(random, "pocket clearance I") == Approx(nominal));
  const double least = find(random, "pocket clearance I, least: no. ");
  CHECK(least < nominal);
  CHECK(least > nominal - 1e-4);
}

TEST_CASE("statics of any deck: balls that lose the position held by springs → still solved",
          "[physics][statics]") {
  using Sets = std::vector<std::pair<std::string, std::string>>;
  const auto converges = [](const Sets& sets) {
    deck::Deck deck = at_rest("ball");
    deck.set_all(sets);
    const auto q = solution(deck);
    return std::all_of(q.begin(), q.end(), [](double x) { return std::isfinite(x); });
  };
  CHECK(converges({{"appLoadX", "1"},
                   {"appLoadY", "300"},
                   {"appLoadZ", "500"},
                   {"rpm2", "-20000"},
                   {"freeConAng", "0"},
                   {"freeIntCls", "3e-4"}}));
}
