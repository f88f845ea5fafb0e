#include "base/constants.hpp"
#include "base/errors.hpp"
#include "contact/ball_pocket.hpp"
#include "contact/cage_inertia.hpp"
#include "contact/conformal.hpp"
#include "contact/guide_land.hpp"
#include "contact/roller_pocket_play.hpp"

#include <catch2/catch.hpp>

#include <random>

using namespace adore;
using namespace adore::contact;
using bearing::PocketShape;

namespace {

constexpr double kBall = 0.0079375;

BallPocket pocket_of(PocketShape shape) {
  return {shape, kBall, 0.0002, shape == PocketShape::Conical ? 0.0005 : 0.0003, -0.0013, 0.0015};
}

/// Distance to a wall given by its points (azimuth-like u, height v), by nested grid search.
template <class Wall>
double brute_distance(const Wall& wall, const Vec3& q, double low, double high) {
  double u = 0, v = 0, best = 1e9, du = 2 * kPi / 400, dv = (high - low) / 80;
  for (int i = 0; i < 400; ++i)
    for (int j = 0; j <= 80; ++j)
      if (const double d = (wall(i * du, low + j * dv) - q).norm(); d < best)
        best = d, u = i * du, v = low + j * dv;
  for (int level = 0; level < 40; ++level) {
    const double u0 = u, v0 = v;
    for (int i = -4; i <= 4; ++i)
      for (int j = -4; j <= 4; ++j) {
        const double uu = u0 + 0.25 * i * du, vv = std::clamp(v0 + 0.25 * j * dv, low, high);
        if (const double d = (wall(uu, vv) - q).norm(); d < best) best = d, u = uu, v = vv;
      }
    du *= 0.5;
    dv *= 0.5;
  }
  return best;
}

}  // namespace

TEST_CASE("The gap of a ball in a round pocket is the distance to its nearest wall point",
          "[physics][pocket]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> across(-1.5e-4, 1.5e-4), height(-2.2e-3, 2.4e-3);
  for (const PocketShape shape : {PocketShape::Cylindrical, PocketShape::Spherical,
                                  PocketShape::Elongated, PocketShape::Conical}) {
    const BallPocket pocket = pocket_of(shape);
    const double rho = 0.5 * (kBall + pocket.clearance_1), r2 = 0.5 * (kBall + pocket.clearance_2);
    const auto wall = [&](double u, double z) -> Vec3 {
      double r = rho, y = 0.0;
      if (shape == PocketShape::Spherical) r = std::sqrt(rho * rho - z * z);
      if (shape == PocketShape::Conical)
        r = rho + (r2 - rho) * (z - pocket.z_low) / (pocket.z_high - pocket.z_low);
      if (shape == PocketShape::Elongated) {
        // Stadium traced by its tangent angle; the straight sides are covered by the query's own y.
        y = std::sin(u) > 0 ? 0.5 * pocket.clearance_2 : -0.5 * pocket.clearance_2;
      }
      return {r * std::cos(u), r * std::sin(u) + y, z};
    };
    for (int trial = 0; trial < 12; ++trial) {
      Vec3 q(across(random), across(random), height(random));
      if (shape == PocketShape::Elongated)
        q[1] += q[1] > 0 ? 2e-4 : -2e-4;  // beside the arcs, not the flats
      const WallPoints walls = nearest_walls(pocket, q, 1.0);
      REQUIRE(walls.count == 1);
      // 1e-12 m: the search stops at a grid of 1e-14 rad and 1e-15 m
      CHECK(
          walls.surface[0].gap ==
          Approx(brute_distance(wall, q, pocket.z_low, pocket.z_high) - 0.5 * kBall).margin(1e-12));
      CHECK((walls.surface[0].w - q).norm() - 0.5 * kBall ==
            Approx(walls.surface[0].gap).margin(1e-15));
      CHECK(walls.surface[0].m.norm() == Approx(1.0).margin(1e-12));
    }
  }
}

