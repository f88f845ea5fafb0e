#include "base/constants.hpp"
#include "contact/ball_pocket.hpp"
#include "contact/cage_pieces.hpp"
#include "core/dynamics/roller_scene.hpp"
#include "core/dynamics/system_fixture.hpp"
#include "integrators/arrow_jacobian.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

/// Cages in several equal segments.
using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

using enum scene::Effect;

/// A cage in `pieces` segments, 1 degree cut out between them.
void cut(bearing::Bearing& b, int pieces, bool through_pockets, int first = 0) {
  b.cage->segments = {pieces, through_pockets, first, kPi / 180.0};
  b.cage->later_segment_starts.assign(static_cast<std::size_t>(pieces - 1), *b.cage);
  b.cage->inertia = contact::cage_inertia(b);
}

/// Thrust only: every ball alike, 9 balls of generous pockets in 3 segments.
bearing::Bearing axisymmetric(bool through_pockets, int first = 0) {
  bearing::Bearing b = angular_contact(9, 0.07);
  b.constraints.load = {1500.0, 0.0, 0.0, 0.0, 0.0};
  b.cage->speed_ratio = 0.98;
  cut(b, 3, through_pockets, first);
  return b;
}

scene::ScenePlan segment_plan(bool friction = true) {
  return friction
             ? plan_with({RaceContact, RaceTraction, PocketContact, PocketTraction, LandContact,
                          LandTraction, CageMotion, WearIntegrals, Effect::MomentumLedger})
             : plan_with(
                   {RaceContact, PocketContact, LandContact, CageMotion, Effect::MomentumLedger});
}

Mat3 about_x(double angle) { return passive_rotation_x(angle).transpose(); }

}  // namespace

TEST_CASE("pieces of a cage: every pocket once, halves at both ends of a cut", "[unit][cage]") {
  std::vector<double> azimuths;
  for (int i = 0; i < 12; ++i) azimuths.push_back(0.3 + 2.0 * kPi * i / 12.0);
  bearing::Cage cage;
  cage.segments = {3, false, 2, 0.02};
  const contact::CagePieces bars = contact::cage_pieces(cage, azimuths);
  CHECK(bars.half_angle == Approx(kPi / 3.0 - 0.01));
  CHECK(bars.last_halves.empty());
  for (std::size_t i = 0; i < 12; ++i) {
    const contact::SegmentPocket& pocket = bars.pockets[i];
    CHECK(pocket.element == i);
    CHECK(pocket.piece == static_cast<int>(((i + 10) % 12) / 4));
    CHECK(pocket.half == 0);
    // In the base frame it is where its element is.
    CHECK(std::remainder(
              bars.middle[static_cast<std::size_t>(pocket.piece)] + pocket.azimuth - azimuths[i],
              2.0 * kPi) == Approx(0.0).margin(1e-14));
  }
  cage.segments.through_pockets = true;
  const contact::CagePieces pockets = contact::cage_pieces(cage, azimuths);
  REQUIRE(pockets.last_halves.size() == 3);
  for (const contact::SegmentPocket& half : pockets.last_halves) {
    const contact::SegmentPocket& start = pockets.pockets[half.element];
    CHECK(half.half == 1);
    CHECK(start.half == -1);
    CHECK(start.piece == (half.piece + 1) % 3);
    CHECK(std::remainder(pockets.middle[static_cast<std::size_t>(half.piece)] + half.azimuth -
                             azimuths[half.element],
                         2.0 * kPi) == Approx(0.0).margin(1e-14));
  }
}

TEST_CASE("segments and what is cut out between them make the whole cage", "[unit][cage]") {
  bearing::Bearing b = angular_contact(9, 0.07);
  const bearing::Inertia whole = contact::cage_inertia(b);
  for (const bool through : {false, true}) {
    cut(b, 3, through);
    b.cage->segments.cut_angle = 0.0;
    const bearing::Inertia piece = contact::cage_inertia(b);
    CHECK(3.0 * piece.mass == Approx(whole.mass).epsilon(1e-12));
    const double arm = piece.geometric_centre.z();
    CHECK(arm < -0.02);  // from the mass center to the axis
    CHECK(3.0 * (piece.moments.x() + piece.mass * arm * arm) ==
          Approx(whole.moments.x()).epsilon(1e-9));
  }
}

