#include "base/errors.hpp"
#include "core/statics/hard_rollers.hpp"
#include "statics/roller_statics.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace adore;
using namespace adore::statics;
using ball_bearings::hold;
using ball_bearings::load;
using hard_rollers::Bearing;

namespace {

/// Solves and checks what holds for every solution: the given loads are carried, nothing is NaN.
RollerSolution solved(const Bearing& bearing, const RollerOptions& options = {}) {
  RollerSolution s = solve_roller_statics(bearing, options);
  double scale = s.max_load;
  for (double f : bearing.constraints.load) scale = std::max(scale, std::abs(f));
  for (std::size_t k = 0; k < 5; ++k) {
    REQUIRE(std::isfinite(s.displacement[k]));
    if (bearing.constraints.displacement_given[k]) {
      CHECK(s.displacement[k] == bearing.constraints.displacement[k]);
    } else {
      CHECK(s.load[k] == Approx(bearing.constraints.load[k]).margin(1e-8 * scale));
    }
  }
  REQUIRE(s.stiffness.allFinite());
  for (const StaticRoller& r : s.rollers) {
    REQUIRE(std::isfinite(r.x + r.r + r.tilt));
    for (const RollerRaceContact& c : r.race) {
      REQUIRE(c.load >= 0.0);
      REQUIRE(std::isfinite(c.contact_angle) == (c.load > 0.0));
    }
  }
  return s;
}

int loaded_rollers(const RollerSolution& s) {
  return static_cast<int>(std::count_if(s.rollers.begin(), s.rollers.end(),
                                        [](const StaticRoller& r) { return r.race[1].load > 0; }));
}

bool noted(const RollerSolution& s, const std::string& text) {
  return std::any_of(s.notes.begin(), s.notes.end(),
                     [&](const std::string& n) { return n.find(text) != std::string::npos; });
}

}  // namespace

TEST_CASE("radial load with clearance on a single roller", "[physics][statics][rollers][hard]") {
  Bearing bearing = hard_rollers::cylindrical(3e-5);
  for (double force : {1.0, 30.0}) {
    const auto s = solved(load(bearing, 0, 0, force));
    CHECK(loaded_rollers(s) == 1);
    CHECK(s.rollers[0].race[0].load == Approx(force).epsilon(1e-7));
    const double approach = s.rollers[0].race[0].delta + s.rollers[0].race[1].delta;
    CHECK(s.displacement[2] == Approx(1.5e-5 + approach).epsilon(1e-8));
  }
}

TEST_CASE("a load that just unloads the other rollers", "[physics][statics][rollers][hard]") {
  Bearing bearing = hard_rollers::cylindrical(3e-5);
  int previous = 0;
  for (double force = 10.0; force < 1500.0; force *= 1.15) {
    const int now = loaded_rollers(solved(load(bearing, 0, 0, force)));
    CHECK(now >= previous);
    previous = now;
  }
  CHECK(previous == 3);
  // Preload that the load takes off the far side, through the opening of the last contacts.
  Bearing tight = hard_rollers::cylindrical(-1e-5);
  previous = 16;
  for (double force = 100.0; force < 30000.0; force *= 1.6) {
    const int now = loaded_rollers(solved(load(tight, 0, 0, force)));
    CHECK(now <= previous);
    previous = now;
  }
  CHECK(previous < 16);
}

TEST_CASE("rollers with zero and negative clearance", "[physics][statics][rollers][hard]") {
  Bearing bearing = hard_rollers::cylindrical(0.0);
  CHECK(solved(bearing).max_load == 0.0);
  CHECK(loaded_rollers(solved(load(bearing, 0, 0, 1000))) == 7);
  Bearing tight = hard_rollers::cylindrical(-2e-5);
  CHECK(loaded_rollers(solved(tight)) == 16);
  tight.speed[1] = 500.0;
  solved(load(tight, 0, 300, 4000));
}

TEST_CASE("five milliradians of misalignment of rollers", "[physics][statics][rollers][hard]") {
  for (double rpm : {0.0, 6000.0}) {
    Bearing bearing = hard_rollers::cylindrical(2e-5, rpm);
    hold(load(bearing, 0, 0, 5000), 3, 5e-3);
    const auto s = solved(bearing);
    CHECK(std::abs(s.load[3]) > 1.0);
    CHECK(noted(s, "corner of the roller"));
    Bearing cone = hard_rollers::tapered(rpm);
    hold(load(cone, 3000, 0, 5000), 3, 5e-3);
    solved(cone);
    Bearing follows = hard_rollers::tapered(rpm);
    load(follows, 3000, 0, 1000);
    follows.constraints.outer_misalignment = {5e-3, 0.0};
    CHECK(solved(follows).displacement[3] > 2e-3);
  }
}

TEST_CASE("three million n d_m on rollers", "[physics][statics][rollers][hard]") {
  Bearing bearing = hard_rollers::cylindrical(2e-5, 3e6 / 65.5);
  const auto s = solved(load(bearing, 0, 0, 2000));
  CHECK(noted(s, "outer race only"));
  for (const StaticRoller& r : s.rollers) {
    CHECK(r.race[0].load >= 0.999 * s.centrifugal_force);
  }
  // Cones ride up to the rib; the thrust still reaches the inner race.
  Bearing cone = hard_rollers::tapered(3e6 / 80.0);
  solved(load(cone, 20000, 0, 2000));
}

