#include "system_fixture.hpp"

#include <catch2/catch.hpp>

#include <cmath>
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

struct Ran {
  Snapshot last;
  long steps = 0;
  [[nodiscard]] double heat(int race) const { return last.energy.value("heat", race); }
  [[nodiscard]] double residual() const { return std::abs(last.energy.residual()); }
};

Ran ran(const bearing::Bearing& b, bool single, double end, double tolerance) {
  SystemOptions options;
  options.ellipse_major = tribology::kFilmNodes.major;
  options.ellipse_minor = tribology::kFilmNodes.minor;
  options.single_films = single;
  System system = make_system(b, full_plan(), options);
  const RunResult result = run(system, system.initial_state(), end, tolerance);
  return {system.snapshot(end, result.y), result.counters.steps};
}

}  // namespace

TEST_CASE("films by floats: a run has the heat of double precision, and its ledger closes as well",
          "[physics][dynamics][energy][film]") {
  for (const int code : {1, 6, 10, 13}) {
    const bearing::Bearing b = oiled(code);
    const double end = 5e-4;
    for (const double tolerance : {1e-5, 1e-6}) {
      CAPTURE(code, tolerance);
      const Ran numbers = ran(b, false, end, tolerance), floats = ran(b, true, end, tolerance);
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
  }
}