TEST_CASE("half pockets push along the gradient of their gap", "[unit][cage][jacobian]") {
  using bearing::PocketShape;
  for (const PocketShape shape :
       {PocketShape::Cylindrical, PocketShape::Spherical, PocketShape::Elongated,
        PocketShape::Rectangular, PocketShape::Conical})
    for (const int half : {-1, 1}) {
      const contact::BallPocket pocket{shape, 0.0127, 3e-4, 5e-4, -2e-3, 2.5e-3, half, 3e-4};
      CHECK(contact::cut_opening_half_width(pocket) > 0.5 * 0.0127);
      int edges = 0;
      for (const double x : {-1.3e-4, 4e-5, 1.1e-4})
        for (const double y : {-9e-4, -2e-4, -3e-5, 6e-5, 2e-4, 8e-4})
          for (const double z : {-3e-4, 2e-5, 7e-4}) {
            const Vec3 q(x, y, z);
            const contact::WallPoints at = contact::nearest_walls(pocket, q, 1.0);
            for (std::size_t k = 0; k < static_cast<std::size_t>(at.count); ++k) {
              const contact::WallPoint& wall = at.surface[k];
              if (!std::isfinite(wall.gap)) continue;
              CHECK(half * wall.w[1] > pocket.cut - 1e-12);
              edges += std::abs(half * wall.w[1] - pocket.cut) < 1e-9 ? 1 : 0;
              CHECK(wall.m.norm() == Approx(1.0));
              constexpr double h = 1e-8;
              for (int axis = 0; axis < 3; ++axis) {
                const Vec3 step = h * Vec3::Unit(axis);
                const double slope =
                    (contact::nearest_walls(pocket, q + step, 1.0).surface[k].gap -
                     contact::nearest_walls(pocket, q - step, 1.0).surface[k].gap) /
                    (2.0 * h);
                INFO("shape " << static_cast<int>(shape) << " half " << half << " surface " << k
                              << " at " << q.transpose());
                CHECK(slope == Approx(-wall.m[axis]).margin(2e-5));
              }
            }
          }
      CHECK(edges > 5);
    }
}

TEST_CASE("equal segments under an axisymmetric load move equally", "[physics][cage]") {
  for (const bool through : {false, true}) {
    System system = make_system(axisymmetric(through), segment_plan());
    const double end = 1e-3;
    const RunResult result = fixture::run(system, system.initial_state(), end, 1e-8);
    const Snapshot at = system.snapshot(end, result.y);
    REQUIRE(at.cages.size() == 3);
    INFO("through pockets " << through << ", pocket heat " << at.energy.value("pocket_heat"));
    CHECK(at.energy.value("pocket_heat") > 1e-6);  // they met their balls
    CHECK((at.cages[0].omega - system.snapshot(0.0, system.initial_state()).cages[0].omega).norm() >
          0.1);
    for (std::size_t k = 1; k < 3; ++k) {
      const Mat3 turn = about_x(2.0 * kPi / 3.0 * static_cast<double>(k));
      CHECK((at.cages[k].position - turn * at.cages[0].position).norm() < 1e-11);
      CHECK((at.cages[k].omega - turn * at.cages[0].omega).norm() < 1e-6);
      CHECK((rotation_matrix(at.cages[k].orientation) -
             turn * rotation_matrix(at.cages[0].orientation))
                .norm() < 1e-9);
      CHECK(at.cages[k].to_next == Approx(at.cages[0].to_next).margin(1e-11));
      CHECK(at.cages[k].total_rotation == Approx(at.cages[0].total_rotation).margin(1e-9));
    }
  }
}