TEST_CASE("The flat sides of an elongated pocket and the faces of a rectangular one are planes",
          "[physics][pocket]") {
  const WallPoint flat =
      nearest_walls(pocket_of(PocketShape::Elongated), {4e-5, 3e-5, 0.0}, 1.0).surface[0];
  CHECK(flat.gap == Approx(1e-4 - 4e-5).margin(1e-15));
  CHECK(flat.m[1] == 0.0);
  const WallPoints faces =
      nearest_walls(pocket_of(PocketShape::Rectangular), {2e-5, 5e-5, 0.0}, -1.0);
  REQUIRE(faces.count == 4);
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(pocket_theta(faces.surface[i].m, -1.0) ==
          Approx(0.5 * kPi * static_cast<double>(i)).margin(1e-9));
  CHECK(faces.surface[0].gap ==
        Approx(1e-4 + 5e-5).margin(1e-15));  // the driving face is at -y for σ = -1
  CHECK(faces.surface[1].gap == Approx(1.5e-4 - 2e-5).margin(1e-15));
}

TEST_CASE("The pocket force is minus the gradient of its potential, also across the rim",
          "[physics][pocket]") {
  const CylindricalPocket pocket{0.5 * (kBall + 2e-4), -1e-3, 1e-3};
  const CappedHertz law = ball_pocket_law(7.6e10, kBall, {-1 / pocket.wall_radius, 0.0}).law;
  const auto potential = [&](const Vec3& q) {
    return energy(law, -nearest_wall(pocket, q, 0.5 * kBall).gap);
  };
  for (const double z : {0.0, 0.99e-3, 1.0e-3, 1.01e-3, 1.1e-3}) {
    const Vec3 q(9e-5, -6e-5, z);
    const WallPoint wall = nearest_wall(pocket, q, 0.5 * kBall);
    REQUIRE(wall.gap < 0.0);
    const Vec3 force = -load(law, -wall.gap) * wall.m;
    for (int i = 0; i < 3; ++i) {
      const double h = 1e-9;
      Vec3 step = Vec3::Zero();
      step[i] = h;
      // central differences of a C1 energy: 1e-4 of the force at the rim, where the second
      // derivative jumps
      CHECK(-(potential(q + step) - potential(q - step)) / (2 * h) ==
            Approx(force[i]).margin(1e-4 * force.norm()));
    }
  }
}

TEST_CASE("On the pocket's axis the normal fades out and the gap stays right", "[unit][pocket]") {
  const CylindricalPocket pocket{0.5 * (kBall + 2e-4), -1e-3, 1e-3};
  const WallPoint wall = nearest_wall(pocket, Vec3::Zero(), 0.5 * kBall);
  CHECK(wall.gap == Approx(1e-4).epsilon(1e-12));
  CHECK(wall.m.norm() == 0.0);
}

TEST_CASE("A half pocket ends at the cut", "[unit][pocket]") {
  const CylindricalPocket pocket{0.5 * (kBall + 2e-4), -1e-3, 1e-3};
  const Vec3 q(1e-5, 8e-5, 0.0);
  const WallPoint there = nearest_half_pocket_wall(pocket, q, 0.5 * kBall, 1, 4e-4);
  CHECK(there.gap == nearest_wall(pocket, q, 0.5 * kBall).gap);
  const WallPoint other = nearest_half_pocket_wall(pocket, q, 0.5 * kBall, -1, 4e-4);
  CHECK(other.w[1] == Approx(-4e-4));
  CHECK(std::hypot(other.w[0], other.w[1]) == Approx(pocket.wall_radius));
  CHECK(other.gap > there.gap);
}

