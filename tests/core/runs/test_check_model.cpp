#include "deck/templates.hpp"
#include "runs/check.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

using namespace adore;

namespace {

const Issue* find(const std::vector<Issue>& issues, Severity severity, const std::string& phrase) {
  const auto found = std::find_if(issues.begin(), issues.end(), [&](const Issue& issue) {
    return issue.severity == severity && issue.text().find(phrase) != std::string::npos;
  });
  return found == issues.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("check: motion that cannot run → geometry still checked", "[unit][check]") {
  deck::Deck deck = deck::new_deck("tapered");
  deck.set("mode", "0");
  deck.complete();
  deck.set("kDOF", "6");  // a user routine
  auto issues = runs::check_model(deck);
  CHECK(find(issues, Severity::Note, "will refuse this deck") != nullptr);
  CHECK(find(issues, Severity::Error, "") == nullptr);
  deck.set("bReEndRad1", "0.001");  // smaller than the roller: no such end
  issues = runs::check_model(deck);
  CHECK(find(issues, Severity::Note, "will refuse this deck") != nullptr);
  CHECK(find(issues, Severity::Error, "radius") != nullptr);

  deck::Deck cylindrical = deck::new_deck("cylindrical");
  cylindrical.set("bReCrn", "0.001");
  CHECK(find(runs::check_model(cylindrical), Severity::Error, "crown radius") != nullptr);
}

TEST_CASE("check: motion without steps → remark", "[unit][check]") {
  deck::Deck deck = deck::new_deck("ball");
  CHECK(find(runs::check_model(deck), Severity::Note, "maxStps") == nullptr);
  deck.set("maxStps", "0");
  CHECK(find(runs::check_model(deck), Severity::Note, "maxStps = 0: the run makes no steps") !=
        nullptr);
  deck.set("maxStps", "10");
  deck.set("fTime", "0");
  CHECK(find(runs::check_model(deck), Severity::Note, "fTime = 0: the run makes no steps") !=
        nullptr);
  deck.set("mode", "-1");
  deck.complete();
  CHECK(find(runs::check_model(deck), Severity::Note, "the run makes no steps") == nullptr);
}

TEST_CASE("check: impossible shapes → error with record, variable and a valid limit",
          "[unit][check]") {
  struct Bad {
    const char* deck;
    const char* variable;
    const char* value;
    const char* phrase;
  };
  const Bad bad[] = {
      {"tapered-30208", "bReEndRad1", "0.001", "cannot have this end radius; give more than"},
      {"tapered-30208", "bReCrn", "0.001", "cannot have this crown radius; give more than"},
      {"tapered-30208", "bReCorRad2", "0.00489", "cannot have this corner radius; give less than"},
      {"cylindrical-nu209", "bReCrn", "0.001", "cannot have this crown radius; give more than"},
      {"spherical-22210", "bReCrn", "0.003", "cannot have this crown radius; give more than"},
  };
  for (const Bad& b : bad) {
    deck::Deck deck = deck::new_deck(b.deck);
    deck.file = "DATA.txt";
    deck.set(b.variable, b.value);
    const auto issues = runs::check_model(deck);
    INFO(b.variable << " of " << b.deck << "\n" << to_text(issues));
    const Issue* issue = find(issues, Severity::Error, b.phrase);
    REQUIRE(issue != nullptr);
    CHECK(issue->variable == b.variable);
    CHECK(issue->file == "DATA.txt");
    CHECK_FALSE(issue->record.empty());
    const double limit = std::stod(issue->remedy.substr(issue->remedy.find("than ") + 5));
    const bool more = issue->remedy.find("more") != std::string::npos;
    deck.set(b.variable, fmt::format("{}", limit * (more ? 1.001 : 0.999)));
    CHECK(find(runs::check_model(deck), Severity::Error, "cannot have this") == nullptr);
  }
  {  // out of range, yet it is drawn while it is typed
    deck::Deck deck = deck::new_deck("tapered-30208");
    deck.set("bReCrn", "-5.0");
    CHECK(find(runs::check_model(deck), Severity::Error, "give more than") != nullptr);
  }
  deck::Deck english = deck::new_deck("tapered-30208");
  english.set("kUnit", "2");  // the same numbers, now inches: the shape is the same
  english.set("bReEndRad1", "0.001");
  CHECK(find(runs::check_model(english), Severity::Error, " in long cannot have") != nullptr);
}

TEST_CASE("check: negative traction coefficient → error with its name", "[unit][check]") {
  const std::pair<const char*, const char*> curves[] = {{"kTracType", "reRaceTC"},
                                                        {"kRFTracType", "reFlngTC"},
                                                        {"kCPTracType", "reCageTC"},
                                                        {"kCRTracType", "cageRaceTC"}};
  for (const auto& [type, stem] : curves)
    for (const int form : {1, 2})
      for (int k = 1; k <= (form == 1 ? 3 : 2); ++k) {
        deck::Deck deck = deck::new_deck("cylindrical");
        deck.set(type, fmt::format("{}", form));
        deck.complete();
        const std::string variable = fmt::format("{}{}", stem, k);
        deck.set(variable, "-0.01");
        const auto issues = deck::check_deck(deck);
        INFO(variable << " of form " << form << "\n" << to_text(issues));
        const Issue* issue = find(issues, Severity::Error, "cannot be negative");
        REQUIRE(issue != nullptr);
        CHECK(issue->variable == variable);
        CHECK_FALSE(issue->record.empty());
      }
}

TEST_CASE("check: clearance that makes the races overlap → error with its record",
          "[unit][check]") {
  for (const char* name : {"cylindrical-nu209", "spherical-22210", "deep-groove-6205"}) {
    deck::Deck deck = deck::new_deck(name);
    deck.set("freeIntCls", "-7");
    const auto issues = runs::check_model(deck);
    INFO(name << "\n" << to_text(issues));
    const Issue* issue = find(issues, Severity::Error, "give a value above");
    REQUIRE(issue != nullptr);
    CHECK(issue->variable == "freeIntCls");
    CHECK_FALSE(issue->record.empty());
  }
}

TEST_CASE("check: imperfections that leave no bearing → error with record and variable",
          "[unit][check]") {
  const auto refusal = [](const char* name,
                          const std::vector<std::pair<const char*, const char*>>& sets) {
    deck::Deck deck = deck::new_deck(name);
    for (const auto& [variable, value] : sets) deck.set(variable, value);
    deck.complete();
    for (const Issue& issue : runs::check_model(deck))
      if (issue.severity == Severity::Error) return issue.record + " " + issue.variable;
    return std::string("none");
  };
  CHECK(refusal("angular-218", {{"kReGeoImp", "1"}, {"reDiaVar", "0.01"}}) == "5G.1A reDiaVar");
  CHECK(refusal("angular-218", {{"kReGeoImp", "2"}, {"reDiaVar3", "-0.012"}}) ==
        "5G.1D.1 reDiaVar3");
  CHECK(refusal("angular-218", {{"kReGeoImp", "2"}, {"reDiaVar3", "1e-6"}}) == "none");
  CHECK(refusal("angular-218", {{"kRaceGeoImp1", "2"}, {"cFacVar11", "0.1"}, {"cFacVar21", "2"}}) ==
        "5G.2.1B cFacVar11");
  CHECK(refusal("spherical-22210",
                {{"kRaceGeoImp2", "1"}, {"cFacVar12", "-0.1"}, {"cFacVar22", "1"}}) ==
        "5G.2.2A cFacVar12");
  CHECK(refusal("cylindrical-nu209", {{"kReGeoImp", "1"}, {"reLenVar", "0.02"}}) ==
        "5G.1B reLenVar");
}

TEST_CASE("check: waves that cancel and laws that end → remark", "[unit][check]") {
  deck::Deck deck = deck::new_deck("cylindrical-nu209");
  deck.set("kRaceGeoImp2", "2");
  deck.set("rlTaper12", "1e-4");
  deck.complete();
  const char* const none = "rlTaper12 = 1.0e-04: has no effect";
  {
    const auto issues = runs::check_model(deck);
    INFO(to_text(issues));
    CHECK(find(issues, Severity::Warning, none) != nullptr);
  }
  deck.set("rlTaper32", "90.0");
  CHECK(find(runs::check_model(deck), Severity::Warning, none) == nullptr);
  deck.set("rlTaper32", "0.0");
  deck.set("rlTaper22", "2.0");
  CHECK(find(runs::check_model(deck), Severity::Warning, none) == nullptr);
  deck.set("rlTaper12", "5.0");
  CHECK(find(deck::check_deck(deck), Severity::Error,
             "rlTaper12 = 5.0: is out of range; enter a value from -0.1 to 0.1 rad") != nullptr);

  deck::Deck warm = deck::new_deck("angular-218");
  warm.set("kTherm", "1");
  warm.complete();
  warm.set("kMatPropMod", "1");
  CHECK(find(runs::check_model(warm), Severity::Warning, "outside the known range") == nullptr);
  warm.set("raceTemp2", "2500.0");
  warm.set("hsngTemp", "2500.0");
  const auto issues = runs::check_model(warm);
  INFO(to_text(issues));
  CHECK(find(issues, Severity::Warning, "raceTemp2 = 2500.0: is outside the known range of") !=
        nullptr);
}
