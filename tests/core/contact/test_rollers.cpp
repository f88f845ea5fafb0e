#include "base/constants.hpp"
#include "base/errors.hpp"
#include "contact/line_contact.hpp"
#include "contact/race_errors.hpp"
#include "contact/roller_race.hpp"
#include "contact/slice_contact.hpp"
#include "contact/slice_traction.hpp"
#include "contact/sliced_line.hpp"
#include "contact/tapered_geometry.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace adore;
using namespace adore::contact;
using bearing::kInner;
using bearing::kOuter;

namespace {

RollerProfile straight(double half_angle = 0.0) {
  RollerProfile p;
  p.diameter = 0.01;
  p.length = 0.012;
  p.half_angle = half_angle;
  p.central_length = p.length;
  return p;
}

RollerProfile crowned(double half_angle = 0.0) {
  RollerProfile p = straight(half_angle);
  p.central_length = 0.0072;
  p.crown_radius = 1.8;
  p.corner_radius = {0.0003, 0.00036};
  return p;
}

RollerProfile barrel(double crown_radius, double half_angle = 0.0) {
  RollerProfile p = straight(half_angle);
  p.kind = RollerProfile::Kind::Arc;
  p.crown_radius = crown_radius;
  return p;
}

bearing::Material steel() {
  bearing::Material m;
  m.elastic_modulus = 206e9;
  m.poisson_ratio = 0.3;
  m.density = 7800.0;
  return m;
}

double race_depth(const RaceSurface& race, const Vec3& X) {
  return surface_depth(race, Triple<double>{X[0], X[1], X[2]}).depth;
}

/// Largest depth of the slice circle by sampling and golden section, no closest-point formula.
double deepest(const RaceSurface& race, const Vec3& C, const Vec3& a, const RollerSlice& slice) {
  const Vec3 e1 = a.cross(Vec3::UnitY()).normalized(), e2 = a.cross(e1);
  const auto depth = [&](double chi) {
    return race_depth(race,
                      C + slice.s * a + slice.radius * (std::cos(chi) * e1 + std::sin(chi) * e2));
  };
  int best = 0;
  constexpr int kScan = 90;
  for (int k = 1; k < kScan; ++k)
    if (depth(2 * kPi * k / kScan) > depth(2 * kPi * best / kScan)) best = k;
  double low = 2 * kPi * (best - 1) / kScan, high = 2 * kPi * (best + 1) / kScan;
  for (int n = 0; n < 60; ++n) {
    const double left = low + 0.381966 * (high - low), right = low + 0.618034 * (high - low);
    (depth(left) > depth(right) ? high : low) = depth(left) > depth(right) ? right : left;
  }
  return depth(0.5 * (low + high));
}

struct Scene {
  RaceSurface race;
  RollerProfile roller;
  double r, tilt;
};

/// One scene per surface, roller seated with a few micrometres of overlap.
std::vector<Scene> scenes() {
  const TaperedGeometry g = tapered_geometry(0.01, {15 * kPi / 180, 11 * kPi / 180});
  const auto cones = tapered_races(g);
  const auto grooves = grooved_tapered_races(g, 0.045, {0.515, 0.525});
  const SphericalRow row = spherical_row(0.01, 0.065, 0.17, 0.045, {0.515, 0.525}, -1e-5);
  const double r = 0.5 * g.pitch_diameter, nu = g.half_angle, beta = -g.axis_angle;
  return {{cylinder_race(kOuter, 0.037494), crowned(), 0.0325, 0.0},
          {cylinder_race(kInner, 0.027506), crowned(), 0.0325, 0.0},
          {cones[0], crowned(nu), r, beta},
          {cones[1], crowned(nu), r, beta},
          {grooves[0], barrel(0.045, nu), r, beta},
          {grooves[1], barrel(0.045, nu), r, beta},
          {row.race[0], barrel(0.045), 0.0325, -0.17},
          {row.race[1], barrel(0.045), 0.0325, -0.17}};
}

}  // namespace