TEST_CASE("Capped Hertz is C1, convex, and its load is the derivative of its energy",
          "[physics][pocket]") {
  const PocketLaw pocket = ball_pocket_law(7.634619e10, kBall, {-1 / (0.5 * (kBall + 2e-4)), 0.0});
  const CappedHertz& law = pocket.law;
  const double d = law.delta_cap;
  CHECK(load(law, -1e-6) == 0.0);
  CHECK(load(law, d * (1 + 1e-12)) == Approx(load(law, d)).epsilon(1e-10));
  CHECK(slope(law, d * (1 + 1e-12)) == Approx(slope(law, d)).epsilon(1e-10));
  CHECK(energy(law, d * (1 + 1e-12)) == Approx(energy(law, d)).epsilon(1e-10));
  // At the cap the major half axis is half the ball radius.
  CHECK(pocket.hertz.a_hat * std::cbrt(law.load_cap) == Approx(0.25 * kBall).epsilon(1e-12));
  for (const double x : {0.2 * d, 0.7 * d, 1.5 * d, 4 * d}) {
    const double h = 1e-4 * d;
    CHECK((energy(law, x + h) - energy(law, x - h)) / (2 * h) ==
          Approx(load(law, x)).epsilon(1e-7));  // h² term
    CHECK((load(law, x + h) - load(law, x - h)) / (2 * h) == Approx(slope(law, x)).epsilon(1e-7));
  }
}

TEST_CASE("A spherical pocket of vanishing clearance tends to the linear law 2 E* χ r_b",
          "[physics][pocket]") {
  const double E = 7.6e10;
  const double curvature = -2 / kBall * (1 - 1e-5);
  const CappedHertz law = ball_pocket_law(E, kBall, {curvature, curvature}).law;
  CHECK(law.slope_cap ==
        Approx(2 * E * 0.25 * kBall).epsilon(1e-9));  // punch of radius χ r_b, exact for a sphere
  const CappedHertz fitted =
      capped_hertz(std::numeric_limits<double>::infinity(), 1.0, 0.5 * kBall, E);
  CHECK(fitted.slope_cap == Approx(law.slope_cap).epsilon(1e-9));
  CHECK(load(fitted, 1e-6) == Approx(fitted.slope_cap * 1e-6));
  CHECK_THROWS_AS(ball_pocket_law(E, 0.0, {0.0, 0.0}), InputError);
  CHECK_THROWS_AS(ball_pocket_law(-E, kBall, {0.0, 0.0}), InputError);
}

TEST_CASE("The land law has its potential, its limits, and no jump", "[physics][land]") {
  const LandLaw law{7.6e10, 2e-4};
  CHECK(land_load_per_length(law, 1.9e-4) == 0.0);
  CHECK(land_energy_per_length(law, 2e-4) == 0.0);
  for (const double beyond : {1e-9, 1e-7, 1e-6, 1.5e-5, 1e-4, 1e-3}) {
    const double e = law.clearance + beyond, h = 1e-3 * beyond;
    // central differences with h = beyond/1000: relative error about 1e-6 of the 3/2 power
    CHECK((land_energy_per_length(law, e + h) - land_energy_per_length(law, e - h)) / (2 * h) ==
          Approx(land_load_per_length(law, e)).epsilon(2e-6));
    CHECK((land_load_per_length(law, e + h) - land_load_per_length(law, e - h)) / (2 * h) ==
          Approx(land_stiffness_per_length(law, e)).epsilon(2e-6));
  }
  // Small loads: F/L = (π/2) E* δ √(δ/(2(ΔR+δ))).
  const double d = 1e-9;
  CHECK(
      land_load_per_length(law, law.clearance + d) ==
      Approx(0.5 * kPi * law.E_star * d * std::sqrt(d / (2 * (law.clearance + d)))).epsilon(1e-4));
  CHECK(land_stiffness_per_length(law, 1.0) < 3 * kPi * kPi / 32 * law.E_star);
  // Interference: contact all around has the stiffness k_w R π.
  const LandLaw tight{7.6e10, -1e-5};
  CHECK(land_load_per_length(tight, 5e-6) == Approx(3 * kPi * kPi / 16 * tight.E_star * 5e-6));
  CHECK(land_load_per_length(tight, 0.0) == 0.0);
  for (const double e : {4e-6, 1.2e-5, 3e-5}) {
    const double h = 1e-9;
    CHECK((land_energy_per_length(tight, e + h) - land_energy_per_length(tight, e - h)) / (2 * h) ==
          Approx(land_load_per_length(tight, e)).epsilon(1e-5));
  }
}