TEST_CASE("reversed thrust on cones has no equilibrium, and that is said",
          "[physics][statics][rollers][hard]") {
  Bearing cone = hard_rollers::tapered();
  solved(load(cone, 3000, 0, 0));
  CHECK_THROWS_WITH(solve_roller_statics(load(cone, -3000, 0, 0)),
                    Catch::Contains("no roller or flange holds the inner race"));
  CHECK_THROWS_AS(solve_roller_statics(load(cone, -3000, 0, 5000)), SolverError);
}

TEST_CASE("cones with their preload given as a displacement", "[physics][statics][rollers][hard]") {
  Bearing cone = hard_rollers::tapered(3000.0);
  hold(load(cone, 0, 0, 2000), 0, 2e-5);
  const auto preload = solved(cone);
  CHECK(preload.load[0] > 500.0);
  Bearing loaded = hard_rollers::tapered(3000.0);
  CHECK(solved(load(loaded, preload.load[0], 0, 2000)).displacement[0] ==
        Approx(2e-5).epsilon(1e-6));
  // Set back, nothing touches at rest.
  Bearing open = hard_rollers::tapered();
  for (std::size_t k = 0; k < 5; ++k) hold(open, k, 0.0);
  open.constraints.displacement[0] = -5e-5;
  CHECK(solved(open).max_load == 0.0);
}

TEST_CASE("barrels in grooves of factor 0.5005", "[physics][statics][rollers][hard]") {
  for (const auto contact : {RollerContact::Sliced, RollerContact::Point}) {
    Bearing bearing = hard_rollers::spherical(1e-5, 3000.0);
    bearing.rollers->groove_factor = {0.5005, 0.5005};
    hold(hold(bearing, 3, 0.0), 4, 0.0);
    RollerOptions options;
    options.contact = contact;
    solved(load(bearing, 4000, 0, 8000), options);
    solved(hold(load(bearing, 0, 0, 8000), 0, 0.0), options);
  }
}

TEST_CASE("a barrel row that swivels says so", "[physics][statics][rollers][hard]") {
  Bearing bearing = hard_rollers::spherical();
  load(bearing, 4000, 300, 5000);
  CHECK_THROWS_WITH(solve_roller_statics(bearing), Catch::Contains("tilting"));
  hold(hold(bearing, 3, 0.0), 4, 0.0);
  solved(bearing);
}

TEST_CASE("a round crown leaves the outer slices without contact",
          "[physics][statics][rollers][hard]") {
  Bearing bearing = hard_rollers::cylindrical(0.0);
  bearing.rollers->crown_radius = 0.3;
  bearing.rollers->central_length = 0.0;
  double length = 0.0;
  for (double force : {1.0, 100.0, 5000.0, 50000.0}) {
    const auto s = solved(load(bearing, 0, 0, force));
    CHECK(s.rollers[0].race[1].length >= length);
    length = s.rollers[0].race[1].length;
  }
  CHECK(length > 0.004);
  hold(bearing, 3, 3e-3);  // and the tilted roller rolls on its crown
  const auto tilted = solved(load(bearing, 0, 0, 1000));
  // Half the tilt at each race: 0.3 m of crown times 1.5 mrad, to the width of a slice, 0.36 mm.
  CHECK(std::abs(tilted.rollers[0].race[1].peak_position) == Approx(4.5e-4).margin(3.6e-4));
  // Nearly straight: all slices lose or keep contact together.
  bearing.rollers->crown_radius = 1e4;
  solved(load(bearing, 0, 0, 1000));
  hold(bearing, 3, 0.0);
  solved(load(bearing, 0, 0, 1e-3));
}

TEST_CASE("first guesses near and far lead to one equilibrium",
          "[physics][statics][rollers][hard][slow]") {
  // A hundred for each of three types; the thousand of the balls cost as much.
  std::mt19937 random(7);  // its sequence is fixed by the standard; the mapping below is ours
  const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  Bearing barrels = hard_rollers::spherical(1e-5);
  hold(hold(barrels, 3, 0.0), 4, 0.0);
  RollerOptions options;
  options.slices = 15;
  Bearing cylinder = hard_rollers::cylindrical(2e-5, 3000.0);
  Bearing cone = hard_rollers::tapered(2000.0);
  // Tilts held: between its flanges a cylinder has no unique axial place, which a free tilt would
  // feel.
  hold(hold(load(cylinder, 0, 300, 4000), 3, 0.0), 4, 0.0);
  load(cone, 4000, 0, 3000);
  load(barrels, 2000, 0, 6000);
  for (const Bearing& bearing : {cylinder, cone, barrels}) {
    const auto cold = solved(bearing, options);
    double worst = 0.0;
    for (int n = 0; n < 100; ++n) {
      Bearing guessed = bearing;
      const double size = n % 3 == 0 ? 1e-5 : n % 3 == 1 ? 2e-4 : 5e-3;  // the last is out of reach
      for (std::size_t k = 0; k < 5; ++k)
        if (!bearing.constraints.displacement_given[k])
          guessed.constraints.displacement[k] = uniform() * size / (k < 3 ? 1.0 : 0.03);
      RollerOptions warm = options;
      warm.warm_start = true;
      const auto s = solve_roller_statics(guessed, warm);
      for (std::size_t k = 0; k < 5; ++k)
        worst = std::max(worst,
                         std::abs(s.displacement[k] - cold.displacement[k]) * (k < 3 ? 1.0 : 0.03));
    }
    CAPTURE(static_cast<int>(bearing.type));
    CHECK(worst < 1e-11);  // of displacements of some 1e-5
  }
}
