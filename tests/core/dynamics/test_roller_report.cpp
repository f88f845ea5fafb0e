#include "core/dynamics/roller_scene.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

/// What reports tell of rollers on their races (dynamics/effects/roller_race_report.cpp).
using namespace adore;
using scene::RaceContactSnapshot;
using scene::Snapshot;

TEST_CASE("a report of rollers holds what their right-hand side has, slice by slice",
          "[physics][rollers][output]") {
  using namespace roller_bearings;
  for (bearing::Bearing b : {cylindrical(5000.0), tapered(3000.0), spherical(3000.0)}) {
    roller_scene::add_friction(b);
    roller_scene::add_cage(b);
    roller_scene::Scene made = roller_scene::scene_of(b, roller_scene::with_friction(), 13);
    dynamics::System& system = made.system;
    const fixture::RunResult moved = fixture::run(system, system.initial_state(), 2e-4, 1e-6);
    const Snapshot s = system.snapshot(2e-4, moved.y);
    INFO("type " << static_cast<int>(b.type));
    for (std::size_t j = 0; j < 2; ++j) {
      double heat = 0.0;
      int pressed = 0;
      for (std::size_t i = 0; i < s.elements.size(); ++i) {
        const RaceContactSnapshot& c = s.elements[i].race[j];
        heat += c.heat;
        REQUIRE(c.slice_load.size() == 13);
        REQUIRE(c.slice_pressure.size() == 13);
        // The kernels of both round a place on the race (1e-17 m) each in its own way, with a
        // stiffness of 3e8 N/m.
        CHECK(c.load == Approx(system.contact_loads(j)[i]).epsilon(1e-12).margin(3e-9));
        CHECK(std::accumulate(c.slice_load.begin(), c.slice_load.end(), 0.0) ==
              Approx(c.load).epsilon(1e-13).margin(1e-12));
        CHECK(c.max_pressure ==
              Approx(*std::max_element(c.slice_pressure.begin(), c.slice_pressure.end()))
                  .epsilon(1e-9));
        if (!(c.load > 0.0)) {
          CHECK((c.max_pressure == 0.0 && c.half_major == 0.0 && c.max_slip == 0.0));
          continue;
        }
        ++pressed;
        CHECK(c.load_slip <= c.load * c.max_slip * (1.0 + 1e-12));
        // Hertz at the slice with the largest pressure: q = π/2 b p.
        const auto peak = static_cast<std::size_t>(
            std::max_element(c.slice_pressure.begin(), c.slice_pressure.end()) -
            c.slice_pressure.begin());
        const double width =
            c.slice_load[peak] / (1.5707963267948966 * c.half_minor * c.max_pressure);
        const double whole = b.rollers()->contact_length() / 13.0;
        CHECK(width <= whole * (1.0 + 1e-9));
        CHECK(width > 0.0);
      }
      CHECK(pressed > 0);
      CHECK(heat == Approx(s.energy.rate("heat", static_cast<int>(j))).epsilon(1e-12));
    }
  }
}
