#include "base/constants.hpp"
#include "contact/cage_inertia.hpp"
#include "core/dynamics/roller_scene.hpp"
#include "core/dynamics/system_fixture.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

/// Cages whose guide lands, or the race lands they run on, are out of round.
using namespace adore;
using namespace adore::fixture;
using bearing::LandErrors;
using bearing::RaceErrors;
using scene::Snapshot;

namespace {

using enum scene::Effect;

LandErrors wave(double amplitude, double waves, double phase = 0.3) {
  return {RaceErrors::Roundness::Sinusoidal, {amplitude, waves, phase}};
}
LandErrors ellipse(double y, double z) { return {RaceErrors::Roundness::Elliptical, {y, z, 0.0}}; }

/// Cage errors on land 1, race errors on both lands; guided as asked.
bearing::Bearing uneven(bool inner, double size = 1.0) {
  bearing::Bearing b = angular_contact(9, 0.07);
  b.constraints.load = {1500.0, 0.0, 0.0, 0.0, 0.0};
  bearing::Cage& cage = *b.cage;
  if (inner)
    for (bearing::GuideLand& land : cage.lands) {
      land.guide = bearing::GuideLand::Guide::Inner;
      land.diameter = cage.inner_diameter;
    }
  for (bearing::GuideLand& land : cage.lands) land.clearance = 2e-4;
  cage.lands[0].of_cage = wave(size * 3e-5, 4);
  cage.lands[0].of_race = ellipse(size * 2e-5, -size * 2e-5);
  cage.lands[1].of_race = wave(size * 2e-5, 3, 1.0);
  cage.start_offset = {0.0, 4e-5, -3e-5};
  cage.speed_ratio = 1.02;
  return b;
}

void cut(bearing::Bearing& b, int pieces) {
  b.cage->segments = {pieces, false, 0, kPi / 180.0};
  b.cage->later_segment_starts.assign(static_cast<std::size_t>(pieces - 1), *b.cage);
  b.cage->inertia = contact::cage_inertia(b);
}

scene::ScenePlan plan(bool friction) {
  return friction
             ? plan_with({RaceContact, RaceTraction, PocketContact, PocketTraction, LandContact,
                          LandTraction, CageMotion, scene::Effect::MomentumLedger})
             : plan_with({RaceContact, PocketContact, LandContact, CageMotion,
                          scene::Effect::MomentumLedger});
}

}  // namespace

TEST_CASE("uneven guide lands keep energy and momentum, whole cages and segments",
          "[physics][cage][land][energy]") {
  for (const bool inner : {false, true})
    for (const int pieces : {1, 3})
      for (const bool friction : {false, true}) {
        // Nothing but the pockets holds segments that an inner race should guide.
        if (inner && pieces > 1) continue;
        bearing::Bearing b = uneven(inner);
        // Thrown at its lands.
        b.cage->whirl_ratio = 20.0;
        if (pieces > 1) {
          cut(b, pieces);
          b.cage->later_segment_starts[0].start_offset = {-3e-5, 8e-5, 2e-5};
          b.cage->later_segment_starts[1].start_angles = {0.0, 5e-4, -3e-4};
        }
        double previous = 1e300;
        for (const double tolerance : {1e-6, 1e-9}) {
          dynamics::System system = make_system(b, plan(friction));
          const double end = 2e-3;
          const RunResult result = run(system, system.initial_state(), end, tolerance);
          const Snapshot at = system.snapshot(end, result.y);
          const double residual =
              std::abs(at.energy.residual()) / at.energy.sum(scene::LedgerKind::Start);
          INFO("inner " << inner << ", pieces " << pieces << ", friction " << friction
                        << ", tolerance " << tolerance << ": residual " << residual);
          if (friction) CHECK(at.energy.value("land_heat") > 1e-6);
          CHECK(residual < std::max(0.5 * previous, 1e-7));
          if (tolerance == 1e-9) {
            CHECK(residual < 1e-6);
            CHECK(at.momentum->linear.residual().norm() < 1e-6 * at.momentum->linear_size);
            CHECK(at.momentum->angular.residual().norm() < 1e-6 * at.momentum->angular_size);
          }
          previous = residual;
        }
      }
}

