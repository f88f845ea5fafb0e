#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/channels.hpp"
#include "results/results_h5.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// Extremes and means between stored steps, of all channels that have them.
using namespace adore;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

struct Case {
  std::string name, type;
  Sets sets;
};

/// Cages of one piece, cut and none; free, held and balanced elements; dry and in oil.
std::vector<Case> cases() {
  const Sets one{{"kNumPltElem", "1"}, {"kPltElemInd", "1"}};
  const auto with = [&](Sets sets) {
    sets.insert(sets.end(), one.begin(), one.end());
    return sets;
  };
  const Sets cut = with({{"nRe", "12"},
                         {"nCseg", "2"},
                         {"cageAngCut", "0.5"},
                         {"lSeg[1]", "-1"},
                         {"lSeg[2]", "-7"},
                         {"avRatio[1]", "1"},
                         {"avRatio[2]", "1"}});
  const Sets none = with({{"nCseg", "0"}});
  std::vector<Case> out;
  for (const char* type : {"ball", "cylindrical", "tapered", "spherical", "spherical-tapered"})
    out.push_back({type, type, {}});
  out.push_back({"ball, cut cage", "ball", cut});
  out.push_back({"cylindrical, cut cage", "cylindrical", cut});
  out.push_back({"ball, no cage", "ball", none});
  out.push_back({"cylindrical, no cage", "cylindrical", none});
  out.push_back({"ball, light ones held", "ball", {{"qFac", "0.05"}}});
  out.push_back({"cylindrical, light ones held", "cylindrical", {{"qFac", "0.05"}}});
  out.push_back({"ball, mode 1", "ball", {{"mode", "1"}}});
  out.push_back({"ball, mode 2", "ball", {{"mode", "2"}}});
  out.push_back({"ball, race free along its axis", "ball", {{"kDCR", "1"}, {"kFD12", "0"}}});
  out.push_back(
      {"ball in oil", "ball", {{"kTrac", "4"}, {"reRaceFilm", "1.0e-8"}, {"strParam", "0.0"}}});
  const Sets wavy{{"kRaceGeoImp1", "2"}, {"rndVar11", "1e-6"}, {"rndVar21", "7"}};
  out.push_back({"ball, wavy race", "ball", wavy});
  out.push_back({"cylindrical, wavy race", "cylindrical", wavy});
  out.push_back({"balls that differ", "ball", {{"kReGeoImp", "2"}, {"reDiaVar1", "2e-6"}}});
  return out;
}

deck::Deck deck_of(const Case& of, const std::string& plot_every, const std::string& last,
                   const std::string& substeps = "1") {
  deck::Deck deck = deck::new_deck(of.type);
  deck.set_all(of.sets);
  deck.complete();
  deck.set_all(Sets{{"maxStps", last},
                    {"nStps", substeps},
                    {"kPltFreq", plot_every},
                    {"kAGraf", "0"},
                    {"kPrtFreq", "7"},  // a listing in between takes nothing from the band
                    {"kLifeFreq", "0"}});
  return deck;
}

/// The channels of a file that have a band, and how many values each has.
std::vector<std::pair<std::string, std::size_t>> banded(const results::H5Reader& file) {
  std::vector<std::pair<std::string, std::size_t>> out;
  for (std::size_t k = 0; k < scene::kExtremeQuantityCount; ++k) {
    const std::string id(results::channel_of(static_cast<scene::ExtremeQuantity>(k)));
    if (const auto* channel = file.find(id)) out.emplace_back(id, channel->size());
  }
  return out;
}

/// Two ways to form one sum.
double rounding(double size) { return 1e-9 * size + 1e-12; }

/// The rules of bands, whatever the run.
void check_rules(const results::H5Reader& file) {
  for (const auto& [id, width] : banded(file)) {
    const auto value = file.read(id), low = file.read(id + "_low"), high = file.read(id + "_high"),
               mean = file.read(id + "_mean");
    REQUIRE(low.size() == value.size());
    std::size_t faults = 0;
    const bool slip = id.ends_with("slip");
    for (std::size_t i = 0; i < value.size(); ++i)
      if (slip && value[i] == 0.0) {  // nothing touches
        if (!(0.0 <= low[i] && low[i] <= mean[i] && mean[i] <= high[i])) ++faults;
      } else if (!(low[i] <= value[i] && value[i] <= high[i] && low[i] <= mean[i] &&
                   mean[i] <= high[i]))
        ++faults;
    INFO(id);
    CHECK(faults == 0);
  }
}

}  // namespace

