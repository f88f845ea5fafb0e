#include "core/dynamics/roller_scene.hpp"
#include "system_fixture.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

/// Runs whose films are evaluated by floats (decision 460).
using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

bearing::Bearing oiled(int code) {
  bearing::Bearing b = angular_contact();
  b.lubrication.emplace();
  b.lubrication->code = code;
  b.lubrication->critical_film = 1e-8;
  b.lubrication->meniscus = 10.0;
  return b;
}

/// Means over runs of neighboring tolerances. The residual of one run is the sum of signed errors
/// of some 110 steps: it changes by its own size when the tolerance changes by 1 % (measured, kTrac
/// 13 at 1e-6 by doubles: -0.8e-5 to 2.9e-5 J, root mean square 1.3e-5 J; by floats 1.2e-5 J).
struct Ran {
  std::array<double, 2> heats{};
  double square = 0.0;  ///< mean of residual²
  long steps = 0;       ///< sum
  [[nodiscard]] double heat(int race) const { return heats[static_cast<std::size_t>(race)]; }
  [[nodiscard]] double residual() const { return std::sqrt(square); }
};

constexpr std::array kNeighbors{0.97, 0.98, 0.99, 1.0, 1.01, 1.02, 1.03};

Ran ran(System system, double end, double tolerance) {
  Ran out;
  for (const double factor : kNeighbors) {
    const RunResult result = run(system, system.initial_state(), end, factor * tolerance);
    const Snapshot last = system.snapshot(end, result.y);
    for (const int race : {0, 1})
      out.heats[static_cast<std::size_t>(race)] +=
          last.energy.value("heat", race) / static_cast<double>(kNeighbors.size());
    out.square += std::pow(last.energy.residual(), 2) / static_cast<double>(kNeighbors.size());
    out.steps += result.counters.steps;
  }
  return out;
}

Ran ran(const bearing::Bearing& b, bool single, double end, double tolerance) {
  const tribology::EllipseNodeCounts size =
      b.lubrication->code == 8 ? tribology::kStripNodes : tribology::kFilmNodes;
  SystemOptions options;
  options.ellipse_major = size.major;
  options.ellipse_minor = size.minor;
  options.single_films = single;
  return ran(make_system(b, full_plan(), options), end, tolerance);
}

/// Rollers with their rolling resistance in the same films.
Ran ran_rollers(bearing::Bearing b, bool single, double end, double tolerance) {
  using enum Effect;
  SystemOptions options;
  options.single_films = single;
  return ran(roller_scene::scene_of(std::move(b),
                                    roller_scene::plan_of({RaceContact, RaceTraction, FlangeContact,
                                                           RollingResistance}),
                                    15, 0.0, options)
                 .system,
             end, tolerance);
}

void compare(const Ran& numbers, const Ran& floats) {
  for (const int race : {0, 1}) {
    CAPTURE(race, numbers.heat(race), floats.heat(race));
    REQUIRE(numbers.heat(race) > 0.0);
    CHECK(floats.heat(race) == Approx(numbers.heat(race)).epsilon(1e-4));
    CHECK(floats.heat(race) != numbers.heat(race));
  }
  CAPTURE(numbers.residual(), floats.residual(), numbers.steps, floats.steps);
  const double heat = numbers.heat(0) + numbers.heat(1);
  CHECK(floats.residual() < 2.0 * numbers.residual() + 1e-7 * heat);
  // Noise of the forces does not shorten steps.
  CHECK(std::abs(floats.steps - numbers.steps) <= 2 + numbers.steps / 20);
}

}  // namespace

TEST_CASE("films by floats: a run has the heat of double precision, and its ledger closes as well",
          "[physics][dynamics][energy][film]") {
  for (const int code : {1, 6, 8, 10, 13})
    for (const double tolerance : {1e-5, 1e-6}) {
      CAPTURE(code, tolerance);
      const bearing::Bearing b = oiled(code);
      const double end = 5e-4;
      compare(ran(b, false, end, tolerance), ran(b, true, end, tolerance));
    }
}

TEST_CASE("films of rollers by floats: heat and ledger of a run are those of double precision",
          "[physics][rollers][energy][film]") {
  for (const int code : {3, 8, 19})
    for (const double tolerance : {1e-5, 1e-6}) {
      CAPTURE(code, tolerance);
      bearing::Bearing b = roller_bearings::tapered(6000.0);
      roller_scene::add_friction(b);
      b.lubrication = oiled(code).lubrication;
      const double end = 2e-4;
      compare(ran_rollers(b, false, end, tolerance), ran_rollers(b, true, end, tolerance));
    }
}
