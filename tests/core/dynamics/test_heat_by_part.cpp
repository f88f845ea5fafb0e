#include "contact/cage_inertia.hpp"
#include "core/dynamics/roller_scene.hpp"
#include "core/dynamics/system_fixture.hpp"
#include "scene/user_laws.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Heat of each pocket and of each guide land.
using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;
using scene::Snapshot;

namespace {

using enum scene::Effect;

std::size_t first_of(const System& system, const std::string& name) {
  for (const StateLayout::Group& group : system.layout().groups())
    if (group.name == name) return static_cast<std::size_t>(group.slice.first);
  throw std::runtime_error(name);
}

/// Everything at rest.
std::vector<double> at_rest(System& system) {
  std::vector<double> y = system.initial_state();
  for (const StateLayout::Group& group : system.layout().groups()) {
    const std::string& name = group.name;
    const bool speed = name.ends_with("_dot") || name.ends_with("cage.velocity") ||
                       name.find("omega") != std::string::npos;
    if (speed) std::fill_n(y.begin() + group.slice.first, group.slice.count, 0.0);
  }
  return y;
}

struct Sums {
  double pockets = 0.0, lands = 0.0, least = 0.0;  ///< [W]
  int warm_pockets = 0, warm_lands = 0;
};
Sums sums_of(const Snapshot& at) {
  Sums out;
  for (const scene::ElementSnapshot& e : at.elements) {
    out.pockets += e.pocket_heat;
    out.least = std::min(out.least, e.pocket_heat);
    out.warm_pockets += e.pocket_heat > 0.0;
  }
  for (const scene::CageSnapshot& cage : at.cages)
    for (const scene::LandSnapshot& land : cage.lands) {
      out.lands += land.heat;
      out.least = std::min(out.least, land.heat);
      out.warm_lands += land.heat > 0.0;
    }
  return out;
}

/// Sums are what the ledger says; a part is warm where it is touched, and nowhere else.
/// @param films, routines: act too; the latter may cool
void check_sums(const Snapshot& at, bool films, bool routines = false) {
  const Sums sums = sums_of(at);
  const scene::EnergyLedger& energy = at.energy;
  const double pockets = energy.rate("pocket_heat") + energy.rate("pocket_film_heat"),
               lands = energy.rate("land_heat") + energy.rate("land_film_heat");
  CAPTURE(pockets, lands, sums.warm_pockets, sums.warm_lands);
  CHECK(sums.pockets == Approx(pockets).epsilon(1e-12));
  CHECK(sums.lands == Approx(lands).epsilon(1e-12));
  if (!routines) CHECK(sums.least >= 0.0);
  CHECK(sums.warm_pockets >= 2);
  CHECK(sums.warm_lands >= 2);
  if (films || routines) return;
  for (const scene::CageSnapshot& cage : at.cages)
    for (const scene::LandSnapshot& land : cage.lands)
      CHECK((land.heat > 0.0) == (land.force > 0.0));
}

/// The state with all elements against the walls of their pockets, every other one ahead, and the
/// cage or its pieces against the lands.
std::vector<double> pressed(System& system, double ahead, const Vec3& aside) {
  std::vector<double> y = system.initial_state();
  const auto n = static_cast<std::size_t>(system.bearing().element_count());
  const std::size_t theta = first_of(system, "element.theta");
  for (std::size_t i = 0; i < n; ++i) y[theta + i] += i % 2 == 0 ? ahead : -ahead;
  for (const StateLayout::Group& group : system.layout().groups())
    if (group.name.ends_with("cage.position") ||
        (group.name.starts_with("cage") && group.name.ends_with("position")))
      for (int k = 0; k < 3; ++k) y[static_cast<std::size_t>(group.slice.first + k)] += aside[k];
  return y;
}

void cut(bearing::Bearing& b, int pieces, bool through_pockets) {
  b.cage->segments = {pieces, through_pockets, 0, std::numbers::pi / 180.0};
  b.cage->later_segment_starts.assign(static_cast<std::size_t>(pieces - 1), *b.cage);
  b.cage->inertia = contact::cage_inertia(b);
}

scene::ScenePlan cage_plan() {
  return plan_with({RaceContact, RaceTraction, PocketContact, PocketTraction, LandContact,
                    LandTraction, CageMotion, WearIntegrals});
}

/// ADRX3 and ADRX4 that give a quarter more than what is built in.
struct Stiffer final : scene::UserContactForce, scene::UserLaws {
  static constexpr double kMore = 1.25;
  Stiffer() { pocket = land = this; }
  bool forces(double, const Contacts& c) noexcept override {
    for (std::size_t k = 0; k < c.n; ++k) c.force[k] = kMore * c.built_in[k];
    return true;
  }
  [[nodiscard]] bool failed() const noexcept override { return false; }
  bool refused() noexcept override { return false; }
};

}  // namespace