TEST_CASE("step bands: extremes equal those of a run that stores every step",
          "[physics][step-band][slow]") {
  for (const Case& of : cases()) {
    INFO(of.name);
    testing::TemporaryFolder folder;
    (void)testing::run_deck(deck_of(of, "1", "60"), folder / "every");
    (void)testing::run_deck(deck_of(of, "10", "60"), folder / "tenth");
    const results::H5Reader all(folder / "every" / "RESULTS.h5"),
        some(folder / "tenth" / "RESULTS.h5");
    REQUIRE(all.steps() == 61);
    REQUIRE(some.steps() == 7);
    check_rules(some);
    const bool cage = all.find("land.force") != nullptr;
    CHECK(banded(all).size() >= (cage ? 11U : 10U));
    for (const auto& [id, width] : banded(all)) {
      INFO(id);
      const auto value = all.read(id);
      for (const char* suffix : {"_low", "_high", "_mean"}) CHECK(all.read(id + suffix) == value);
      const auto low = some.read(id + "_low"), high = some.read(id + "_high"),
                 mean = some.read(id + "_mean");
      double largest = 0.0;
      for (const double v : value) largest = std::max(largest, std::abs(v));
      for (std::size_t i = 1; i < 7; ++i)
        for (std::size_t k = 0; k < width; ++k) {
          double least = 1e300, most = -1e300, sum = 0.0;
          std::size_t looks = 0;
          for (std::size_t step = 10 * i - 9; step <= 10 * i; ++step) {
            const double at = value[step * width + k];
            if (id.ends_with("slip") && at == 0.0) continue;  // nothing touches
            least = std::min(least, at);
            most = std::max(most, at);
            sum += at;
            ++looks;
          }
          if (looks == 0) least = most = 0.0;
          sum /= static_cast<double>(std::max(looks, std::size_t{1}));
          const double margin = rounding(largest);
          INFO("stored step " << i << ", place " << k);
          CHECK(low[i * width + k] == Approx(least).margin(margin));
          CHECK(high[i * width + k] == Approx(most).margin(margin));
          CHECK(mean[i * width + k] == Approx(sum).margin(margin));
        }
    }
  }
}

TEST_CASE("step bands: peaks of a pocket force between stored steps are only in its band",
          "[physics][step-band]") {
  testing::TemporaryFolder folder;
  const Case ball{"ball", "ball", {}};
  // Elastic contacts: damped vibrations leave no peaks between stored steps after the start.
  const testing::Options elastic{{"contactDamping", "0"}};
  (void)testing::run_deck(deck_of(ball, "1", "400"), folder / "every", false, elastic);
  const auto ran = testing::run_deck(deck_of(ball, "10", "400"), folder / "tenth", false, elastic);
  CHECK(ran.report["plan"]["estimates"]["fastest_frequency_Hz"].get<double>() ==
        Approx(2.625e4).epsilon(1e-3));  // `adore plan` of this deck
  const results::H5Reader all(folder / "every" / "RESULTS.h5"),
      some(folder / "tenth" / "RESULTS.h5");
  for (const char* id : {"pocket.force", "contact.load", "contact.heat", "contact.slip"}) {
    INFO(id);
    const auto dense = all.read(id), stored = some.read(id),
               high = some.read(std::string(id) + "_high");
    const std::size_t width = all.find(id)->size();
    double hidden = 0.0, told = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < width; ++k) {
      double peak = 0.0, of_stored = 0.0, of_band = 0.0;
      for (std::size_t i = k; i < dense.size(); i += width) peak = std::max(peak, dense[i]);
      for (std::size_t i = k; i < stored.size(); i += width) {
        of_stored = std::max(of_stored, stored[i]);
        of_band = std::max(of_band, high[i]);
      }
      hidden = std::max(hidden, peak - of_stored);
      told = std::max(told, std::abs(peak - of_band));
      largest = std::max(largest, peak);
    }
    CHECK(hidden > 1e-4 * largest);  // the stored values alone do not show the peak
    CHECK(told <= rounding(largest));
    if (std::string(id) == "pocket.force") CHECK(hidden > 0.02 * largest);
  }
}