TEST_CASE("A crown radius of 1e10 m and an infinite one are a straight roller", "[unit][rollers]") {
  for (const double nu : {0.0, 0.035}) {
    RollerProfile flat = crowned(nu), round = barrel(1e10, nu);
    flat.crown_radius = 1e10;
    for (const double s : {-0.006, -0.0037, 0.0, 0.002, 0.006}) {
      const double cone = 0.005 - s * std::tan(nu);
      // The true drop is below 2e-15 m; what is left is the rounding of a 5 mm radius.
      CHECK(std::abs(roller_radius(flat, s) - cone) < 4e-15);
      CHECK(std::abs(roller_radius(round, s) - cone) < 4e-15);
      CHECK(std::abs(roller_radius(barrel(INFINITY, nu), s) - cone) < 2e-18);
      CHECK(roller_slope(barrel(INFINITY, nu), s) == Approx(-std::tan(nu)).margin(1e-16));
    }
  }
}

TEST_CASE("Roller radius is the circle that defines it and the slope its derivative",
          "[unit][rollers]") {
  const double nu = 0.035, Rc = 0.05;
  const RollerProfile arc = barrel(Rc, nu);
  RollerProfile land = crowned(nu);
  land.land_offset = 3e-4;
  for (const double s : {-0.0055, -0.0042, -0.001, 0.0013, 0.0048, 0.0059}) {
    const double x = s + Rc * std::sin(nu);
    // The plain form loses digits of R_c: 1e-17 m.
    CHECK(std::abs(roller_radius(arc, s) -
                   (0.005 - Rc * std::cos(nu) + std::sqrt(Rc * Rc - x * x))) < 3e-17);
    const double h = 1e-6;
    for (const RollerProfile& p : {arc, land}) {
      const double slope = (roller_radius(p, s + h) - roller_radius(p, s - h)) / (2 * h);
      CHECK(roller_slope(p, s) == Approx(slope).margin(1e-9));  // h² ρ'''/6 and rounding/h
    }
  }
  // Tangent at the ends of the land: no kink.
  const double edge = land.land_offset + 0.5 * land.central_length;
  CHECK(roller_slope(land, edge + 1e-9) == Approx(-std::tan(nu)).margin(1e-9));
}

TEST_CASE("Slices fill the effective length and lands cut them continuously", "[unit][rollers]") {
  const Slicing cut = slicing(crowned(), 31);
  CHECK(cut.effective_length == Approx(0.01134));
  CHECK(cut.centre(0) - 0.5 * cut.width == Approx(-0.0057));
  CHECK(cut.centre(30) + 0.5 * cut.width == Approx(0.00564));
  double covered = 0.0;
  for (int k = 0; k < 31; ++k) covered += overlap_width(cut.centre(k), cut.width, 3e-4, 8.4e-3);
  CHECK(covered == Approx(8.4e-3).epsilon(1e-12));
  CHECK(overlap_width(0.1, 1e-3, 0.0, INFINITY) == 1e-3);
  CHECK(overlap_width(0.1, 1e-3, 0.0, 0.1) == 0.0);
  const double edge = 0.0045;
  CHECK(overlap_width(edge + 1e-12, 4e-4, 3e-4, 8.4e-3) ==
        Approx(overlap_width(edge - 1e-12, 4e-4, 3e-4, 8.4e-3)).margin(3e-12));
  CHECK(suggested_slice_count(straight(), 1e-5) == 20);
  CHECK(suggested_slice_count(barrel(0.9), 1e-6) > 40);
  CHECK_THROWS_AS(slicing(crowned(), 0), InputError);
}

