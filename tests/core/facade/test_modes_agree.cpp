#include "core/facade/deck_runs.hpp"
#include "deck/templates.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

/// Under a steady load mode 1, which leaves out the inertia that contacts vibrate with, has the
/// means of mode 0 over the same whole turns.
using namespace adore;
using nlohmann::json;

namespace {

/// Over whole turns.
struct Means {
  double race[2] = {0.0, 0.0}, cage = 0.0, total = 0.0;  ///< heat [J]
  double cage_ratio = 0.0;
};

using Sets = std::vector<std::pair<std::string, std::string>>;

struct Perturbed {
  double share;  ///< of the asked axial load
  Sets start;    ///< of the cage
};

/// The example of a type as the comparisons run it.
deck::Deck deck_of(const std::string& type, const Sets& own, int mode, double share) {
  deck::Deck deck = deck::new_deck(type);
  Sets sets = own;
  for (const auto& [name, value] :
       Sets{{"mode", fmt::format("{}", mode)},
            {"kPrtOpt", "0"},
            {"kPltFreq", "1000"},
            {"kAGraf", "0"},
            {"kLifeFreq", "0"},
            {"intMet", "5"},  // whatever the examples run with: the comparison is of models
            {"stpMax", "0.5"},
            {"tol", "1e-6"},
            {"appLoadZ", fmt::format("{}", share * deck.real("appLoadZ"))}})
    sets.emplace_back(name, value);
  deck.set_all(sets);
  return deck;
}

/// Runs `deck` in `folder` and reads what it left there.
Means means_of(const deck::Deck& deck, const std::filesystem::path& folder, double turns,
               bool go_on = false) {
  deck::write_deck(deck, folder / "DATA.txt");
  facade::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.until = fmt::format("{}s", 60.0 * turns / deck.real("rpm2"));
  request.go_on = go_on;
  request.overwrite = !go_on;
  facade::run(request);
  const json report = json::parse(testing::read_bytes(folder / "RUN.json"));
  Means out;
  out.cage_ratio = report.at("summary").at("mean_cage_ratio").get<double>();
  for (const auto& [name, value] : report.at("conservation").at("energy").items()) {
    if (!name.starts_with("heat, ")) continue;
    const double heat = value.get<double>();
    out.total += heat;
    if (name.find("outer race contacts") != std::string::npos) out.race[0] += heat;
    if (name.find("inner race contacts") != std::string::npos) out.race[1] += heat;
    if (name.find("cage") != std::string::npos || name.find("guide") != std::string::npos)
      out.cage += heat;
  }
  return out;
}

Means means_of(const std::string& type, const Sets& own, int turns, int mode, double share) {
  const testing::TemporaryFolder folder;
  return means_of(deck_of(type, own, mode, share), folder / "", turns);
}

Means check(const std::string& type, const Sets& own, int turns, const Means& free) {
  const Means held = means_of(type, own, turns, 1, 1.0);
  INFO(type << ": heat of the races " << free.race[0] << " " << free.race[1] << " J, mode 1 "
            << held.race[0] << " " << held.race[1] << "; total " << free.total << ", " << held.total
            << "; cage " << free.cage << ", " << held.cage);
  REQUIRE(free.race[0] > 0.0);
  CHECK(held.cage_ratio == Approx(free.cage_ratio).epsilon(0.01));
  for (const int j : {0, 1}) CHECK(held.race[j] == Approx(free.race[j]).epsilon(0.01));
  CHECK(held.total == Approx(free.total).epsilon(0.02));
  return held;
}

/// Cage heat: no further from the mean of five runs of mode 0, the deck's own and four perturbed
/// ones, than three times their standard deviation; where they agree to six digits, a thousandth.
void check_with_spread(const std::string& type, const Sets& own, int turns,
                       const std::array<Perturbed, 4>& others) {
  std::vector<Means> free{means_of(type, own, turns, 0, 1.0)};
  for (const Perturbed& one : others) {
    Sets sets = own;
    sets.insert(sets.end(), one.start.begin(), one.start.end());
    free.push_back(means_of(type, sets, turns, 0, one.share));
  }
  const Means held = check(type, own, turns, free.front());
  double mean = 0.0, square = 0.0;
  for (const Means& one : free) mean += one.cage / 5.0;
  for (const Means& one : free) square += (one.cage - mean) * (one.cage - mean) / 4.0;
  INFO("cage heat " << mean << " +- " << std::sqrt(square) << " J, mode 1 " << held.cage);
  CHECK(std::abs(held.cage - mean) < std::max(3.0 * std::sqrt(square), 1e-3 * mean));
}

const std::array<Perturbed, 4> kLoads{{{1.0001, {}}, {0.9999, {}}, {1.0002, {}}, {0.9998, {}}}};
const std::array<Perturbed, 4> kCages{
    {{1.0, {{"cageGcPos[2]", "2e-5"}}},
     {1.0, {{"cageGcPos[3]", "-3e-5"}}},
     {1.0, {{"avRatio", "1.02"}}},
     {1.0, {{"cageGcPos[2]", "-4e-5"}, {"cageGcPos[3]", "4e-5"}}}}};

// Of rollers whose motion is chance: from states of a run of mode 0 both modes go on over `span`
// turns, in which differences between the modes grow by little.
void check_from_same_states(const std::string& type, const Sets& own, int windows, double apart,
                            double span, double race_tolerance) {
  namespace fs = std::filesystem;
  const testing::TemporaryFolder folder;
  const fs::path mother = folder / "mother";
  fs::create_directories(mother);
  Means sums[2];
  for (int k = 0; k < windows; ++k) {
    means_of(deck_of(type, own, 0, 1.0), mother, 2.0 + apart * k, k > 0);
    for (const int mode : {0, 1}) {
      const fs::path part = folder / fmt::format("{}-{}", k, mode);
      fs::create_directories(part);
      for (const char* file : {"FINAL", "MASTER"}) fs::copy_file(mother / file, part / file);
      Sets sets = own;
      sets.emplace_back("kIcOpt", "-1");
      const Means one = means_of(deck_of(type, sets, mode, 1.0), part, span);
      for (const int j : {0, 1}) sums[mode].race[j] += one.race[j];
      sums[mode].cage += one.cage;
      sums[mode].total += one.total;
      sums[mode].cage_ratio += one.cage_ratio / windows;
    }
  }
  INFO("heat of the races " << sums[0].race[0] << " " << sums[0].race[1] << " J, mode 1 "
                            << sums[1].race[0] << " " << sums[1].race[1] << "; cage "
                            << sums[0].cage << ", " << sums[1].cage << "; total " << sums[0].total
                            << ", " << sums[1].total << "; turns of the cage " << sums[0].cage_ratio
                            << ", " << sums[1].cage_ratio);
  // Skew is awake: asleep the inner race of the cylindrical example has 0.04 mJ a turn.
  REQUIRE(sums[0].race[1] > 1e-3 * windows * span);
  CHECK(sums[1].cage_ratio == Approx(sums[0].cage_ratio).epsilon(0.01));
  for (const int j : {0, 1})
    CHECK(sums[1].race[j] == Approx(sums[0].race[j]).epsilon(race_tolerance));
  CHECK(sums[1].total == Approx(sums[0].total).epsilon(0.02));
}

}  // namespace