TEST_CASE("step bands: extremes include both sides of a thermal step",
          "[physics][step-band][thermal]") {
  const Sets thermal{{"kTherm", "1"},       {"kCoolant", "14"}, {"kBaseTemp", "3"},
                     {"baseTemp", "330"},   {"kHTC", "0"},      {"cFlowRate", "1e-4"},
                     {"aveTime", "2.0e-5"}, {"skipTime", "0"},  {"kGeoMod", "1"},
                     {"kMatPropMod", "1"}};
  for (const char* type : {"ball", "cylindrical", "spherical-tapered"}) {
    INFO(type);
    testing::TemporaryFolder folder;
    const Case of{type, type, thermal};
    (void)testing::run_deck(deck_of(of, "1", "120"), folder / "every");
    (void)testing::run_deck(deck_of(of, "40", "120"), folder / "some");
    const results::H5Reader all(folder / "every" / "RESULTS.h5"),
        some(folder / "some" / "RESULTS.h5");
    REQUIRE(some.steps() == 4);
    check_rules(all);
    check_rules(some);
    bool jumps = false;
    for (const auto& [id, width] : banded(all)) {
      INFO(id);
      const auto value = all.read(id), least = all.read(id + "_low"), most = all.read(id + "_high"),
                 low = some.read(id + "_low"), high = some.read(id + "_high");
      double largest = 0.0;
      for (const double v : most) largest = std::max(largest, std::abs(v));
      for (std::size_t i = 1; i < 4; ++i)
        for (std::size_t k = 0; k < width; ++k) {
          double from = 1e300, to = -1e300;
          for (std::size_t step = 40 * i - 39; step <= 40 * i; ++step) {
            const std::size_t at = step * width + k;
            if (id.ends_with("slip") && most[at] == 0.0) continue;  // nothing touched
            from = std::min(from, least[at]);
            to = std::max(to, most[at]);
            jumps = jumps || most[at] - least[at] > 0.01 * largest;
          }
          if (to < from) from = to = 0.0;
          INFO("stored step " << i << ", place " << k);
          CHECK(low[i * width + k] == Approx(from).margin(rounding(largest)));
          CHECK(high[i * width + k] == Approx(to).margin(rounding(largest)));
        }
    }
    CHECK(jumps);
  }
}

TEST_CASE("step bands: substeps between counted steps → same rules", "[physics][step-band]") {
  for (const Case& of : cases()) {
    if (of.sets.size() > 1) continue;
    INFO(of.name);
    testing::TemporaryFolder folder;
    (void)testing::run_deck(deck_of(of, "3", "12", "5"), folder / "run");
    check_rules(results::H5Reader(folder / "run" / "RESULTS.h5"));
  }
}

TEST_CASE("step bands: continued run → extremes as without a break", "[physics][step-band]") {
  for (const char* type : {"ball", "cylindrical"}) {
    INFO(type);
    const Case of{type, type, {}};
    testing::TemporaryFolder folder;
    (void)testing::run_deck(deck_of(of, "10", "40"), folder / "whole");
    (void)testing::run_deck(deck_of(of, "10", "25"), folder / "parts");
    (void)testing::run_deck(deck_of(of, "10", "40"), folder / "parts", true);
    const results::H5Reader whole(folder / "whole" / "RESULTS.h5"),
        parts(folder / "parts" / "RESULTS.h5");
    REQUIRE(whole.step_numbers() == std::vector<long>{0, 10, 20, 30, 40});
    // The last step of a run is always stored: the looks of 21 to 30 are in two rows there.
    REQUIRE(parts.step_numbers() == std::vector<long>{0, 10, 20, 25, 30, 40});
    for (const auto& [id, width] : banded(whole)) {
      INFO(id);
      for (const auto& [row, other] :
           {std::pair<std::size_t, std::size_t>{0, 0}, {1, 1}, {2, 2}, {4, 5}})
        for (const char* suffix : {"_low", "_high", "_mean"})
          CHECK(whole.read(id + suffix, row, 1) == parts.read(id + suffix, other, 1));
      const auto low = whole.read(id + "_low", 3, 1), high = whole.read(id + "_high", 3, 1),
                 low_25 = parts.read(id + "_low", 3, 1), low_30 = parts.read(id + "_low", 4, 1),
                 high_25 = parts.read(id + "_high", 3, 1), high_30 = parts.read(id + "_high", 4, 1);
      double largest = 0.0;
      for (const double v : whole.read(id)) largest = std::max(largest, std::abs(v));
      const double margin = rounding(largest);  // step 25 was looked at as it was stored
      for (std::size_t k = 0; k < low.size(); ++k) {
        CHECK(low[k] == Approx(std::min(low_25[k], low_30[k])).margin(margin));
        CHECK(high[k] == Approx(std::max(high_25[k], high_30[k])).margin(margin));
      }
    }
  }
}