TEST_CASE("Rollers that cannot exist are refused by name", "[unit][rollers]") {
  const auto message = [](const RollerProfile& p) -> std::string {
    try {
      check_roller_profile(p);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message(crowned()).empty());
  RollerProfile p = crowned();
  p.diameter = -1.0;
  CHECK_THAT(message(p), Catch::Contains("diameter is -1 m"));
  p = crowned();
  p.corner_radius = {0.007, 0.007};
  CHECK_THAT(message(p), Catch::Contains("corner radii"));
  p = barrel(0.004);
  CHECK_THAT(message(p), Catch::Contains("does not reach the end"));
  p = straight();
  p.end_radius[1] = 0.002;
  CHECK_THAT(message(p), Catch::Contains("end 2"));
  CHECK_THROWS_AS(cylinder_race(kInner, -0.1), InputError);
  CHECK_THROWS_AS(groove_race(kInner, 0.0, 0.0, 0.1), InputError);
}

TEST_CASE("Slice penetration is the greatest depth of the slice circle", "[physics][rollers]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double worst = 0.0;
  for (const Scene& scene : scenes()) {
    const auto slices = roller_slices(scene.roller, slicing(scene.roller, 7));
    for (int trial = 0; trial < 4; ++trial) {
      const Vec3 C(1e-4 * unit(random), 3e-5 * unit(random), scene.r + 1e-5 * unit(random));
      const Vec3 a = roller_axis(scene.tilt + 0.02 * unit(random), 0.03 * unit(random));
      for (const RollerSlice& slice : slices) {
        const double found = slice_contact(scene.race, C, a, slice).delta;
        worst = std::max(worst, std::abs(found - deepest(scene.race, C, a, slice)));
        // The same circle, whichever way the axis points.
        CHECK(slice_contact(scene.race, C, -a, {-slice.s, slice.radius}).delta ==
              Approx(found).margin(1e-17));
      }
    }
  }
  CHECK(worst < 1e-16);  // rounding of coordinates of 40 mm
}

TEST_CASE("Penetration derivatives follow from the contact point and normal alone",
          "[physics][rollers]") {
  for (const Scene& scene : scenes()) {
    RacePose pose;
    pose.centre = Vec3(2e-5, -3e-5, 7e-6);
    pose.axes = passive_rotation_y(6e-4).transpose() * passive_rotation_z(-9e-4).transpose();
    const Vec3 C(8e-5, 0.0, scene.r), a = roller_axis(scene.tilt + 3e-4, -2e-3);
    const RollerSlice slice = roller_slices(scene.roller, slicing(scene.roller, 5))[1];
    const auto contact = [&](const RacePose& p, const Vec3& centre, const Vec3& axis) {
      SliceContact c;
      roller_race_contacts(scene.race, p, centre, axis, {&slice, 1}, {&c, 1});
      return c;
    };
    const SliceContact at = contact(pose, C, a);
    const Vec3 turn = rotation_gradient(at, C), race_turn = rotation_gradient(at, pose.centre);
    const double h = 1e-6;
    for (int i = 0; i < 3; ++i) {
      const Vec3 d = h * Vec3::Unit(i);
      const auto rotation = [&](double sign) {
        return Mat3(Eigen::AngleAxisd(sign * h, Vec3::Unit(i)).toRotationMatrix());
      };
      const auto slope = [&](double plus, double minus) { return (plus - minus) / (2 * h); };
      // Central differences of a nearly quadratic function: rounding 1e-17/1e-6 is the error.
      CHECK(slope(contact(pose, C + d, a).delta, contact(pose, C - d, a).delta) ==
            Approx(at.normal[i]).margin(1e-9));
      CHECK(slope(contact(pose, C, rotation(1) * a).delta,
                  contact(pose, C, rotation(-1) * a).delta) == Approx(turn[i]).margin(1e-11));
      RacePose plus = pose, minus = pose;
      plus.axes = rotation(1) * pose.axes;
      minus.axes = rotation(-1) * pose.axes;
      CHECK(slope(contact(plus, C, a).delta, contact(minus, C, a).delta) ==
            Approx(-race_turn[i]).margin(1e-10));
    }
  }
}

TEST_CASE("A skewed straight roller digs its ends into the outer race and lifts them off the inner",
          "[physics][rollers]") {
  const double r = 0.0325, skew = 0.004;
  for (const RollerSlice& slice : roller_slices(straight(), slicing(straight(), 9))) {
    const Vec3 C(0.0, 0.0, r), a = roller_axis(0.0, skew);
    const double change = slice.s * slice.s * skew * skew / (2 * r);
    // Next order: x⁴φ⁴/r³ and the shortening x φ²/2, below 1e-13 m.
    CHECK(slice_contact(cylinder_race(kOuter, 0.0375), C, a, slice).delta ==
          Approx(change).margin(2e-13));
    CHECK(slice_contact(cylinder_race(kInner, 0.0275), C, a, slice).delta ==
          Approx(-change).margin(2e-13));
    // Without tilt and skew: exactly the radial overlap.
    CHECK(slice_contact(cylinder_race(kOuter, 0.037494), C, Vec3::UnitX(), slice).delta ==
          Approx(6e-6).margin(1e-17));
  }
}

TEST_CASE("Sliced load converges with the square of the slice width", "[physics][rollers]") {
  const RollerProfile p = crowned();
  const double delta0 = 2e-5, slope = 7e-4;  // every slice loaded
  const SlicedLine reference = sliced_line(p, 1, kLineConstantSteel);
  const auto depth = [&](double x) { return delta0 + slope * x - profile_drop(p, x); };
  const ContinuumResultant whole =
      continuum_resultant(reference.law, -0.0057, 0.00564, depth, {-0.0036, 0.0036});
  std::array<double, 3> load_error{}, moment_error{};
  for (std::size_t k = 0; k < 3; ++k) {
    const LineResultant sum =
        line_resultant(sliced_line(p, 40 << (2 * k), kLineConstantSteel), delta0, slope);
    load_error[k] = std::abs(sum.load / whole.load - 1);
    moment_error[k] = std::abs(sum.moment / whole.moment - 1);
  }
  CHECK(load_error[0] < 1e-4);
  // Width falls by 4 each time: order 2 gives 16; the curvature jumps inside slices blur it a
  // little.
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(load_error[k] / load_error[k + 1] == Approx(16.0).epsilon(0.3));
    CHECK(moment_error[k] / moment_error[k + 1] == Approx(16.0).epsilon(0.3));
  }
}