TEST_CASE("lands of vanishing errors move the cage as round ones do", "[physics][cage][land]") {
  bearing::Bearing round = uneven(false, 0.0);
  REQUIRE(round.cage->lands[0].ideal());
  round.cage->whirl_ratio = 20.0;
  bearing::Bearing nearly = uneven(false, 1e-9);
  nearly.cage->whirl_ratio = 20.0;
  REQUIRE(!nearly.cage->lands[0].ideal());
  bearing::Bearing wild = uneven(false, 1.0);
  wild.cage->whirl_ratio = 20.0;
  const double end = 1e-3;
  for (const bool friction : {false, true}) {
    const auto moved = [&](const bearing::Bearing& b) {
      dynamics::System system = make_system(b, plan(friction));
      return system.snapshot(end, run(system, system.initial_state(), end, 1e-10).y);
    };
    const Snapshot one = moved(round), two = moved(nearly), three = moved(wild);
    CHECK((one.cages[0].position - three.cages[0].position).norm() > 1e-6);
    // Friction of round lands is that of the resultant, of others that of the pressure along a
    // spot, some per cent more where the spot is wide.
    if (!friction) {
      CHECK((one.cages[0].position - two.cages[0].position).norm() < 2e-9);
    } else {
      REQUIRE(one.energy.value("land_heat") > 1e-3);
      CHECK(two.energy.value("land_heat") > one.energy.value("land_heat"));
      CHECK(two.energy.value("land_heat") == Approx(one.energy.value("land_heat")).epsilon(0.03));
    }
  }
}

TEST_CASE("a cage with an oval land in an oval race land turns into the wide side",
          "[physics][cage][land]") {
  // Half axes 20 µm longer along z on both: at a quarter turn the least play is 60 µm, aligned 100.
  bearing::Bearing b = angular_contact(9, 0.07);
  b.cage->lands[0].of_cage = b.cage->lands[1].of_cage = ellipse(-2e-5, 2e-5);
  b.cage->lands[0].of_race = b.cage->lands[1].of_race = ellipse(-2e-5, 2e-5);
  b.cage->lands[0].clearance = b.cage->lands[1].clearance = 2e-4;
  for (const double turn : {0.0, 0.5 * kPi}) {
    b.cage->start_angles = {turn, 0.0, 0.0};
    dynamics::System system = make_system(b, plan_with({RaceContact, LandContact, CageMotion}));
    const Snapshot at = system.snapshot(0.0, system.initial_state());
    CHECK(at.cages[0].lands[0].gap == Approx(1e-4 - (turn > 0.0 ? 4e-5 : 0.0)).margin(1e-8));
    CHECK(at.cages[0].lands[0].force == 0.0);
  }
  // Squeezed by 20 µm at a quarter turn: pushed back towards where they fit.
  b.cage->lands[0].clearance = b.cage->lands[1].clearance = 4e-5;
  b.cage->start_angles = {0.5 * kPi - 0.1, 0.0, 0.0};
  b.cage->speed_ratio = 0.0;
  b.speed = {0.0, 1e-9};
  dynamics::System system = make_system(b, plan_with({RaceContact, LandContact, CageMotion}));
  const Snapshot at = system.snapshot(0.0, system.initial_state());
  REQUIRE(at.cages[0].lands[0].gap < -1e-5);
  const RunResult result = run(system, system.initial_state(), 1e-5, 1e-8);
  CHECK(system.snapshot(1e-5, result.y).cages[0].omega.x() < -1e-3);
}

TEST_CASE("out-of-round lands turned with everything give turned results",
          "[physics][cage][land][symmetry]") {
  // Both races and the cage carry their marks along: only the base frame turns.
  const double pitch = 2.0 * kPi / 9.0;
  bearing::Bearing b = uneven(false);
  b.cage->whirl_ratio = 20.0;
  b.cage->lands[0].of_cage = b.cage->lands[1].of_cage = wave(2e-5, 9, 0.2);
  b.cage->lands[0].of_race = b.cage->lands[1].of_race = wave(2e-5, 9, 1.1);
  bearing::Bearing turned = b;  // nine waves: a pitch turns them into themselves
  turned.cage->start_offset = passive_rotation_x(pitch).transpose() * b.cage->start_offset;
  const double end = 1e-3;
  dynamics::System one = make_system(b, plan(true)), two = make_system(turned, plan(true));
  const Snapshot p = one.snapshot(end, run(one, one.initial_state(), end, 1e-10).y);
  const Snapshot q = two.snapshot(end, run(two, two.initial_state(), end, 1e-10).y);
  REQUIRE(p.energy.value("land_heat") > 1e-6);
  CHECK((passive_rotation_x(pitch).transpose() * p.cages[0].position - q.cages[0].position).norm() <
        2e-8);  // of 0.1 mm
}