TEST_CASE("segments conserve energy and momentum through their collisions",
          "[physics][cage][energy]") {
  for (const bool through : {false, true})
    for (const bool friction : {false, true}) {
      bearing::Bearing b = axisymmetric(through);
      // Thrown outwards, inwards and along the axis: lands and pockets all meet.
      b.cage->start_offset = {2e-5, 0.0, 9e-5};
      b.cage->later_segment_starts[0].start_offset = {-3e-5, 8e-5, 2e-5};
      b.cage->later_segment_starts[1].start_angles = {0.0, 5e-4, -3e-4};
      b.cage->later_segment_starts[1].speed_ratio = 1.03;
      double previous = 1e300;
      for (const double tolerance : {1e-6, 1e-11}) {
        System system = make_system(b, segment_plan(friction));
        const double end = 2e-3;
        const RunResult result = fixture::run(system, system.initial_state(), end, tolerance);
        const Snapshot at = system.snapshot(end, result.y);
        // The largest of several times: one by itself may be small by chance.
        double residual = std::abs(at.energy.residual());
        for (const double earlier : {1.2e-3, 1.4e-3, 1.6e-3, 1.8e-3})
          residual = std::max(
              residual,
              std::abs(
                  system
                      .snapshot(earlier,
                                fixture::run(system, system.initial_state(), earlier, tolerance).y)
                      .energy.residual()));
        residual /= at.energy.sum(scene::LedgerKind::Start);
        double land = 0.0;
        for (const scene::CageSnapshot& segment : at.cages)
          for (const scene::LandSnapshot& one : segment.lands) land += one.force;
        INFO("through pockets " << through << ", friction " << friction << ", tolerance "
                                << tolerance << ": residual " << residual << ", land force now "
                                << land);
        if (friction) CHECK(at.energy.value("land_heat") > 1e-7);
        CHECK(residual < 0.5 * previous);
        if (tolerance < 1e-6) {
          CHECK(residual < 1e-6);
          CHECK(at.momentum->linear.residual().norm() < 1e-6 * at.momentum->linear_size);
          CHECK(at.momentum->angular.residual().norm() < 1e-6 * at.momentum->angular_size);
        }
        previous = residual;
      }
    }
}

TEST_CASE("renumbered segments move as before", "[physics][cage][symmetry]") {
  for (const bool through : {false, true}) {
    bearing::Bearing b = axisymmetric(through, 0);
    b.constraints.load[2] = 500.0;
    b.gravity = {0.0, 0.0, -9.81};
    b.cage->start_offset = {1e-5, 3e-5, -4e-5};
    b.cage->later_segment_starts[1].start_angles = {0.0, 4e-4, 0.0};
    bearing::Bearing renumbered = axisymmetric(through, 3);
    renumbered.constraints.load = b.constraints.load;
    renumbered.gravity = b.gravity;
    static_cast<bearing::CageStartState&>(*renumbered.cage) = b.cage->start_of(1);
    renumbered.cage->later_segment_starts = {b.cage->start_of(2), b.cage->start_of(0)};
    scene::ScenePlan plan = segment_plan();
    plan.effects.push_back({Gravity, "", true, "test"});
    System one = make_system(b, plan), two = make_system(renumbered, plan);
    const double end = 1e-3;
    const Snapshot first = one.snapshot(end, fixture::run(one, one.initial_state(), end, 1e-9).y);
    const Snapshot second = two.snapshot(end, fixture::run(two, two.initial_state(), end, 1e-9).y);
    for (std::size_t k = 0; k < 3; ++k) {
      const scene::CageSnapshot &p = first.cages[(k + 1) % 3], &q = second.cages[k];
      CHECK((p.position - q.position).norm() < 1e-10);
      CHECK((p.omega - q.omega).norm() < 1e-5);
      CHECK(p.to_next == Approx(q.to_next).margin(1e-10));
    }
    for (std::size_t i = 0; i < 9; ++i)
      CHECK(second.elements[i].race[1].load ==
            Approx(first.elements[i].race[1].load).epsilon(1e-6));
  }
}