TEST_CASE("A tilt on a straight roller loses 1/n² of its moment", "[physics][rollers]") {
  for (const int n : {10, 31}) {
    const SlicedLine line = sliced_line(straight(), n, kLineConstantSteel);
    const double slope = 1e-6, delta0 = 1e-5;
    const double whole = continuum_resultant(line.law, -0.006, 0.006, [&](double x) {
                           return delta0 + slope * x;
                         }).moment;
    CHECK(1 - line_resultant(line, delta0, slope).moment / whole ==
          Approx(1.0 / (n * n)).epsilon(1e-3));
  }
}

TEST_CASE("Slice loads add up to the roller's law and their slopes are derivatives",
          "[physics][rollers]") {
  const SlicedLine line = sliced_line(straight(), 30, kLineConstantSteel);
  const double delta = 7e-6;
  CHECK(line_resultant(line, delta, 0.0).load ==
        Approx(8.06e10 * std::pow(0.012, 8.0 / 9.0) * std::pow(delta, 10.0 / 9.0)).epsilon(1e-13));
  const SlicedLine shaped = sliced_line(crowned(), 31, kLineConstantSteel, 8.4e-3, 3e-4);
  const double slope = 1.3e-3, h = 1e-9;
  const LineResultant at = line_resultant(shaped, delta, slope);
  const auto shifted = [&](double d, double s) {
    return line_resultant(shaped, delta + d, slope + s);
  };
  CHECK(at.load_by_approach ==
        Approx((shifted(h, 0).load - shifted(-h, 0).load) / (2 * h)).epsilon(1e-5));
  const double turn = 1e-7;
  CHECK(at.load_by_slope ==
        Approx((shifted(0, turn).load - shifted(0, -turn).load) / (2 * turn)).epsilon(1e-5));
  CHECK(at.moment_by_slope ==
        Approx((shifted(0, turn).moment - shifted(0, -turn).moment) / (2 * turn)).epsilon(1e-5));
  CHECK(approach_for_load(shaped, slope, at.load) == Approx(delta).epsilon(1e-13));
  CHECK_THROWS_AS(approach_for_load(shaped, slope, -1.0), InputError);
}

