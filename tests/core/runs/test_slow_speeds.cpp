#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "runs/run_scales.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <string>

/// Speeds from rest to 10,000 rpm: no judgment of a run divides by what goes to zero with speed.
using namespace adore;

namespace {

/// One row of sixteen balls under pure thrust, dry, without cage and gravity (7210 B).
constexpr const char* kSlowThrust = R"('Rec 1', 0, 0, 0, 0, 0, 1, 625, 1, 12, 12, 0, 5000, 4, 5
'Rec 2.1', 0.05, 5.0e-4, 0.5, 3600.0, 1.0e-6, 0.0
'Rec 3.1', '7210B sixteen balls, pure thrust'
'Rec 3.2', 1, 1, 16, 0, 0, 0, 0, 0, 0, 0, 0, 0
'Rec 3.3', 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0
'Rec 3.4', 0, 0, 0, 0, 0, 0, 4, 1, 5, 9, 13
'Rec 4', 0.05, 0.09, 0.0, 0.1215, 0.02, 0.02
'Rec 5A', 0.0127, 0.070, 40.0, 0.0, 0.52, 0.52, 0.0764294, 0.0635706, 0.0, 0.0, 1.5e-07, 1.5e-07
'Rec 9.0', 293.15, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0
'Rec 9.1.1', 5000.0, 0.0, 0.0, 0.0, 0.0, 0.0
'Rec 9.1.2', 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0e-4
'Rec 9.1.3', 293.15, 293.15, 293.15, 293.15, 293.15, 293.15
'Rec 10.0', 0, 1, 0, 2, 0, 2, 0, 2, 0, 2, 0
'Rec 10.1C', 0.0, 0.060, 0.040, 0.50
'Rec 10.5.3D', 0.0, 0.060, 0.60, 0.0
'Rec 11', 0.0, 0.0, 0.0
)";

struct End {
  runs::RunOutcome outcome;
  double longest = 0.0;  ///< steps of the deck's longest size in the span
};

End run_of(const deck::Deck& deck, const std::filesystem::path& folder, double span) {
  std::filesystem::create_directories(folder);
  deck::write_deck(deck, folder / "DATA.txt");
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.until = fmt::format("{}s", span);
  request.options = {{"resultsH5", "0"}};
  return {runs::run(request), span / (deck.real("stpMax") * runs::run_scales(deck, {}).time)};
}

}  // namespace

TEST_CASE("sixteen balls under thrust from rest to 100 rpm: done, in the steps of the deck",
          "[validation][runs]") {
  const testing::TemporaryFolder folder;
  deck::Deck deck = deck::read_deck_text(kSlowThrust, "7210B").deck;
  for (const char* rpm : {"0.0", "1e-6", "1e-4", "1e-2", "1.0", "100.0"}) {
    CAPTURE(rpm);
    deck.set("rpm2", rpm);
    const End end = run_of(deck, folder / rpm, 0.002);
    INFO(end.outcome.message);
    CHECK(end.outcome.status == runs::RunStatus::Done);
    CHECK(end.outcome.steps <= 200);  // the deck's longest step: 121
  }
}

TEST_CASE("ball at rest: every step is the deck's longest, or the longest stable one",
          "[validation][runs]") {
  const testing::TemporaryFolder folder;
  deck::Deck deck = deck::new_deck("ball");
  deck.set("rpm2", "0.0");
  const End by_deck = run_of(deck, folder / "deck", 0.002);
  CHECK(by_deck.outcome.status == runs::RunStatus::Done);
  CHECK(static_cast<double>(by_deck.outcome.taken) <= by_deck.longest + 3.0);  // 473 of 471.5
  // Stored steps of four: the explicit method follows the contact resonance of 27.6 kHz.
  deck.set("stpMax", "1000.0");
  const End free = run_of(deck, folder / "free", 0.002);
  CHECK(free.outcome.status == runs::RunStatus::Done);
  CHECK(free.outcome.steps <= 100);  // 81
}

TEST_CASE("all types from rest to 10,000 rpm: done, without needless steps",
          "[validation][runs][slow]") {
  const testing::TemporaryFolder folder;
  for (const char* type : {"ball", "ball-thrust", "cylindrical", "tapered", "spherical"})
    for (const char* rpm : {"0.0", "1e-6", "1e-4", "1e-2", "1.0", "100.0", "1e4"}) {
      CAPTURE(type, rpm);
      deck::Deck deck = deck::new_deck(type);
      for (const char* name : {"rpm1", "gravityVecX", "gravityVecY", "gravityVecZ"})
        deck.set(name, "0.0");
      for (const char* name : {"kPltFreq", "kAGraf"}) deck.set(name, "0");
      deck.set("rpm2", rpm);
      deck.set("maxStps", "100000");
      const End end = run_of(deck, folder / fmt::format("{}-{}", type, rpm), 2e-4);
      INFO(end.outcome.message);
      CHECK(end.outcome.status == runs::RunStatus::Done);
      CHECK(static_cast<double>(end.outcome.taken) < 4.0 * end.longest + 200.0);
    }
}
