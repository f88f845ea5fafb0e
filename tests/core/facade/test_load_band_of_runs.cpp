#include "core/facade/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/results_h5.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace adore;

namespace {

deck::Deck ball(const std::string& plot_every, const std::string& last) {
  deck::Deck deck = deck::new_deck("ball");
  const std::vector<std::pair<std::string, std::string>> sets{
      {"maxStps", last}, {"nStps", "1"},       {"kPltFreq", plot_every},
      {"kAGraf", "0"},   {"kPrtFreq", "1000"}, {"kLifeFreq", "0"}};
  deck.set_all(sets);
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
  (void)testing::run_deck(ball("10", "40"), folder / "parts", true);
  const results::H5Reader whole(folder / "whole" / "RESULTS.h5"),
      parts(folder / "parts" / "RESULTS.h5");
  REQUIRE(whole.step_numbers() == std::vector<long>{0, 10, 20, 30, 40});
  // The last step of a run is always stored: the looks of 21 to 30 are in two rows there.
  REQUIRE(parts.step_numbers() == std::vector<long>{0, 10, 20, 25, 30, 40});
  for (const auto& [row, other] :
       {std::pair<std::size_t, std::size_t>{0, 0}, {1, 1}, {2, 2}, {4, 5}})
    for (const char* id : {"contact.load_low", "contact.load_high", "contact.load_mean"}) {
      INFO(id << ", row " << row);
      CHECK(whole.read(id, row, 1) == parts.read(id, other, 1));
    }
  const auto low = whole.read("contact.load_low", 3, 1),
             high = whole.read("contact.load_high", 3, 1),
             low_25 = parts.read("contact.load_low", 3, 1),
             low_30 = parts.read("contact.load_low", 4, 1),
             high_25 = parts.read("contact.load_high", 3, 1),
             high_30 = parts.read("contact.load_high", 4, 1);
  REQUIRE(low.size() == 24);
  for (std::size_t k = 0; k < low.size(); ++k) {
    CHECK(low[k] == std::min(low_25[k], low_30[k]));
    CHECK(high[k] == std::max(high_25[k], high_30[k]));
  }
}
