#include "base/constants.hpp"
#include "core/dynamics/system_fixture.hpp"
#include "dynamics/effect.hpp"
#include "tribology/journal_film.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

bearing::Bearing in_oil(bool lands, bool pockets) {
  bearing::Bearing b = angular_contact();
  b.cage_films = bearing::CageFilms{pockets, lands, 0.02, 0.02, 1e-4, 1e-7};
  return b;
}

ScenePlan oiled(bool lands, bool pockets) {
  ScenePlan plan = full_plan();
  if (lands) plan.effects.push_back({Effect::LandFilm, "", true, "test"});
  if (pockets) plan.effects.push_back({Effect::PocketFilm, "", true, "test"});
  return plan;
}

/// The state with its cage moved and stopped or turning.
std::vector<double> with_cage(System& system, const Vec3& offset, double speed) {
  std::vector<double> y = system.initial_state();
  for (const StateLayout::Group& group : system.layout().groups()) {
    const auto first = static_cast<std::size_t>(group.slice.first);
    if (group.name == "cage.position")
      for (std::size_t k = 0; k < 3; ++k) y[first + k] += offset[static_cast<int>(k)];
    if (group.name == "cage.velocity") std::fill_n(y.begin() + group.slice.first, 3, 0.0);
    if (group.name == "cage.omega")
      for (std::size_t k = 0; k < 3; ++k) y[first + k] = k == 0 ? speed : 0.0;
  }
  return y;
}

}  // namespace

TEST_CASE(
    "a guide land is a short journal bearing: its load and attitude angle are those of "
    "Ocvirk",
    "[physics][dynamics][analytic]") {
  const bearing::Bearing b = in_oil(true, false);
  System system = make_system(b, oiled(true, false));
  const bearing::GuideLand& land = b.cage->lands[0];
  const double c = 0.5 * land.clearance, R = 0.5 * land.diameter, L = land.width, mu = 0.02;
  for (const double e : {0.1, 0.5, 0.8}) {
    const double speed = 400.0;
    const Snapshot at = system.snapshot(0.0, with_cage(system, {0.0, 0.0, e * c}, speed));
    REQUIRE(at.cages.size() == 1);
    REQUIRE(at.cages[0].lands.size() == 2);
    const double root = std::sqrt(1.0 - e * e);
    const double load = mu * R * L * L * L * speed * e / (4.0 * c * c * std::pow(root, 4)) *
                        std::sqrt(kPi * kPi * root * root + 16.0 * e * e);
    for (const LandSnapshot& shown : at.cages[0].lands) {
      INFO("eccentricity " << e);
      CHECK(shown.film_force == Approx(load).epsilon(1e-3));  // of turned and offset lands alike
      CHECK(std::tan(shown.attitude) == Approx(kPi * root / (4.0 * e)).epsilon(1e-3));
    }
    // Petroff's friction, at least.
    const double petroff = 2.0 * 2.0 * kPi * mu * R * R * R * L * speed * speed / (c * root);
    CHECK(at.energy.rate("land_film_heat") >= 0.99 * petroff);
  }
}

TEST_CASE("no speed, no film: a standing cage is neither carried nor braked",
          "[physics][dynamics]") {
  bearing::Bearing b = in_oil(true, false);
  b.speed = {0.0, 1.0};
  System system = make_system(b, oiled(true, false));
  const Snapshot at = system.snapshot(0.0, with_cage(system, {0.0, 0.0, 1e-4}, 0.0));
  for (const LandSnapshot& shown : at.cages[0].lands) CHECK(shown.film_force < 1e-9);
  CHECK(std::abs(at.energy.rate("land_film_heat")) < 1e-9);
}

TEST_CASE("cage films: lands and pockets close the ledger and cost nothing when off",
          "[physics][dynamics][energy]") {
  System plain = make_system(in_oil(false, false), full_plan());
  for (const auto& row : plain.cost().rows()) CHECK(row.name != "films of the cage");
  for (const auto& [lands, pockets] : {std::pair{true, false}, {false, true}, {true, true}}) {
    INFO("lands " << lands << ", pockets " << pockets);
    const bearing::Bearing b = in_oil(lands, pockets);
    System system = make_system(b, oiled(lands, pockets));
    CHECK(system.layout().size() == plain.layout().size() + lands + pockets);
    const double end = 4e-4;
    double previous = 0.0;
    for (const double tolerance : {1e-6, 1e-9}) {
      const RunResult result = run(system, system.initial_state(), end, tolerance, "rkf4");
      const Snapshot at = system.snapshot(end, result.y);
      const double heat = at.energy.value("land_film_heat") + at.energy.value("pocket_film_heat");
      CHECK(heat > 0.0);
      const double residual = std::abs(at.energy.residual());
      if (previous > 0.0) {
        CHECK(residual < previous);
        CHECK(residual < 0.01 * heat);
      }
      previous = residual;
    }
  }
}

TEST_CASE("cage film: largest force at the critical film, finite in contact",
          "[physics][dynamics]") {
  const bearing::Bearing b = in_oil(true, false);
  System system = make_system(b, oiled(true, false));
  const double c = 0.5 * b.cage->lands[0].clearance;
  double previous = 0.0;
  for (const double e : {0.9, 0.99, 0.9995, 1.0, 1.02}) {
    const Snapshot at = system.snapshot(0.0, with_cage(system, {0.0, 0.0, e * c}, 400.0));
    const double force = at.cages[0].lands[0].film_force;
    INFO("eccentricity " << e);
    CHECK(std::isfinite(force));
    CHECK(force >= previous * (1.0 - 1e-9));
    previous = force;
  }
}