TEST_CASE("Line pressure and subsurface stresses are those of plane strain", "[physics][rollers]") {
  const LinePressure line = line_pressure(1e5, 236.0, 113e9);
  CHECK(line.peak == Approx(2e5 / (kPi * line.half_width)).epsilon(1e-14));
  const SubsurfaceStress s = line_subsurface_stress(line, 0.3);
  CHECK(s.orthogonal_shear == Approx(0.25 * line.peak).epsilon(1e-9));
  CHECK(s.orthogonal_depth == Approx(0.5 * line.half_width).epsilon(1e-9));
  double shear = 0.0, octahedral = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double z = 1e-4 * k, root = std::sqrt(1 + z * z);
    const double y = -((1 + 2 * z * z) / root - 2 * z), depth = -1 / root, x = 0.3 * (y + depth);
    const auto [low, high] = std::minmax({x, y, depth});
    shear = std::max(shear, 0.5 * (high - low));
    octahedral = std::max(octahedral, std::hypot(x - y, y - depth, depth - x) / 3);
  }
  CHECK(s.max_shear ==
        Approx(shear * line.peak).epsilon(1e-8));  // grid of 1e-4 b around a flat top
  CHECK(s.octahedral == Approx(octahedral * line.peak).epsilon(1e-8));
}

TEST_CASE("The half-space law agrees with its tabulated approaches and inverts itself",
          "[physics][rollers]") {
  struct Row {
    double q, power, thin, middle, thick;
  };
  // rollers theory, section 3: micrometres, three digits.
  for (const Row& row : {Row{2e4, 0.717, 0.598, 0.650, 0.728}, Row{1e5, 3.05, 2.54, 2.80, 3.19},
                         Row{3e5, 8.20, 6.69, 7.47, 8.63}, Row{1e6, 24.2, 18.9, 21.5, 25.4}}) {
    const auto approach = [&](double d) {
      return 1e6 * half_space_approach(half_space_law(steel(), steel(), d), row.q, 0.005, 40.0);
    };
    CHECK(approach(0.002) == Approx(row.thin).epsilon(0.004));
    CHECK(approach(0.005) == Approx(row.middle).epsilon(0.004));
    CHECK(approach(0.02) == Approx(row.thick).epsilon(0.004));
    const double power = std::pow(row.q * std::pow(0.01, 1.0 / 9.0) / kLineConstantSteel, 0.9);
    CHECK(1e6 * power == Approx(row.power).epsilon(0.004));
  }
  const HalfSpaceLaw law = half_space_law(steel(), steel(), 0.006);
  for (const double q : {1e-3, 10.0, 1e5, 3e6, 1e9, 1e12}) {  // the last ones on the tangent
    const double delta = half_space_approach(law, q, 0.005, 36.0);
    const SliceLoad load = slice_load(law, 0.5e-3, delta, 0.005, 36.0);
    CHECK(load.load == Approx(0.5e-3 * q).epsilon(1e-12));
    const double h = 1e-5 * delta;
    const double slope = (slice_load(law, 0.5e-3, delta + h, 0.005, 36.0).load -
                          slice_load(law, 0.5e-3, delta - h, 0.005, 36.0).load) /
                         (2 * h);
    CHECK(load.slope == Approx(slope).epsilon(1e-6));
  }
  CHECK(slice_load(law, 1e-3, 0.0, 0.005, 36.0).load == 0.0);
  CHECK_THROWS_AS(half_space_law(steel(), steel(), 0.0), InputError);
}