TEST_CASE("segments turned with load and gravity give turned results",
          "[physics][cage][symmetry]") {
  const double pitch = 2.0 * kPi / 9.0;
  bearing::Bearing b = axisymmetric(true);
  b.constraints.load[2] = 500.0;
  b.gravity = {0.1, -2.0, -9.0};
  b.cage->start_offset = {1e-5, 3e-5, -4e-5};
  bearing::Bearing turned = axisymmetric(true, 1);
  const Mat3 turn = about_x(pitch);
  const Vec3 load = turn * Vec3(1500.0, 0.0, 500.0);
  turned.constraints.load = {load[0], load[1], load[2], 0.0, 0.0};
  turned.gravity = turn * b.gravity;
  turned.cage->start_offset = turn * b.cage->start_offset;
  scene::ScenePlan plan = segment_plan();
  plan.effects.push_back({Gravity, "", true, "test"});
  System one = make_system(b, plan), two = make_system(turned, plan);
  const double end = 5e-4;
  const Snapshot s1 = one.snapshot(end, fixture::run(one, one.initial_state(), end, 1e-9).y);
  const Snapshot s2 = two.snapshot(end, fixture::run(two, two.initial_state(), end, 1e-9).y);
  for (std::size_t k = 0; k < 3; ++k) {
    // As of a cage in one piece (test_system_runs.cpp).
    CHECK((s2.cages[k].position - turn * s1.cages[k].position).norm() < 1e-8);
    CHECK((s2.cages[k].omega - turn * s1.cages[k].omega).norm() < 1e-3);
  }
  for (std::size_t i = 0; i < 9; ++i)
    CHECK(s2.elements[(i + 1) % 9].r == Approx(s1.elements[i].r).margin(1e-10));
}

TEST_CASE("segments mirrored about X with load and speed give mirrored results",
          "[physics][cage][symmetry]") {
  const auto mirror = [](const Vec3& v) { return Vec3(v[0], -v[1], v[2]); };
  for (const bool through : {false, true}) {
    // Balls 0 to 2, 3 to 5, 6 to 8 become 0, 8, 7 and so on: the piece cut just before ball 7 (of
    // cut pockets: through ball 6, whose halves change sides).
    bearing::Bearing b = axisymmetric(through, 0);
    bearing::Bearing mirrored = axisymmetric(through, through ? 6 : 7);
    b.constraints.load[1] = 200.0;
    b.constraints.load[2] = 500.0;
    b.gravity = {0.1, -2.0, -9.0};
    b.cage->start_offset = {1e-5, 3e-5, -4e-5};
    b.cage->later_segment_starts[0].start_angles = {2e-4, 4e-4, -1e-4};
    mirrored.constraints.load = {b.constraints.load[0], -200.0, 500.0, 0.0, 0.0};
    mirrored.gravity = mirror(b.gravity);
    mirrored.speed = {-b.speed[0], -b.speed[1]};
    // Piece k of the one is piece (3 - k) % 3 of the other.
    for (std::size_t k = 0; k < 3; ++k) {
      const bearing::CageStartState& from = b.cage->start_of(k);
      const std::size_t to = (3 - k) % 3;
      bearing::CageStartState& start = to == 0
                                           ? static_cast<bearing::CageStartState&>(*mirrored.cage)
                                           : mirrored.cage->later_segment_starts[to - 1];
      start = from;
      start.start_offset = mirror(from.start_offset);
      start.start_angles = {-from.start_angles[0], from.start_angles[1], -from.start_angles[2]};
    }
    scene::ScenePlan plan = segment_plan();
    plan.effects.push_back({Gravity, "", true, "test"});
    System one = make_system(b, plan), two = make_system(mirrored, plan);
    // Azimuths of 40 and of 320 degrees have other errors: 1e-8 m and 1e-3 rad/s at the tolerance
    // 1e-9, a tenth of it at 1e-11.
    const double end = 5e-4;
    const Snapshot p = one.snapshot(end, fixture::run(one, one.initial_state(), end, 1e-11).y);
    const Snapshot q = two.snapshot(end, fixture::run(two, two.initial_state(), end, 1e-11).y);
    INFO("through pockets " << through);
    for (std::size_t k = 0; k < 3; ++k) {
      const scene::CageSnapshot &have = q.cages[(3 - k) % 3], &want = p.cages[k];
      CHECK((have.position - mirror(want.position)).norm() < 1e-8);
      // An axial vector: what the mirror leaves is its negative.
      CHECK((have.omega + mirror(want.omega)).norm() < 2e-3);
    }
    for (std::size_t i = 0; i < 9; ++i)
      CHECK(q.elements[(9 - i) % 9].race[1].load ==
            Approx(p.elements[i].race[1].load).epsilon(1e-4));
  }
}

