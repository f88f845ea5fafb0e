#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/h5_reader.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <string>

/// Life of a run from the loads of all steps.
using namespace adore;

namespace {

runs::RunOutcome run_of(const char* type, const std::filesystem::path& folder, int life_every,
                        int store_every, const char* until) {
  std::filesystem::create_directories(folder);
  deck::Deck deck = deck::new_deck(type);
  deck.set("kLifeFreq", fmt::format("{}", life_every));
  deck.set("kPltFreq", fmt::format("{}", store_every));
  deck.set("kAGraf", "0");
  deck.set("nStps", "1");
  deck.set("maxStps", "100000");
  deck::write_deck(deck, folder / "DATA.txt");
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.until = until;
  return runs::run(request);
}

double result(const runs::RunOutcome& run, const char* id) {
  for (const results::KeyResult& one : run.summary)
    if (one.of.id == id) return one.value;
  return std::nan("");
}

}  // namespace

TEST_CASE("run_life_hours: independent of kLifeFreq, equal to the mean over every step",
          "[validation][life]") {
  const testing::TemporaryFolder folder;
  for (const char* type : {"ball", "cylindrical"}) {
    CAPTURE(type);
    const auto all = folder / fmt::format("{}-all", type);
    const runs::RunOutcome every = run_of(type, all, 1, 1, "0.15rev");
    const double life = result(every, "run_life_hours");
    CHECK(result(every, "run_life_samples") == every.taken);
    for (const int life_every : {0, 12}) {
      const runs::RunOutcome few =
          run_of(type, folder / fmt::format("{}-{}", type, life_every), life_every, 50, "0.15rev");
      CHECK(result(few, "run_life_hours") == life);
      CHECK(result(few, "run_life_samples") == every.taken);
    }
    // Of the lives of all instants, each at 90 % of its own survival: 1/life is the damage rate.
    const results::H5Reader file(all / "RESULTS.h5");
    const std::vector<double> time = file.read("time"), hours = file.read("power.life");
    REQUIRE(time.size() == hours.size());
    double damage = 0.0;
    for (std::size_t k = 1; k < time.size(); ++k)
      damage += 0.5 * (time[k] - time[k - 1]) * (1.0 / hours[k] + 1.0 / hours[k - 1]);
    CHECK(life == Approx((time.back() - time.front()) / damage).epsilon(0.02));
  }
}
