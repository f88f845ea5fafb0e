#include "deck/reader.hpp"
#include "setup/build_bearing.hpp"
#include "statics/roller_statics.hpp"
#include "support/paths.hpp"
#include "thermal/operating.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

using namespace adore;
using statics::RollerSolution;
using statics::solve_roller_statics;

namespace {

/// Every roller bearing of `adore examples`.
constexpr std::array<const char*, 7> kExamples{
    "cylindrical",       "spherical",       "tapered",      "spherical-tapered",
    "cylindrical-nu209", "spherical-22210", "tapered-30208"};

bearing::Bearing example(const std::string& name) {
  deck::ReadResult read =
      deck::read_deck(adore::test::source_dir().string() + "/resources/decks/" + name + ".txt");
  REQUIRE(read.ok());
  read.deck.set("mode", "-1");
  read.deck.complete();
  return thermal::operating_bearing(setup::build_bearing(read.deck, 1));
}

/// The deck's load scaled so that its largest component is `force`, the inner race at `rpm`.
bearing::Bearing at(bearing::Bearing b, double force, double rpm) {
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, std::abs(b.constraints.load[k]));
  for (double& load : b.constraints.load) load *= force / largest;
  b.speed = {0.0, rpm * std::numbers::pi / 30.0};
  return b;
}

/// Largest change of a contact load over the largest contact load.
double change(const RollerSolution& a, const RollerSolution& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.rollers.size(); ++k)
    for (std::size_t j = 0; j < 2; ++j)
      largest = std::max(largest, std::abs(a.rollers[k].race[j].load - b.rollers[k].race[j].load));
  return largest / a.max_load;
}

double log_spaced(double low, double high, int k, int count) {
  return low * std::pow(high / low, static_cast<double>(k) / (count - 1));
}

struct Study {
  int solved = 0;
  double worst_neighbour = 0.0, worst_rest = 0.0, worst_load = 0.0;
};

/// 1e-3 to 100 rpm and 10 N to 20 kN, log-spaced.
Study study(const std::string& name, int speeds, int loads) {
  Study out;
  const bearing::Bearing base = example(name);
  for (int l = 0; l < loads; ++l) {
    const double force = log_spaced(10.0, 20e3, l, loads);
    const RollerSolution rest = solve_roller_statics(at(base, force, 0.0));
    RollerSolution before = rest;
    for (int n = 0; n < speeds; ++n) {
      const double rpm = log_spaced(1e-3, 100.0, n, speeds);
      CAPTURE(name, force, rpm);
      RollerSolution now;
      REQUIRE_NOTHROW(now = solve_roller_statics(at(base, force, rpm)));
      out.worst_neighbour = std::max(out.worst_neighbour, change(now, before));
      out.worst_rest = std::max(out.worst_rest, change(now, rest));
      for (std::size_t k = 0; k < 3; ++k)
        if (!base.constraints.displacement_given[k]) {
          const double asked = at(base, force, rpm).constraints.load[k];
          out.worst_load = std::max(out.worst_load, std::abs(now.load[k] - asked) / force);
        }
      ++out.solved;
      before = std::move(now);
    }
  }
  return out;
}

}  // namespace

TEST_CASE("slow rollers have their equilibrium, next to that of neighboring speeds and of rest",
          "[physics][statics][rollers][slow]") {
  for (const char* name : kExamples) {
    const Study s = study(name, 37, 7);
    INFO(name << ": neighbours " << s.worst_neighbour << ", rest " << s.worst_rest << ", load "
              << s.worst_load);
    CHECK(s.solved == 37 * 7);
    CHECK(s.worst_neighbour < 0.01);
    CHECK(s.worst_rest < 0.01);  // what is centrifugal at 100 rpm is less beside 10 N
    CHECK(s.worst_load < 1e-8);
  }
}

TEST_CASE("slow rollers, the whole grid of 200 speeds", "[.][study]") {
  for (const char* name : kExamples) {
    const Study s = study(name, 200, 23);
    WARN(name << ": " << s.solved << " solved, neighbours within " << s.worst_neighbour
              << ", rest within " << s.worst_rest << ", load within " << s.worst_load);
    CHECK(s.worst_neighbour < 0.01);
  }
}