TEST_CASE("Other materials scale the line constant as the general formula does",
          "[physics][rollers]") {
  bearing::Material ceramic = steel();
  ceramic.elastic_modulus = 310e9;
  ceramic.poisson_ratio = 0.26;
  for (const auto& [one, two] : {std::pair(steel(), steel()), std::pair(ceramic, steel())}) {
    const double Q = 2000.0, L = 0.01, delta = approach_palmgren(Q, L, one, two);
    const double K = line_constant(bearing::contact_modulus(one, two));
    CHECK(K * std::pow(L, 8.0 / 9.0) * std::pow(delta, 10.0 / 9.0) == Approx(Q).epsilon(0.01));
  }
  const ContactLength touching = contact_length(0.012, 0.1, 1e-5);
  CHECK(touching.length == Approx(2 * std::sqrt(2e-6)));
  CHECK(touching.log_slope == 0.5);
  CHECK(contact_length(0.012, 5.0, 1e-5).length == 0.012);
}

TEST_CASE("Cones with a common apex touch along their lines and roll without slip",
          "[physics][rollers]") {
  const TaperedGeometry g = tapered_geometry(0.012, {15 * kPi / 180, 11 * kPi / 180});
  const auto races = tapered_races(g);
  const RollerProfile p = [&] {
    RollerProfile cone = straight(g.half_angle);
    cone.diameter = 0.012;
    cone.length = 0.018;
    return cone;
  }();
  const Vec3 C(0.0, 0.0, 0.5 * g.pitch_diameter), a = roller_axis(-g.axis_angle, 0.0);
  const std::array<double, 2> speed = {-50.0, 800.0};
  const RollingSpeeds rolling =
      rolling_speeds({g.contact[0][1], g.contact[1][1]}, 0.012, g.axis_angle, speed);
  CHECK(rolling.spin < 0.0);
  const RigidMotion roller = {C, rolling.orbital * Vec3::UnitX().cross(C), rolling.omega};
  for (std::size_t race = 0; race < 2; ++race)
    for (const RollerSlice& slice : roller_slices(p, slicing(p, 9))) {
      const SliceContact c = slice_contact(races[race], C, a, slice);
      CHECK(std::abs(c.delta) < 3e-17);
      CHECK(contact_slip({Vec3::Zero(), Vec3::Zero(), speed[race] * Vec3::UnitX()}, roller, c.point,
                         c.normal)
                .norm() < 1e-12);
    }
  // A moved inner race closes Δx sin α_i of the normal gap.
  RacePose moved;
  moved.centre = Vec3(1e-5, 0.0, 0.0);
  const RollerSlice middle = {0.0, 0.006};
  SliceContact c;
  roller_race_contacts(races[1], moved, C, a, {&middle, 1}, {&c, 1});
  CHECK(c.delta == Approx(1e-5 * std::sin(g.race_angle[1])).epsilon(1e-6));
}

