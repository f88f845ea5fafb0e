#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <string>

/// Films that break down while contacts slide without rolling (film_tolerance.hpp).
using namespace adore;

namespace {

runs::RunOutcome run_of(const char* kelvin, const char* oil, const char* mode, double tolerance,
                        const std::filesystem::path& folder) {
  deck::Deck deck = deck::new_deck("ball");
  deck.set("mode", mode);
  deck.set("kTrac", oil);
  deck.complete();
  for (const auto& [name, value] :
       std::initializer_list<std::pair<const char*, const char*>>{{"reRaceFilm", "1e-8"},
                                                                  {"strParam", "10"},
                                                                  {"appLoadX", "2000"},
                                                                  {"appLoadZ", "-1500"},
                                                                  {"rpm2", "5000"},
                                                                  {"kPltFreq", "0"},
                                                                  {"kAGraf", "0"},
                                                                  {"maxStps", "1000000"}})
    deck.set(name, value);
  for (const char* part : {"raceTemp1", "raceTemp2", "reTemp", "cageTemp", "hsngTemp", "shftTemp"})
    deck.set(part, kelvin);
  std::filesystem::create_directories(folder);
  deck::write_deck(deck, folder / "DATA.txt");
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.until = "0.12rev";
  request.tolerance = tolerance;
  return runs::run(request);
}

double result(const runs::RunOutcome& run, const char* id) {
  for (const results::KeyResult& one : run.summary)
    if (one.of.id == id) return one.value;
  return std::nan("");
}

bool reports_tolerance(const runs::RunOutcome& run) {
  for (const Issue& issue : run.warnings)
    if (issue.message.find("oil films collapsed") != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE(
    "cold thick oil: heat at the default tolerance is that at 1e-8 within 1 %, and the run "
    "reports its tolerance",
    "[validation][film][slow]") {
  const testing::TemporaryFolder folder;
  for (const char* mode : {"0", "1", "2"}) {
    CAPTURE(mode);
    const runs::RunOutcome usual =
        run_of("240", "13", mode, 1e-6, folder / fmt::format("{}u", mode));
    const runs::RunOutcome tight =
        run_of("240", "13", mode, 1e-8, folder / fmt::format("{}t", mode));
    CHECK(reports_tolerance(usual));
    CHECK(result(usual, "mean_power_loss_W") ==
          Approx(result(tight, "mean_power_loss_W")).epsilon(0.01));
    CHECK(result(usual, "mean_cage_ratio") ==
          Approx(result(tight, "mean_cage_ratio")).epsilon(0.002));
  }
}

TEST_CASE("oil at 320 K: contacts roll, and the tolerance stays the deck's", "[validation][film]") {
  const testing::TemporaryFolder folder;
  CHECK_FALSE(reports_tolerance(run_of("320", "13", "0", 1e-6, folder / "warm")));
}
