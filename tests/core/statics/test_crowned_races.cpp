#include "base/constants.hpp"
#include "contact/slice_contact.hpp"
#include "roller_bearings.hpp"

#include <catch2/catch.hpp>

#include <cmath>

/// Raceways of cylindrical and tapered bearings that are crowned (raceCrn, raceCenLen).
using namespace adore;
using contact::RaceSurface;
using contact::SurfaceDepth;
using contact::Triple;

namespace {

RaceSurface cone(int side) {
  RaceSurface race = contact::cone_race(side, 0.035, 0.2);
  race.mid_x = 0.003;
  race.mid_r = 0.035 - 0.003 * std::tan(0.2);
  return race;
}

/// A point at l along the generator and `depth` into the race, `psi` off the plane of x and z.
Triple<double> point_at(const RaceSurface& race, double l, double depth, double psi) {
  const double x = race.mid_x + l * race.cos_angle + race.sigma() * depth * race.sin_angle;
  const double r = race.mid_r - l * race.sin_angle + race.sigma() * depth * race.cos_angle;
  return {x, r * std::sin(psi), r * std::cos(psi)};
}

void compare(const statics::RollerSolution& a, const statics::RollerSolution& b, double share) {
  for (std::size_t i = 0; i < a.rollers.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const auto& one = a.rollers[i].race[j].slice_load;
      const auto& two = b.rollers[i].race[j].slice_load;
      REQUIRE(one.size() == two.size());
      for (std::size_t k = 0; k < one.size(); ++k) {
        INFO("roller " << i << ", race " << j << ", slice " << k);
        CHECK(two[k] == Approx(one[k]).margin(share * a.max_load));
      }
    }
}

}  // namespace

TEST_CASE("the depth in a crowned raceway is the distance to its circle", "[unit][rollers]") {
  for (const int side : {0, 1}) {
    const double R = 0.3, land = 0.004;
    RaceSurface race = contact::crowned_race(cone(side), R, land);
    race.land_offset = 3e-4;
    for (const double l : {-0.006, -0.00175, -0.0016, 0.0, 0.0022, 0.0024, 0.005})
      for (const double depth : {-2e-5, 0.0, 3e-6, 4e-4}) {
        const Triple<double> X = point_at(race, l, depth, 0.1);
        const SurfaceDepth<double> at = contact::surface_depth(race, X);
        const double e = std::max(std::abs(l - race.land_offset) - 0.5 * land, 0.0);
        INFO("side " << side << ", l " << l << ", depth " << depth);
        CHECK(at.depth == Approx(R - std::hypot(e, R - depth)).margin(1e-15));
        CHECK(dot(at.n, at.n) == Approx(1.0).epsilon(1e-14));
        CHECK(dot(at.meridian, at.meridian) == Approx(1.0).epsilon(1e-14));
        CHECK(std::abs(dot(at.meridian, at.n)) < 1e-14);
        CHECK(at.A_meridian == Approx(e > 0.0 ? -1.0 / std::hypot(e, R - depth) : 0.0));
        // n is the gradient, A_meridian how it turns along the meridian.
        constexpr double h = 1e-6;
        for (const Triple<double>& d :
             {Triple<double>{1, 0, 0}, Triple<double>{0, 1, 0}, Triple<double>{0, 0, 1}}) {
          const double slope = (contact::surface_depth(race, X + h * d).depth -
                                contact::surface_depth(race, X + -h * d).depth) /
                               (2.0 * h);
          CHECK(slope == Approx(dot(at.n, d)).margin(1e-8));
        }
        if (std::abs(e) > 1e-5) {
          const Triple<double> m = at.meridian;
          const Triple<double> turned = contact::surface_depth(race, X + h * m).n +
                                        -1.0 * contact::surface_depth(race, X + -h * m).n;
          CHECK(dot(turned, m) / (2.0 * h) == Approx(at.A_meridian).epsilon(1e-5));
        }
      }
  }
}

TEST_CASE("a crown of infinite radius, or whose land has no end, is a straight raceway",
          "[unit][rollers]") {
  for (const auto& [radius, land] : {std::pair{kInfinity, 0.0}, {1e10, 0.0}, {0.2, 1.0}}) {
    const RaceSurface straight = cone(1), crowned = contact::crowned_race(straight, radius, land);
    for (const double l : {-0.006, 0.0, 0.005}) {
      const Triple<double> X = point_at(straight, l, 3e-6, 0.0);
      CHECK(contact::surface_depth(crowned, X).depth ==
            Approx(contact::surface_depth(straight, X).depth).margin(3e-15));
    }
  }
  for (bearing::Bearing b :
       {roller_bearings::cylindrical(6000.0), roller_bearings::tapered(6000.0)}) {
    const auto flat = statics::solve_roller_statics(b);
    b.rollers()->race_crown_radius = {1e9, 0.3};
    b.rollers()->race_central_length = {0.0, 0.1};
    compare(flat, statics::solve_roller_statics(b), 1e-7);
    b.rollers()->race_central_length = {0.0, 0.002};
    const auto crowned = statics::solve_roller_statics(b);
    CHECK(crowned.rollers[0].race[1].peak_pressure > 1.02 * flat.rollers[0].race[1].peak_pressure);
  }
}

TEST_CASE("the crown of the races does what the same crown of the rollers does",
          "[physics][rollers]") {
  for (bearing::Bearing b : {roller_bearings::cylindrical(0.0), roller_bearings::tapered(0.0)}) {
    bearing::RollerGeometry& g = *b.rollers();
    g.crown_radius = 0.8;
    g.central_length = 0.003;
    const auto rollers = statics::solve_roller_statics(b);
    g.race_crown_radius = {0.8, 0.8};
    g.race_central_length = {0.003, 0.003};
    g.crown_radius = 1e10;
    const auto races = statics::solve_roller_statics(b);
    g.race_crown_radius = {0.0, 0.0};
    const auto neither = statics::solve_roller_statics(b);
    INFO("type " << static_cast<int>(b.type));
    // Cones find their place along the axis, 19 µm beside that of the drawing: the crowns of both
    // races stay behind, those of the rollers go along, by 0.1 µm of the penetration at the ends.
    const bool cone = b.type == bearing::Type::Tapered;
    compare(rollers, races, cone ? 0.01 : 2e-4);
    CHECK(races.rollers[0].race[0].slice_load.front() <
          0.9 * neither.rollers[0].race[0].slice_load.front());
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(races.displacement[k] == Approx(rollers.displacement[k]).margin(cone ? 5e-8 : 2e-8));
  }
}