TEST_CASE("a ball that spins against its pocket heats that pocket by force, friction and slip",
          "[physics][dynamics][heat]") {
  const bearing::Bearing b = angular_contact();
  System system = make_system(
      b, plan_with({RaceContact, PocketContact, PocketTraction, LandContact, CageMotion}));
  std::vector<double> y = at_rest(system);
  constexpr std::size_t ball = 4;
  const double spin = 3000.0, radius = 0.5 * b.balls().diameter;
  y[first_of(system, "element.theta") + ball] += 1.54e-4 / 0.0475;  // play is 1.5e-4 m
  y[first_of(system, "element.omega_x") + ball] = spin;
  const Snapshot at = system.snapshot(0.0, y);
  const double force = at.elements[ball].pocket.at(0).force;
  REQUIRE(force > 1.0);
  // kappa = (-0.05 + 0 s) exp(-2 s) + 0.05 at 19 m/s: 0.05.
  // The wall is met a little beside the middle: 0.011 rad.
  const Vec3& q = at.elements[ball].pocket_to_centre;
  const double slip = spin * radius * std::abs(q[1]) / std::hypot(q[0], q[1]);
  CHECK(at.elements[ball].pocket_heat == Approx(0.05 * force * slip).epsilon(1e-6));
  for (std::size_t i = 0; i < at.elements.size(); ++i)
    if (i != ball) CHECK(at.elements[i].pocket_heat == 0.0);
  CHECK(at.energy.rate("pocket_heat") == at.elements[ball].pocket_heat);
}

TEST_CASE("a roller that spins against its pocket heats that pocket by force, friction and slip",
          "[physics][rollers][heat]") {
  bearing::Bearing b = roller_bearings::cylindrical(3000.0);
  roller_scene::add_cage(b);
  roller_scene::add_friction(b);
  roller_scene::Scene s = roller_scene::scene_of(
      b,
      roller_scene::plan_of({RaceContact, PocketContact, PocketTraction, LandContact, CageMotion}),
      9);
  std::vector<double> y = at_rest(s.system);
  constexpr std::size_t roller = 5;
  const double spin = 3000.0, radius = 0.5 * b.element_diameter();
  y[first_of(s.system, "element.theta") + roller] += 1.27e-4 / 0.03;  // play is 1.25e-4 m
  y[first_of(s.system, "element.omega_x") + roller] = spin;
  const Snapshot at = s.system.snapshot(0.0, y);
  double force = 0.0;
  for (const scene::PocketContactSnapshot& wall : at.elements[roller].pocket) force += wall.force;
  REQUIRE(force > 1.0);
  // Slices of the crown drop by micrometres.
  CHECK(at.elements[roller].pocket_heat == Approx(0.05 * force * spin * radius).epsilon(1e-3));
  for (std::size_t i = 0; i < at.elements.size(); ++i)
    if (i != roller) CHECK(at.elements[i].pocket_heat == 0.0);
}

TEST_CASE("a cage that turns on one of its lands heats that land by force, friction and slip",
          "[physics][dynamics][heat]") {
  bearing::Bearing b = angular_contact();
  b.cage->lands[1].clearance = 8e-4;  // does not touch
  System system = make_system(
      b, plan_with({RaceContact, PocketContact, LandContact, LandTraction, CageMotion}));
  std::vector<double> y = at_rest(system);
  const double speed = 400.0, radius = 0.5 * b.cage->lands[0].diameter;
  y[first_of(system, "cage.position") + 1] += 2.05e-4;  // play is 2e-4 m
  y[first_of(system, "cage.omega")] = speed;
  const Snapshot at = system.snapshot(0.0, y);
  const scene::LandSnapshot &one = at.cages.at(0).lands.at(0), &other = at.cages[0].lands.at(1);
  REQUIRE(one.force > 1.0);
  REQUIRE(other.force == 0.0);
  const double slip = speed * radius, friction = -0.06 * std::exp(-slip) + 0.06;
  CHECK(one.heat == Approx(friction * one.force * slip).epsilon(1e-6));
  CHECK(other.heat == 0.0);
  CHECK(at.energy.rate("land_heat") == one.heat);
}