TEST_CASE("Skew drives a roller along its axis to opposite sides at the two races",
          "[physics][rollers]") {
  // ω_s < 0, φ > 0: the outer race pushes along -(ω_s φ) = +x.
  const double r = 0.0325, skew = 0.004, R_o = 0.0375, R_i = 0.0275;
  const RollingSpeeds rolling = rolling_speeds({R_o, R_i}, 0.01, 0.0, {0.0, 600.0});
  const Vec3 C(0.0, 0.0, r), a = roller_axis(0.0, skew);
  const RigidMotion roller = {C, rolling.orbital * Vec3::UnitX().cross(C),
                              rolling.orbital * Vec3::UnitX() + rolling.spin * a};
  const auto push = [&](int side, double R, double speed) {
    const SliceContact c = slice_contact(cylinder_race(side, R), C, a, {0.0, 0.005});
    const Vec3 slip = contact_slip({Vec3::Zero(), Vec3::Zero(), speed * Vec3::UnitX()}, roller,
                                   c.point, c.normal);
    ContactWrench sum;
    add_contact(sum, 100.0, c.point, c.normal, slip, C, [](double) { return 0.05; });
    CHECK(sum.heat == Approx(5.0 * slip.squaredNorm()));
    const Vec3 G = C - 1e-4 * a;
    CHECK((moment_about(sum.moment, sum.force, C, G) - (sum.moment + 1e-4 * a.cross(sum.force)))
              .norm() < 1e-15);
    CHECK(entrainment({Vec3::Zero(), Vec3::Zero(), speed * Vec3::UnitX()}, roller,
                      {Vec3::Zero(), Vec3::Zero(), rolling.orbital * Vec3::UnitX()}, c.point,
                      c.normal)
              .norm() == Approx(std::abs(rolling.spin) * 0.005).epsilon(1e-4));  // cos of the skew
    return sum.force[0];
  };
  const double outer = push(kOuter, R_o, 0.0), inner = push(kInner, R_i, 600.0);
  CHECK(outer > 0.0);
  CHECK(inner == Approx(-outer).epsilon(1e-3));
}

TEST_CASE("Race errors move the surface and tilt its normal", "[physics][rollers]") {
  RaceErrors wave;
  wave.roundness = RaceErrors::Roundness::Sinusoidal;
  wave.variation = {5e-6, 5.0, 0.3};
  RaceErrors oval = wave;
  oval.roundness = RaceErrors::Roundness::Elliptical;
  oval.variation = {6e-6, -2e-6, 0.55};
  const double R = 0.0375;
  for (const RaceErrors& errors : {wave, oval})
    for (const double psi : {0.0, 0.7, 2.9}) {
      const LocalRaceError e = race_error_at(errors, R, psi);
      const double h = 1e-5;
      CHECK(e.radius_slope == Approx((race_error_at(errors, R, psi + h).radius -
                                      race_error_at(errors, R, psi - h).radius) /
                                     (2 * h))
                                  .margin(1e-11));
      // Gradient of σ(r - R(ψ)) at a point of the surface.
      const Vec3 X = (R + e.radius) * radial_direction(psi);
      const Vec3 n = wavy_normal(radial_direction(psi), X, e.radius_slope);
      const Vec3 along =
          (R + race_error_at(errors, R, psi + h).radius) * radial_direction(psi + h) -
          (R + race_error_at(errors, R, psi - h).radius) * radial_direction(psi - h);
      CHECK(std::abs(n.dot(along.normalized())) < 1e-9);
    }
  CHECK(race_error_at(oval, R, 0.55).radius == Approx(6e-6));
  CHECK(race_error_at(oval, R, 0.55 + 0.5 * kPi).radius == Approx(-2e-6));
  // A ball groove: the bottom stays when the curvature factor changes, and follows the radius.
  const double angle = 0.3, D = 0.0127;
  const std::array<double, 2> n = {std::sin(angle), std::cos(angle)};
  const RaceSurface groove =
      groove_race(kOuter, 0.52 * D, -0.02 * D * n[0], 0.03 - 0.02 * D * n[1]);
  const Vec3 bottom(0.5 * D * n[0], 0.0, 0.03 + 0.5 * D * n[1]);
  CHECK(race_depth(groove, bottom) == Approx(0.0).margin(1e-17));
  LocalRaceError change;
  change.curvature_factor = 0.004;
  CHECK(race_depth(race_with_error(groove, change, D, n), bottom) == Approx(0.0).margin(1e-17));
  change.radius = 3e-6;
  CHECK(race_depth(race_with_error(groove, change, D, n), bottom + Vec3(0, 0, 3e-6)) ==
        Approx(0.0).margin(1e-17));
  // Taper opens towards +x about mid contact.
  LocalRaceError taper;
  taper.taper = 1e-3;
  RaceSurface cylinder = cylinder_race(kOuter, R);
  cylinder.mid_x = 0.002;
  const RaceSurface tapered = race_with_error(cylinder, taper);
  CHECK(race_depth(tapered, Vec3(0.002, 0.0, R)) == Approx(0.0).margin(1e-17));
  CHECK(race_depth(tapered, Vec3(0.003, 0.0, R)) == Approx(-1e-6).epsilon(1e-5));
}