namespace {

LandPair wavy_land() {
  LandPair land;
  land.outer = false;
  land.cage = {LandProfile::Kind::Ellipse, 0.01855, -2.6e-4, 1.8e-4, 0.0};
  land.race = {LandProfile::Kind::Wave, 0.01835, 2e-5, 3.0, 0.26};
  land.centre_x = -0.0069;
  land.width = 0.0032;
  land.slices = 2;
  return land;
}

}  // namespace

TEST_CASE("The land integral is the closed form where the land is circular and aligned",
          "[physics][land]") {
  LandPair land;
  land.cage.radius = 0.0245;
  land.race.radius = 0.0247;
  land.centre_x = 0.0069;
  land.width = 0.0032;
  land.slices = 3;
  const Vec3 g(0.0, 1.3e-4, -1.7e-4);
  const double e = g.norm();
  const LandLaw law{7.6e10, land.race.radius - land.cage.radius};
  const LandLoad sum = land_load(land, law.E_star, g, Mat3::Identity());
  // The exact gap differs from c - e cos ψ by e²/2R ~ 1e-6 m of 1.4e-5 m at the ends of the arc: a
  // few per cent.
  CHECK(sum.force.norm() == Approx(land.width * land_load_per_length(law, e)).epsilon(0.03));
  CHECK(sum.force.dot(g) < 0.0);
  CHECK(sum.energy == Approx(land.width * land_energy_per_length(law, e)).epsilon(0.03));
  CHECK(sum.moment[0] == Approx(0.0).margin(1e-12 * sum.force.norm()));
  CHECK(min_land_gap(land, 0.0, g, Mat3::Identity()).gap ==
        Approx(law.clearance - e).margin(1e-15));
}

TEST_CASE("Land force and moment are minus the gradient of the land's potential",
          "[physics][land]") {
  const LandPair land = wavy_land();
  const double E = 7.6e10;
  const Vec3 g(0.0, 6e-5, 1e-4), tilt(0.5, 4e-4, -3e-4);
  const auto potential = [&](const Vec3& centre, const Mat3& T) {
    return land_load(land, E, centre, T).energy;
  };
  const Mat3 T = passive_matrix(tilt);
  const LandLoad sum = land_load(land, E, g, T);
  REQUIRE(sum.energy > 0.0);
  for (int i = 0; i < 3; ++i) {
    Vec3 step = Vec3::Zero();
    step[i] = 1e-8;
    CHECK(-(potential(g + step, T) - potential(g - step, T)) / 2e-8 ==
          Approx(sum.force[i]).margin(1e-4 * sum.force.norm()));
    Vec3 axis = Vec3::Zero();
    axis[i] = 1.0;
    const double angle = 1e-6;  // turns the cage about a race axis through its center
    const Mat3 plus = T * rotation_matrix(quaternion_about(axis, -angle)),
               minus = T * rotation_matrix(quaternion_about(axis, angle));
    CHECK(-(potential(g, plus) - potential(g, minus)) / (2 * angle) ==
          Approx(sum.moment[i]).margin(1e-4 * sum.moment.norm()));
  }
}

namespace {

CageSolid cage_solid(PocketShape shape) {
  CageSolid solid;
  solid.pocket = shape;
  solid.outer_diameter = 0.0488;
  solid.inner_diameter = 0.0434;
  solid.width = 0.0115;
  solid.pockets = 12;
  solid.element_diameter = kBall;
  solid.pitch_diameter = 0.046;
  solid.clearance_1 = 2e-4;
  solid.clearance_2 = shape == PocketShape::Elongated ? 4e-4 : 3e-4;
  solid.density = 7850.0;
  return solid;
}

}  // namespace