TEST_CASE("mode 1 of the ball example has the heat and the cage speed of mode 0 over three turns",
          "[physics][facade][constrained][slow]") {
  check_with_spread("ball", {}, 3, kLoads);
}

TEST_CASE("mode 1 of a preloaded cylindrical bearing has the heat and the cage speed of mode 0",
          "[physics][facade][constrained][slow]") {
  // With play rollers skew in the unloaded zone, and no two runs have the same heat (decision 321).
  check_with_spread("cylindrical", {{"freeIntCls", "-1e-5"}}, 2, kLoads);
}

TEST_CASE("mode 1 of the tapered example has the heat and the cage speed of mode 0 over two turns",
          "[physics][facade][constrained][slow]") {
  // Over the first turn loads that differ by 1e-4 leave the cage its one way to settle, and spread
  // by 0.5 %; cages that start elsewhere spread by 6 %, 18.7 to 22.2 mJ over two turns.
  check_with_spread("tapered", {}, 2, kCages);
}

TEST_CASE("mode 1 of the spherical-tapered example has the heat and the cage speed of mode 0",
          "[physics][facade][constrained][slow]") {
  check_with_spread("spherical-tapered", {}, 2, kCages);
}

TEST_CASE("mode 1 of a spherical bearing without skew has the heat and the cage speed of mode 0",
          "[physics][facade][constrained][slow]") {
  // With skew loads that differ by 1e-4 change the heat of mode 0 by a tenth (decision 321).
  const Sets own{{"kDOF", "4"}};
  const Means free = means_of("spherical", own, 1, 0, 1.0), held = check("spherical", own, 1, free);
  CHECK(held.cage == Approx(free.cage).epsilon(0.01));
}

// Rollers with play meet the bars of their pockets about 1.5 times a turn, and each blow of 27 us
// multiplies their rate of skew by some hundred (decision 264): from rounding they reach the play
// of their flanges within three turns, and the heat of a turn is 5 to 39 mJ in either mode.
TEST_CASE("mode 1 of the cylindrical example has the heat of mode 0 from states of its own motion",
          "[physics][facade][constrained][slow]") {
  // A tilted cage wakes the skew at the first blow. Seventeen spans of a run after turn 24: outer
  // race 0.8 +- 0.3 %, inner race 0.1 +- 0.2 %, all heat -0.7 +- 1.0 %; single ones up to 6 %.
  check_from_same_states("cylindrical", {{"cageAngPos[2]", "0.02"}, {"cageAngPos[3]", "0.02"}}, 8,
                         0.25, 0.15, 0.02);
}

TEST_CASE("mode 1 of the spherical example has the heat of mode 0 from states of its own motion",
          "[physics][facade][constrained][slow]") {
  // Turn 7 of a run: races 2e-5 and 3e-5, cage 4e-4 of their heat, cage speed 1e-5.
  check_from_same_states("spherical", {}, 1, 0.0, 1.0, 0.01);
}
