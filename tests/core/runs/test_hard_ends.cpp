#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "runs/measured_run.hpp"

#include <catch2/catch.hpp>

#include <string>

/// Runs that come to no good end say why.
using namespace adore;
using testing::Ran;
using testing::run_deck;

namespace {

deck::Deck conformal(const char* load) {
  deck::Deck deck = deck::new_deck("ball");
  for (const auto& [variable, value] : {std::pair{"raceCurFac1", "0.5005"},
                                        {"raceCurFac2", "0.5005"},
                                        {"appLoadX", load},
                                        {"nStps", "1"}})
    deck.set(variable, value);
  return deck;
}

}  // namespace

TEST_CASE(
    "Groove too conformal to its balls → rejected by its ellipse, warned of before the motion, or "
    "run ends with the contact beyond Hertz's theory",
    "[physics][runs]") {
  const testing::TemporaryFolder folder;
  // 20 kN: the ellipse of the equilibrium would be longer than the ball.
  runs::DeckRequest request;
  request.text = deck::write_deck(conformal("20000.0"));
  try {
    (void)runs::prepare(request);
    FAIL("an equilibrium was found");
  } catch (const SolverError& error) {
    CHECK_THAT(error.what(), Catch::Contains("reaches the ball radius"));
    CHECK_THAT(error.what(), Catch::Contains("groove factor 0.5005"));
  }
  // 300 N: 4.5 times its load is enough, and impacts bring that where vibrations do not decay.
  const Ran ran = run_deck(conformal("300.0"), folder / "300", false, {{"contactDamping", "0"}});
  CHECK(ran.outcome.status == runs::RunStatus::Failed);
  CHECK_THAT(ran.outcome.message, Catch::Contains("Invalid state ahead"));
  CHECK_THAT(ran.outcome.message,
             Catch::Contains("semi-major axis reaches the radius of the element"));
  CHECK_THAT(ran.report.at("notes").dump(),
             Catch::Contains("A dynamic run ends when a contact reaches"));
  // 1 kN keeps all balls in place.
  CHECK(run_deck(
            [] {
              deck::Deck deck = conformal("1000.0");
              deck.set("maxStps", "400");
              return deck;
            }(),
            folder / "1000")
            .outcome.status == runs::RunStatus::Done);
}

TEST_CASE(
    "Ball squeezed beyond Hertz's theory → run ends with its contact, whose limit is that of its "
    "angle",
    "[physics][runs]") {
  // One ball between races that stay where it needs them at the start. With constants of the mean
  // angle its limit lay higher, and past its own radius the surface of the contact is none.
  runs::RunRequest request;
  request.text = deck::write_deck(deck::new_deck("ball"));
  request.sets = {{"nRe", "1"}, {"nCseg", "0"}, {"kNumPltElem", "2"}, {"kPltElemInd", "1,3"}};
  request.until = "2rev";
  const runs::MeasuredRun ran = runs::measured_run(request, 60.0, {});
  CHECK(ran.outcome.status == runs::RunStatus::Failed);
  CHECK_THAT(ran.outcome.message,
             Catch::Contains("between element 1 and the inner race makes the contact "
                             "ellipse too long"));
}

TEST_CASE("Run whose steps all miss the tolerance at stpMin → ends with that message",
          "[physics][runs][slow]") {
  const testing::TemporaryFolder folder;
  // Steps of 0.3 are stable, with errors far above a tolerance of 1e-13.
  deck::Deck deck = deck::new_deck("ball");
  for (const auto& [variable, value] :
       {std::pair{"tol", "1e-13"}, {"stpMin", "0.3"}, {"kPltFreq", "100"}, {"maxStps", "100000"}})
    deck.set(variable, value);
  deck.complete();
  const Ran ran = run_deck(deck, folder / "missed");
  CHECK(ran.outcome.status == runs::RunStatus::Failed);
  CHECK_THAT(ran.outcome.message, Catch::Contains("each of the last"));
  CHECK_THAT(ran.outcome.message, Catch::Contains("missed the tolerance of 1e-13"));
  CHECK_THAT(ran.outcome.message, Catch::Contains("stpMin 0.3"));
  CHECK(ran.report.at("counters").at("at_minimum") == 10000);
}