TEST_CASE("Cage inertia agrees between its two ways of integrating a pocket", "[physics][cage]") {
  for (const PocketShape shape :
       {PocketShape::Cylindrical, PocketShape::Elongated, PocketShape::Rectangular}) {
    CageSolid solid = cage_solid(shape);
    const SolidInertia polar = cage_solid_inertia(solid);
    solid.cone_angle = 1e-13;  // integrates along the pocket's normal instead
    const SolidInertia normal = cage_solid_inertia(solid);
    CHECK(normal.volume == Approx(polar.volume).epsilon(1e-10));
    CHECK((normal.inertia - polar.inertia).norm() < 1e-10 * polar.inertia.norm());
    CHECK(polar.inertia(1, 1) == Approx(polar.inertia(2, 2)).epsilon(1e-12));
    CHECK(std::abs(polar.inertia(1, 2)) < 1e-14 * polar.inertia(1, 1));
  }
}

TEST_CASE("Segments without a gap between them add up to the whole cage", "[physics][cage]") {
  for (const bool at_pocket : {false, true}) {
    CageSolid solid = cage_solid(PocketShape::Cylindrical);
    const SolidInertia whole = cage_solid_inertia(solid);
    solid.segments = 4;
    solid.cut_at_pocket = at_pocket;
    const SolidInertia part = cage_solid_inertia(solid);
    CHECK(4 * part.volume == Approx(whole.volume).epsilon(1e-12));
    const double off_axis = part.mass * part.mass_centre.squaredNorm();
    CHECK(4 * (part.inertia(0, 0) + off_axis) == Approx(whole.inertia(0, 0)).epsilon(1e-12));
  }
}

TEST_CASE("A roller-guided cage loses cylinders about its rollers", "[physics][cage]") {
  // The cylinder lies wholly inside the wall: its volume is π ρ² L, whatever way it is integrated.
  CageSolid solid = cage_solid(PocketShape::Cylindrical);
  solid.outer_diameter = 0.062;
  solid.inner_diameter = 0.034;
  solid.width = 0.014;
  solid.pitch_diameter = 0.048;
  const double whole =
      0.25 * 3.14159265358979323846 * solid.width *
      (solid.outer_diameter * solid.outer_diameter - solid.inner_diameter * solid.inner_diameter);
  solid.roller_length = 0.010;
  const double rho = 0.5 * (kBall + solid.clearance_1);
  CHECK(whole - cage_solid_inertia(solid).volume ==
        Approx(12 * 3.14159265358979323846 * rho * rho * 0.010).epsilon(1e-6));
  // In a cone they lean with it, and still lie inside the wall; the shell keeps its volume.
  solid.cone_angle = 0.1;
  CHECK(whole - cage_solid_inertia(solid).volume ==
        Approx(12 * 3.14159265358979323846 * rho * rho * 0.010).epsilon(1e-6));
}

TEST_CASE("A cone that is hardly one loses the same as a cylinder, whole or in segments",
          "[physics][cage]") {
  for (const PocketShape shape :
       {PocketShape::Cylindrical, PocketShape::Spherical, PocketShape::Elongated,
        PocketShape::Rectangular, PocketShape::Conical})
    for (const int segments : {1, 3})
      for (const bool at_pocket : {false, true}) {
        CageSolid solid = cage_solid(shape);
        solid.segments = segments;
        solid.cut_angle = segments > 1 ? 0.01 : 0.0;
        solid.cut_at_pocket = at_pocket && segments > 1;
        const SolidInertia plain = cage_solid_inertia(solid);
        solid.cone_angle = 1e-9;
        const SolidInertia cone = cage_solid_inertia(solid);
        INFO("shape " << static_cast<int>(shape) << ", " << segments << " pieces, at pocket "
                      << at_pocket);
        CHECK(cone.volume == Approx(plain.volume).epsilon(2e-6));
        CHECK((cone.mass_centre - plain.mass_centre).norm() < 1e-7);
        CHECK((cone.inertia - plain.inertia).norm() < 5e-6 * plain.inertia.norm());
      }
}