TEST_CASE("roller between races: normal loads turn barrels in grooves out of line, not cylinders",
          "[physics][contact][rollers]") {
  // Curvatures of both bodies about the contact, the roller turned by φ: along the roller the gap
  // is κ(φ) s²/2 with κ(φ) = κ(0) - A φ², A = g (1 + g/κ'), g the curvature of the race across its
  // meridian less that along it (concave > 0), κ' of both bodies across the roller. So δ grows by A
  // φ² s²/2 and M = -dU/dφ = -A φ Σ Q s². On cylinders A = ±1/r_m of the pitch circle: no moment of
  // both together. On grooves both A add up to about -(1/R_g + 1/R_g'): the moment increases the
  // skew [derived].
  constexpr double kPitch = 0.06, kRadius = 0.0105, kLength = 0.022, kCrown = 0.072, kLoad = 5000.0;
  constexpr int kSlices = 101;
  constexpr double kWidth = kLength / kSlices;
  const PowerLaw law{3.6e10};
  for (const bool groove : {true, false}) {
    double total = 0.0, size = 0.0;
    for (const int j : {kOuter, kInner}) {
      const double sigma = j == kOuter ? 1.0 : -1.0, R = kPitch + sigma * kRadius;
      const double meridian = j == kOuter ? 0.0742 : 0.0735;
      const RaceSurface race =
          groove ? groove_race(j, meridian, 0.0, R - sigma * meridian) : cylinder_race(j, R);
      std::vector<RollerSlice> slices;
      for (int k = 0; k < kSlices; ++k) {
        const double s = (k - 0.5 * (kSlices - 1)) * kWidth;
        // On cylinders a crown of 18 m keeps the contact within the roller.
        const double crown = groove ? kCrown : 18.0;
        slices.push_back({s, kRadius - s * s / (crown + std::sqrt(crown * crown - s * s))});
      }
      const RollerRaceSlices sliced = roller_race_slices(race, slices, kWidth, law, 2.2e11);
      const auto action = [&](double deep, double skew) {
        const RigidMotion still{};
        return roller_race_action<double>(sliced, {}, still, Vec3(0.0, 0.0, kPitch + sigma * deep),
                                          roller_axis(0.0, skew), still, nullptr);
      };
      double low = 0.0, high = 1e-4;
      for (int n = 0; n < 50; ++n) {
        const double middle = 0.5 * (low + high);
        (action(middle, 0.0).load > kLoad ? high : low) = middle;
      }
      double second = 0.0;  // Σ Q s²
      for (const RollerSlice& slice : slices) {
        const double delta =
            slice_contact(race, Vec3(0.0, 0.0, kPitch + sigma * high), Vec3::UnitX(), slice).delta;
        if (delta > 0.0) second += slice_load(law, kWidth, delta).load * slice.s * slice.s;
      }
      const double g = sigma / R - (groove ? 1.0 / meridian : 0.0);
      const double A = g * (1.0 + g / (1.0 / kRadius - sigma / R));
      if (!groove) CHECK(A == Approx(sigma / kPitch));
      constexpr double kSkew = 1e-3;
      const double moment = action(high, kSkew).moment.z() / kSkew;
      CAPTURE(groove, j, second);
      CHECK(moment == Approx(-A * second).epsilon(0.01));
      CHECK(action(high, -kSkew).moment.z() == Approx(-kSkew * moment).epsilon(1e-6));
      total += moment;
      size += std::abs(moment);
    }
    CAPTURE(groove, total, size);
    if (groove)
      CHECK(total > 0.9 * size);  // [N m/rad], in the direction of the skew
    else
      CHECK(std::abs(total) < 0.05 * size);
  }
}
