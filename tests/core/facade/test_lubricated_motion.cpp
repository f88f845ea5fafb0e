#include "core/facade/deck_runs.hpp"
#include "deck/deck.hpp"
#include "deck/templates.hpp"
#include "facade/prepare.hpp"
#include "facade/run.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

/// Ball bearings that run in oil: record 10 acts on their motion.
using namespace adore;
using deck::Deck;
using testing::Ran;
using testing::refusal_of;
using testing::run_deck;
namespace fs = std::filesystem;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

Deck oiled(const char* code, const Sets& sets = {}) {
  Deck deck = deck::new_deck("ball");
  const Sets few{{"maxStps", "40"}, {"nStps", "2"}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}};
  deck.set_all(few);
  deck.set("kTrac", code);
  deck.complete();
  deck.set("reRaceFilm", "1.0e-8");
  deck.set("strParam", "10.0");
  for (const auto& [name, value] : sets) deck.set(name, value);
  return deck;
}

}  // namespace

TEST_CASE("balls run in oil: the energy ledger closes, films are printed", "[validation][film]") {
  const testing::TemporaryFolder folder;
  for (const char* code : {"1", "3", "6"}) {
    CAPTURE(code);
    const Ran ran = run_deck(oiled(code), folder / code);
    CHECK(ran.outcome.status == facade::RunStatus::Done);
    CHECK(ran.outcome.steps == 40);
    CHECK(std::abs(ran.outcome.energy_residual) < 1e-4 * ran.outcome.energy_scale);
    CHECK_THAT(ran.print, Catch::Contains("Lubricant films"));
    CHECK_THAT(ran.print, !Catch::Contains("Film thickness (hypothetical traction)"));
  }
  // Films that collapse leave metal contacts, and the run goes on.
  for (const Sets& sets : {Sets{{"reRaceFilm", "1.0e-3"}}, Sets{{"strParam", "0.0"}}}) {
    const Ran ran = run_deck(oiled("3", sets), folder / sets[0].first);
    CHECK(ran.outcome.status == facade::RunStatus::Done);
    CHECK(std::abs(ran.outcome.energy_residual) < 1e-4 * ran.outcome.energy_scale);
  }
}

TEST_CASE("lubricants without a law for motion are refused by name", "[unit][film]") {
  CHECK_THAT(refusal_of(oiled("3")), Catch::Contains("was accepted"));
  for (const char* code : {"8", "10", "13", "18"})
    CHECK_THAT(refusal_of(oiled(code)),
               Catch::Contains("kTrac") && Catch::Contains("set kTrac to 0, to 1 to 7, or to 9"));
  Deck routine = deck::new_deck("ball");
  routine.set("kTrac", "-1");
  routine.complete();
  CHECK_THAT(refusal_of(routine), Catch::Contains("ADRX7"));
  Deck rollers = deck::new_deck("cylindrical");
  rollers.set("kTrac", "3");
  rollers.complete();
  rollers.set("reRaceFilm", "1.0e-8");
  rollers.set("strParam", "10.0");
  CHECK_THAT(refusal_of(rollers), Catch::Contains("between rollers and races"));
}
