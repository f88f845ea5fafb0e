#include "core/facade/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/results_h5.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace adore;

namespace {

deck::Deck ball(const std::string& plot_every, const std::string& last) {
  deck::Deck deck = deck::new_deck("ball");
  deck.set_all({{"maxStps", last},
                {"nStps", "1"},
                {"kPltFreq", plot_every},
                {"kAGraf", "0"},
                {"kPrtFreq", "1000"},
                {"kLifeFreq", "0"}});
  return deck;
}

}  // namespace

TEST_CASE("extremes of the loads between stored steps are those of the steps in between",
          "[physics][load-band]") {
  testing::TemporaryFolder folder;
  const auto every = testing::run_deck(ball("1", "60"), folder / "every");
  const auto tenth = testing::run_deck(ball("10", "60"), folder / "tenth");
  CHECK(tenth.report["plan"]["estimates"]["fastest_frequency_Hz"].get<double>() ==
        Approx(2.628e4).epsilon(1e-3));  // `adore plan` of this deck
  const results::H5Reader all(folder / "every" / "RESULTS.h5"),
      some(folder / "tenth" / "RESULTS.h5");
  REQUIRE(all.steps() == 61);
  REQUIRE(some.steps() == 7);
  const std::size_t width = some.find("contact.load")->size();
  const auto load = all.read("contact.load"), low = some.read("contact.load_low"),
             high = some.read("contact.load_high"), mean = some.read("contact.load_mean"),
             stored = some.read("contact.load");
  double widest = 0.0;
  for (std::size_t i = 0; i < 7; ++i)
    for (std::size_t k = 0; k < width; ++k) {
      INFO("stored step " << i << ", contact " << k);
      const double value = stored[i * width + k];
      CHECK(low[i * width + k] <= value);
      CHECK(high[i * width + k] >= value);
      if (i == 0) {
        CHECK(low[k] == value);
        CHECK(high[k] == value);
        continue;
      }
      double least = 1e300, most = 0.0;
      for (std::size_t step = 10 * i - 9; step <= 10 * i; ++step) {
        least = std::min(least, load[step * width + k]);
        most = std::max(most, load[step * width + k]);
      }
      CHECK(low[i * width + k] == Approx(least).epsilon(1e-12));
      CHECK(high[i * width + k] == Approx(most).epsilon(1e-12));
      CHECK(mean[i * width + k] >= least);
      CHECK(mean[i * width + k] <= most);
      widest = std::max(widest, most - least);
    }
  CHECK(widest > 1.0);  // there is something between the steps [N]
}

TEST_CASE("a continued run has the extremes of an unbroken one", "[physics][load-band]") {
  testing::TemporaryFolder folder;
  (void)testing::run_deck(ball("10", "40"), folder / "whole");
  (void)testing::run_deck(ball("10", "25"), folder / "parts");
  (void)testing::run_deck(ball("10", "15"), folder / "parts", true);
  const results::H5Reader whole(folder / "whole" / "RESULTS.h5"),
      parts(folder / "parts" / "RESULTS.h5");
  const std::vector<long> steps = whole.step_numbers(), other = parts.step_numbers();
  const std::size_t width = whole.find("contact.load")->size();
  int compared = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto found = std::find(other.begin(), other.end(), steps[i]);
    if (found == other.end() || steps[i] > 20) continue;
    const auto j = static_cast<std::size_t>(found - other.begin());
    for (const char* id : {"contact.load_low", "contact.load_high"})
      CHECK(whole.read(id, i, 1) == parts.read(id, j, 1));
    ++compared;
  }
  CHECK(compared == 3);
  CHECK(width == 24);
}
