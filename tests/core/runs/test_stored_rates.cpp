#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/h5_reader.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Stored positions, velocities and accelerations belong together: the change of one over a step is
/// what the next says, whatever moves.
using namespace adore;
using Sets = std::vector<std::pair<std::string, std::string>>;

namespace {

/// What is stored of the bodies, each with its rate.
constexpr std::pair<const char*, const char*> kRates[] = {
    {"element.axial_position", "element.axial_velocity"},
    {"element.radial_position", "element.radial_velocity"},
    {"element.orbital_position", "element.orbital_velocity"},
    {"element.axial_velocity", "element.axial_acceleration"},
    {"element.radial_velocity", "element.radial_acceleration"},
    {"element.orbital_velocity", "element.orbital_acceleration"},
    {"cage.position", "cage.velocity"},
    {"cage.axial_position", "cage.axial_velocity"},
    {"cage.radial_position", "cage.radial_velocity"},
    {"cage.axial_velocity", "cage.axial_acceleration"},
    {"cage.radial_velocity", "cage.radial_acceleration"},
    {"race.axial_position", "race.axial_velocity"},
    {"race.radial_position", "race.radial_velocity"},
    {"race.axial_velocity", "race.axial_acceleration"},
    {"race.radial_velocity", "race.radial_acceleration"},
    {"race.rotation", "race.angular_velocity"}};
/// The last rate is a size without a sign.
constexpr std::string_view kSize = "race.angular_velocity";

/// The change of each value over each step against the trapezoid of its rate, whose error is at
/// most the step times the change of the rate where that is monotonic over the step [choice: a
/// tenth of the largest rate more, for rates that turn round]. @return the worst, of what is
/// allowed
double worst_rate(const results::H5Reader& file, const std::string& value, const std::string& rate,
                  const std::vector<double>& time, bool size_alone, std::string& where) {
  if (file.find(value) == nullptr || file.find(rate) == nullptr) return 0.0;
  const std::vector<double> x = file.read(value), v = file.read(rate);
  REQUIRE(x.size() == v.size());
  const std::size_t width = x.size() / time.size();
  double worst = 0.0;
  for (std::size_t c = 0; c < width; ++c) {
    double largest = 0.0, size = 0.0;
    for (std::size_t k = 0; k < time.size(); ++k) {
      largest = std::max(largest, std::abs(v[k * width + c]));
      size = std::max(size, std::abs(x[k * width + c]));
    }
    for (std::size_t k = 0; k + 1 < time.size(); ++k) {
      const double h = time[k + 1] - time[k];
      const double before = v[k * width + c], after = v[(k + 1) * width + c];
      const double made = x[(k + 1) * width + c] - x[k * width + c];
      const double allowed = h * (std::abs(after - before) + 0.1 * largest) + 1e-12 * size + 1e-15;
      const double off =
          std::abs((size_alone ? std::abs(made) : made) - 0.5 * h * (before + after)) / allowed;
      if (off > worst)
        worst = off, where = fmt::format("{}[{}] by {:.6g} in {:.3g} s, at {:.6g} and {:.6g}",
                                         value, c, made, h, before, after);
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("stored velocities: each is the rate of the stored position", "[validation][outputs]") {
  const std::pair<const char*, Sets> scenes[] = {
      {"ball", {}},
      {"cylindrical", {}},
      {"spherical", {}},
      {"tapered", {}},
      {"spherical-tapered", {}},
      {"ball",
       {{"nCseg", "3"},
        {"cageAngCut", "2"},
        {"lSeg[1]", "1"},
        {"lSeg[2]", "5"},
        {"lSeg[3]", "9"},
        {"kNumPltElem", "1"},
        {"kPltElemInd", "1"},
        {"kAGraf", "0"}}},
      {"ball", {{"nCseg", "0"}, {"kNumPltElem", "1"}, {"kPltElemInd", "1"}}},
      {"ball", {{"kDCR", "1"}, {"kFD12", "0"}, {"kFD22", "0"}, {"kFD32", "0"}}},
      {"ball",
       {{"kVarLoad", "2"},
        {"raceVibAmp11", "1e-6"},
        {"raceVibAmp22", "2e-6"},
        {"raceVibFreq1", "2000"},
        {"raceVibFreq2", "3000"}}},
      {"ball", {{"kVarSpeed", "1"}, {"raceAngAcc2", "1e6"}, {"endTime2", "1"}}},
      {"ball", {{"kRotFrame", "1"}, {"brgOrbitRad", "0.1"}, {"brgAngVel", "600"}}},
  };
  std::set<std::string> compared;
  for (const auto& [type, sets] : scenes) {
    deck::Deck deck = deck::new_deck(type);
    // Steps short enough for differences.
    deck.set_all(Sets{{"maxStps", "40"},
                      {"nStps", "1"},
                      {"kPltFreq", "1"},
                      {"kPrtFreq", "0"},
                      {"intMet", "5"},
                      {"stpMax", "0.5"}});
    deck.set_all(sets);
    std::string scene = type;
    for (const auto& [name, value] : sets) scene += fmt::format(" {}={}", name, value);
    INFO(scene);
    const testing::TemporaryFolder folder;
    // Growth of the rings moves bodies between steps in a ramp (decision 816), without a velocity.
    (void)testing::run_deck(deck, folder / "run", false, {{"centrifugalGrowth", "0"}});
    const results::H5Reader file(folder / "run/RESULTS.h5");
    const std::vector<double> time = file.read("time");
    REQUIRE(time.size() == 41);
    for (const auto& [value, rate] : kRates) {
      if (file.find(value) != nullptr && file.find(rate) != nullptr) compared.insert(value);
      std::string where;
      const double worst = worst_rate(file, value, rate, time, rate == kSize, where);
      INFO(where);
      CHECK(worst < 1.0);
    }
  }
  CHECK(compared.size() == std::size(kRates));  // a channel that is named otherwise is none
}