TEST_CASE("rollers in segmented cages keep energy and momentum", "[physics][cage][rollers]") {
  for (bearing::Bearing b :
       {roller_bearings::cylindrical(3000.0), roller_bearings::tapered(3000.0)})
    for (const bool through : {false, true}) {
      b.rollers()->count -= b.rollers()->count % 2;
      roller_scene::add_cage(b);
      roller_scene::add_friction(b);
      b.cage->segments = {2, through, 0, kPi / 180.0};
      b.cage->later_segment_starts.assign(1, *b.cage);
      // A conical cage is cut by a formula of one piece only: take a share of it.
      b.cage->inertia.mass *= 0.45;
      b.cage->inertia.moments *= 0.4;
      b.cage->inertia.geometric_centre = {0.0, 0.0, -0.3 * b.pitch_diameter()};
      b.cage->later_segment_starts[0].start_offset = {0.0, 6e-5, 2e-5};
      roller_scene::Scene s = roller_scene::scene_of(b, roller_scene::with_friction(), 9);
      const double end = 1e-3;
      const RunResult result = fixture::run(s.system, s.system.initial_state(), end, 1e-9);
      const Snapshot at = s.system.snapshot(end, result.y);
      INFO("type " << static_cast<int>(b.type) << ", through pockets " << through);
      REQUIRE(at.cages.size() == 2);
      double elastic = 0.0;
      for (const auto& item : at.energy.items())
        if (item.term->id == "elastic") elastic = item.value;
      CHECK(at.energy.value("pocket_heat") > 0.0);
      CHECK(std::abs(at.energy.residual()) < 1e-5 * elastic);
      CHECK(at.momentum->linear.residual().norm() < 1e-5 * at.momentum->linear_size);
      CHECK(at.momentum->angular.residual().norm() < 1e-5 * at.momentum->angular_size);
    }
}

TEST_CASE("each segment stands in the border with the shares of its own elements",
          "[physics][cage][implicit]") {
  bearing::Bearing b = axisymmetric(true);
  b.cage->pocket_clearance_1 = b.cage->pocket_clearance_2 = 1e-4;
  System system = make_system(b, segment_plan());
  std::vector<double> y = system.initial_state();
  for (int k = 0; k < system.layout().controlled_size(); ++k)
    y[static_cast<std::size_t>(k)] +=
        3e-6 * system.layout().scales()[static_cast<std::size_t>(k)] * std::sin(1.0 + 3.7 * k);
  const auto owner = system.coupling();
  CHECK(std::count(owner.begin(), owner.end(), -1) == 3 * 14);
  // Balls deep in both halves of their pockets.
  for (const auto& group : system.layout().groups())
    if (group.name == "element.theta")
      for (int i = 0; i < 9; ++i)
        y[static_cast<std::size_t>(group.slice.first + i)] += i % 2 == 0 ? 2.5e-3 : -2.5e-3;
  std::vector<double> f(y.size()), plain(y.size()), shares(9 * 42);
  REQUIRE(system.rhs(0.0, y.data(), plain.data()) == RhsStatus::Ok);
  REQUIRE(system.rhs_with_contributions(0.0, y.data(), f.data(), shares.data()) == RhsStatus::Ok);
  CHECK(f == plain);
  const int border = static_cast<int>(std::find(owner.begin(), owner.end(), -1) - owner.begin());
  int loaded = 0;
  for (const auto& group : system.layout().groups())
    if (group.name.starts_with("cage") && group.name.ends_with(".velocity"))
      for (int k = group.slice.first; k < group.slice.first + 3; ++k) {
        double sum = 0.0;
        for (int i = 0; i < 9; ++i) sum += shares[static_cast<std::size_t>(i * 42 + k - border)];
        const double all = f[static_cast<std::size_t>(k)];
        loaded += std::abs(all) > 1.0 ? 1 : 0;
        CHECK(sum == Approx(all).epsilon(1e-9).margin(1e-6));
      }
  CHECK(loaded > 5);
}
