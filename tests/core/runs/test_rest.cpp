#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/results_h5.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

/// Bearings at rest (runs/rest_watch.hpp).
using namespace adore;

namespace {

/// 10 ms of the ball example without speeds, weight and cage.
deck::Deck resting(const testing::Options& more = {}) {
  deck::Deck deck = deck::new_deck("ball");
  deck.set_all(testing::Options{{"rpm1", "0"},
                                {"rpm2", "0"},
                                {"nCseg", "0"},
                                {"gravityVecZ", "0"},
                                {"kPltFreq", "1"},
                                {"kNumPltElem", "1"},
                                {"kPltElemInd", "1"},
                                {"fTime", "1145"}});
  deck.set_all(more);
  return deck;
}

bool has_rest(const testing::Ran& ran) {
  for (const auto& finding : ran.report.at("findings"))
    if (finding.at("code") == "run.rest") return true;
  return false;
}

}  // namespace

TEST_CASE("rest: bearing at rest → at most 100 steps, its loads stay, and a note",
          "[physics][runs]") {
  const testing::TemporaryFolder folder;
  const testing::Ran ran = testing::run_deck(resting(), folder / "rest");
  CHECK(ran.outcome.status == runs::RunStatus::Done);
  CHECK(has_rest(ran));
  CHECK(ran.report.at("summary").at("time_s").get<double>() == Approx(0.01).epsilon(0.05));
  CHECK(ran.report.at("steps").get<int>() <= 100);
  const std::vector<double> load =
      results::H5Reader(folder / "rest" / "RESULTS.h5").read("contact.load");
  const std::size_t width = 24;
  REQUIRE(load.size() > 10 * width);
  for (std::size_t i = width; i < load.size(); ++i)
    CHECK(load[i] == Approx(load[i % width]).epsilon(1e-6).margin(1e-6));
}

TEST_CASE("rest: speed, vibration or load over time → integrated", "[physics][runs]") {
  const testing::TemporaryFolder folder;
  const testing::Options cases[] = {
      {{"rpm2", "1"}},
      {{"kVarSpeed", "1"}, {"raceAngAcc2", "1e6"}, {"endTime2", "1"}},
      {{"kVarSpeed", "2"}, {"raceSpeedAmp2", "20000"}, {"raceSpeedFreq2", "500"}},
      {{"kVarLoad", "2"}, {"raceVibAmp21", "2e-6"}, {"raceVibFreq1", "3000"}},
      {{"mode", "2"}, {"kVarLoad", "1"}, {"rotLoadFrac2", "1"}, {"rotLoadRpm2", "60000"}},
  };
  for (testing::Options moved : cases) {
    INFO(moved.back().first);
    moved.insert(moved.begin(), {"fTime", "20"});
    CHECK_FALSE(has_rest(testing::run_deck(resting(moved), folder / moved.back().first)));
  }
}