TEST_CASE("heat of pockets and of lands sums up to the ledger's, whatever the cage of balls",
          "[physics][dynamics][heat]") {
  const double ahead = 1.54e-4 / 0.035;
  for (const int pieces : {1, 3})
    for (const bool through : {false, true})
      for (const bool errors : {false, true}) {
        if (pieces == 1 && through) continue;
        bearing::Bearing b = angular_contact(9, 0.07);
        if (errors) {
          b.cage->lands[0].of_cage = {bearing::RaceErrors::Roundness::Sinusoidal, {3e-5, 4.0, 0.3}};
          b.cage->pocket = bearing::PocketShape::Rectangular;
        }
        if (pieces > 1) cut(b, pieces, through);
        INFO(pieces << " pieces, through pockets " << through << ", uneven " << errors);
        System system = make_system(b, cage_plan());
        check_sums(system.snapshot(0.0, pressed(system, ahead, {0.0, 1.8e-4, -1.4e-4})), false);
      }
  INFO("films");
  bearing::Bearing b = angular_contact(9, 0.07);
  b.cage_films = bearing::CageFilms{true, true, 0.02, 0.02, 1e-4, 1e-7};
  scene::ScenePlan plan = cage_plan();
  for (const scene::Effect film : {LandFilm, PocketFilm})
    plan.effects.push_back({film, "", true, "test"});
  System system = make_system(b, plan);
  check_sums(system.snapshot(0.0, pressed(system, ahead, {0.0, 1.0e-4, -0.8e-4})), true);
}

TEST_CASE("heat of pockets and of lands sums up to the ledger's, whatever rollers and their cage",
          "[physics][rollers][heat]") {
  enum class With : unsigned char { Nothing, Damping, Routines, Films };
  for (const bearing::Bearing& of_type :
       {roller_bearings::cylindrical(3000.0), roller_bearings::tapered(3000.0),
        roller_bearings::spherical(3000.0), roller_bearings::spherical_tapered(3000.0)})
    for (const With with : {With::Nothing, With::Damping, With::Routines, With::Films})
      for (const int pieces : {1, 3})
        for (const bool through : {false, true})
          for (const bool round : {false, true}) {
            if (pieces == 1 && through) continue;
            if (pieces > 1 && with == With::Films) continue;  // of a cage of one piece
            bearing::Bearing b = of_type;
            b.rollers()->count = 12;
            roller_scene::add_cage(b);
            roller_scene::add_friction(b);
            if (round) b.cage->pocket = bearing::PocketShape::Cylindrical;
            if (pieces > 1) cut(b, pieces, through);
            scene::ScenePlan plan = roller_scene::with_friction();
            if (with == With::Films) {
              b.cage_films = bearing::CageFilms{true, true, 0.02, 0.02, 1e-4, 1e-7};
              for (const scene::Effect film : {LandFilm, PocketFilm})
                plan.effects.push_back({film, "", true, "test"});
            }
            SystemOptions options;
            if (with == With::Damping) {
              plan.effects.push_back({ContactDamping, "", true, "test"});
              options.damping.impact_loss = 0.3;
            }
            if (with == With::Routines) options.user = std::make_shared<Stiffer>();
            INFO("type " << static_cast<int>(b.type) << ", with " << static_cast<int>(with) << ", "
                         << pieces << " pieces, through pockets " << through << ", round "
                         << round);
            roller_scene::Scene s = roller_scene::scene_of(b, plan, 9, 0.0, options);
            const double ahead =
                (with == With::Films ? 1.2e-4 : 1.28e-4) / (0.5 * b.pitch_diameter());
            const double aside = with == With::Films ? 0.8 : 1.0;
            std::vector<double> y =
                pressed(s.system, ahead, {0.0, 1.2e-4 * aside, -1.0e-4 * aside});
            if (with == With::Damping || with == With::Routines)  // towards the wall
              for (std::size_t i = 0; i < static_cast<std::size_t>(b.element_count()); ++i)
                y[first_of(s.system, "element.theta_dot") + i] += i % 2 == 0 ? 5.0 : -5.0;
            const Snapshot at = s.system.snapshot(0.0, y);
            check_sums(at, with == With::Films, with == With::Routines);
            // What damping takes along the normal is an item of its own, in no part; what a
            // routine does is in them.
            if (with == With::Damping) CHECK(at.energy.rate("pocket_damping") > 0.0);
            if (with == With::Routines) {
              // Friction grows as the forces do; what the walls take as rollers near them comes to
              // it.
              roller_scene::Scene plain = roller_scene::scene_of(b, plan, 9);
              const double friction = sums_of(plain.system.snapshot(0.0, y)).pockets;
              CHECK(sums_of(at).pockets > 1.0001 * Stiffer::kMore * friction);
            }
          }
}