TEST_CASE("Segments of a conical cage make the whole one", "[physics][cage]") {
  for (const bool at_pocket : {false, true}) {
    CageSolid solid = cage_solid(PocketShape::Rectangular);
    solid.cone_angle = 0.2;
    const SolidInertia whole = cage_solid_inertia(solid);
    solid.segments = 3;
    solid.cut_at_pocket = at_pocket;
    const SolidInertia part = cage_solid_inertia(solid);
    CHECK(3 * part.volume == Approx(whole.volume).epsilon(1e-6));
    CHECK(part.mass_centre.x() == Approx(whole.mass_centre.x()).epsilon(1e-5));
    const double off = part.mass_centre.z();
    CHECK(3 * (part.inertia(0, 0) + part.mass * off * off) ==
          Approx(whole.inertia(0, 0)).epsilon(1e-6));
  }
}

TEST_CASE("Play of a roller between guide faces", "[physics][cage]") {
  contact::RollerProfile roller;
  roller.diameter = 0.010;
  roller.length = 0.012;
  RollerPocketFace face;
  face.centre = {0.0, 0.00512, 0.0};
  face.width = 0.004;
  face.length = 0.008;
  CHECK(roller_pocket_play(std::array{face}, roller) == Approx(2.4e-4).epsilon(1e-9));
  // A second, tighter pair decides; faces leaning about x touch nearer by the cosine.
  RollerPocketFace leaning = face;
  leaning.angles = {0.2, 0.0, 0.0};
  leaning.centre = 0.00508 * Vec3(0.0, std::cos(0.2), std::sin(0.2));
  CHECK(roller_pocket_play(std::array{face, leaning}, roller) == Approx(1.6e-4).epsilon(1e-9));
  // What a deviation of the clearance adds is diametral, whatever way a face leans.
  CHECK(roller_pocket_play(contact::widened(std::array{face, leaning}, 3e-5), roller) ==
        Approx(1.9e-4).epsilon(1e-9));
  // A tapered roller is widest at its large end, towards -x, as far as the face reaches.
  roller.half_angle = 0.03;
  CHECK(roller_pocket_play(std::array{face}, roller) ==
        Approx(2.4e-4 - 2.0 * 0.004 * std::tan(0.03)).epsilon(1e-9));
  face.length = 0.1;
  CHECK(roller_pocket_play(std::array{face}, roller) ==
        Approx(2.4e-4 - 2.0 * 0.006 * std::tan(0.03)).epsilon(1e-9));
  face.length = 0.002;
  face.centre[0] = 0.02;
  CHECK_THROWS_WITH(roller_pocket_play(std::array{face}, roller), Catch::Contains("bPocGsLen2"));
}

TEST_CASE("A cage whose pockets cannot be cut is refused with the reason", "[unit][cage]") {
  CageSolid solid = cage_solid(PocketShape::Cylindrical);
  solid.pockets = 19;
  CHECK_THROWS_WITH(cage_solid_inertia(solid), Catch::Contains("overlap"));
  solid = cage_solid(PocketShape::Cylindrical);
  solid.width = 0.008;
  CHECK_THROWS_WITH(cage_solid_inertia(solid), Catch::Contains("wide"));
  solid = cage_solid(PocketShape::Cylindrical);
  solid.outer_diameter = solid.inner_diameter;
  CHECK_THROWS_AS(cage_solid_inertia(solid), InputError);
  bearing::Cage cage;
  cage.cone_angle = 0.2;
  CHECK_THROWS_WITH(cage_inertia(cage, 12, kBall, 0.046, 7850.0), Catch::Contains("conical"));
}

TEST_CASE("A pocket's frame has its z axis through the pocket and y against the azimuth",
          "[unit][pocket]") {
  PocketPlacement placement;
  placement.azimuth = 0.7;
  placement.pitch_radius = 0.023;
  const PocketFrame frame = pocket_frame(placement);
  const Vec3 z = frame.cage_to_pocket.row(2), y = frame.cage_to_pocket.row(1);
  CHECK((frame.centre - 0.023 * z).norm() < 1e-15);
  CHECK((y + circumferential_direction(0.7)).norm() < 1e-15);
  placement.cone_angle = 0.2;  // apex on the +x side: the pocket's x axis leans inward
  CHECK(Vec3(pocket_frame(placement).cage_to_pocket.row(0)).dot(radial_direction(0.7)) < 0.0);
}
