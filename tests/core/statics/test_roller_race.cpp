#include "contact/roller_race.hpp"
#include "contact/roller_race_simd.hpp"
#include "roller_bearings.hpp"
#include "statics/roller_equilibrium.hpp"
#include "statics/roller_model.hpp"
#include "tribology/traction_law.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::statics;
using contact::roller_race_action;
using contact::RollerRaceAction;

namespace {

/// Pose and motion of a roller and a race, tilted, skewed and pressed in by some 20 µm.
struct Scene {
  contact::RollerRaceSlices slices;
  contact::RacePose pose;
  contact::RigidMotion race, roller;
  Vec3 centre, axis;
};

Mat3 turn(double angle, const Vec3& about) {
  return Eigen::AngleAxisd(angle, about.normalized()).toRotationMatrix();
}

Scene scene_of(const bearing::Bearing& bearing, std::size_t j, double land = 0.0) {
  const RollerModel m = make_roller_model(bearing, {});
  const RollerContactGeometry& body = m.body(0);
  contact::RaceSurface race = body.race[j];
  if (land > 0.0) race.land_width = land;
  Scene scene;
  scene.slices =
      contact::roller_race_slices(race, body.slices, m.slicing.width, m.law[j], m.E_star[j]);
  const double sigma = j == 0 ? 1.0 : -1.0, azimuth = 2.1;
  const Mat3 to_base = turn(azimuth, Vec3::UnitX());
  scene.pose.centre = Vec3(2e-6, -3e-6, 5e-6);
  scene.pose.axes = turn(4e-4, {0.0, 1.0, -2.0}) * turn(0.7, Vec3::UnitX());
  scene.centre = to_base * Vec3(3e-6, 2e-7, 0.5 * m.rollers.pitch_diameter + sigma * 4e-5);
  scene.axis = to_base * contact::roller_axis(-m.rollers.axis_angle + 1e-3, 4e-3);
  scene.race = {scene.pose.centre, {0.01, -0.02, 0.03}, 310.0 * scene.pose.axes.col(0)};
  const Vec3 orbit = 120.0 * Vec3::UnitX();
  scene.roller = {scene.centre, orbit.cross(scene.centre) + Vec3(0.05, 0.0, 0.02),
                  orbit + sigma * 700.0 * scene.axis + Vec3(0.0, 1.0, -2.0)};
  return scene;
}

template <class T = double>
RollerRaceAction action(const Scene& s, const tribology::TractionLaw* law = nullptr) {
  const auto with = [&](const auto& traction) {
    return roller_race_action<T>(s.slices, s.pose, s.race, s.centre, s.axis, s.roller, traction);
  };
  if (law == nullptr) return with(nullptr);
  return law->visit_regularized<T>(with);
}

double power(const Scene& s, const RollerRaceAction& a) {
  return a.force.dot(s.roller.at(s.centre)) + a.moment.dot(s.roller.omega) -
         a.force.dot(s.race.at(s.pose.centre)) + a.race_moment.dot(s.race.omega);
}

std::vector<bearing::Bearing> bearings() {
  return {roller_bearings::cylindrical(0.0), roller_bearings::tapered(0.0),
          roller_bearings::spherical(0.0),
          roller_bearings::on_crowned_races(roller_bearings::cylindrical(0.0)),
          roller_bearings::on_crowned_races(roller_bearings::tapered(0.0))};
}

const tribology::TractionLaw kLaw =
    bearing::TractionCurve{bearing::TractionCurve::Form::TwoSlope, 0.0, 2.0, -0.01, 0.0, 0.02};
const tribology::TractionLaw kCoulomb =
    bearing::TractionCurve{bearing::TractionCurve::Form::Exponential, 0.02, 0.3, 4.0, 0.03, 0.0};

}  // namespace

TEST_CASE("roller in motion: without traction its force is minus the gradient of the energy",
          "[physics][rollers]") {
  // On its land, and reaching over both of its edges.
  for (const bearing::Bearing& bearing : bearings())
    for (const auto& [j, land] : {std::pair{0UL, 0.0}, {1UL, 0.0}, {0UL, 0.0081}, {1UL, 0.0081}}) {
      const Scene scene = scene_of(bearing, j, land);
      const RollerRaceAction here = action(scene);
      REQUIRE(here.load > 100.0);
      CHECK(here.heat == 0.0);
      const auto slope = [&](double step, const auto& move) {
        Scene up = scene, down = scene;
        move(up, step);
        move(down, -step);
        return (action(up).energy - action(down).energy) / (2.0 * step);
      };
      for (int i = 0; i < 3; ++i) {
        const Vec3 e = Vec3::Unit(i);
        // Differences over 1e-8 m of an energy whose slices open as δ^(19/9).
        CHECK(slope(1e-8, [&](Scene& s, double h) { s.centre += h * e; }) ==
              Approx(-here.force[i]).margin(1e-6 * here.load));
        CHECK(slope(1e-6, [&](Scene& s, double h) { s.axis = turn(h, e) * s.axis; }) ==
              Approx(-here.moment[i]).margin(1e-8 * here.load));
        CHECK(slope(1e-8, [&](Scene& s, double h) { s.pose.centre += h * e; }) ==
              Approx(here.force[i]).margin(1e-6 * here.load));
        CHECK(slope(1e-7, [&](Scene& s, double h) { s.pose.axes = turn(h, e) * s.pose.axes; }) ==
              Approx(-here.race_moment[i]).margin(1e-7 * here.load));
      }
    }
}

TEST_CASE("roller in motion: turned and moved as a whole, all turns and moves with it",
          "[physics][rollers]") {
  const Mat3 R = turn(1.3, {0.3, -1.0, 0.5});
  const Vec3 shift(0.4, -0.2, 0.1);
  for (const bearing::Bearing& bearing : bearings())
    for (std::size_t j = 0; j < 2; ++j) {
      const Scene scene = scene_of(bearing, j);
      Scene moved = scene;
      moved.pose.centre = R * scene.pose.centre + shift;
      moved.pose.axes = R * scene.pose.axes;
      moved.centre = R * scene.centre + shift;
      moved.axis = R * scene.axis;
      for (auto [to, from] :
           {std::pair(&moved.race, &scene.race), std::pair(&moved.roller, &scene.roller)})
        *to = {R * from->origin + shift, R * from->velocity, R * from->omega};
      const RollerRaceAction a = action(scene, &kLaw), b = action(moved, &kLaw);
      // Coordinates of half a meter, rounded at 1e-16 m, against stiffnesses of 1e9 N/m.
      CHECK((b.force - R * a.force).norm() < 1e-9 * a.load);
      CHECK((b.moment - R * a.moment).norm() < 1e-10 * a.load);
      CHECK((b.race_moment - R * a.race_moment).norm() < 1e-10 * a.load);
      CHECK(b.heat == Approx(a.heat).epsilon(1e-9));
      CHECK(b.energy == Approx(a.energy).epsilon(1e-9));
    }
}

TEST_CASE("roller in motion: traction takes from both bodies what it turns into heat",
          "[physics][rollers]") {
  for (const bearing::Bearing& bearing : bearings())
    for (std::size_t j = 0; j < 2; ++j)
      for (const auto* law : {&kLaw, &kCoulomb}) {
        const Scene scene = scene_of(bearing, j);
        const RollerRaceAction with = action(scene, law), without = action(scene);
        CHECK(with.heat > 0.0);
        CHECK(with.load == without.load);
        // Against the powers of roller and race, some 100 times the heat.
        CHECK(power(scene, with) - power(scene, without) == Approx(-with.heat).epsilon(1e-9));
        CHECK(with.load_slip > 0.0);
        CHECK((with.force - without.force).norm() < 0.1 * with.load);
      }
}

TEST_CASE("roller in motion: one slice a lane gives what one slice after the other gives",
          "[unit][rollers]") {
  for (const bearing::Bearing& bearing : bearings())
    for (std::size_t j = 0; j < 2; ++j)
      for (const double land : {0.0, 0.0055}) {
        const Scene scene = scene_of(bearing, j, land);
        const RollerRaceAction one = action(scene, &kCoulomb),
                               many = action<SimdReal>(scene, &kCoulomb);
        CHECK((many.force - one.force).norm() < 1e-12 * one.load);
        CHECK((many.moment - one.moment).norm() < 1e-13 * one.load);
        CHECK(many.load == Approx(one.load).epsilon(1e-12));
        CHECK(many.energy == Approx(one.energy).epsilon(1e-12));
        CHECK(many.heat == Approx(one.heat).epsilon(1e-11));
        CHECK(many.load_slip == Approx(one.load_slip).epsilon(1e-11));
        if (land > 0.0) CHECK(one.load < action(scene_of(bearing, j), &kCoulomb).load);
      }
}

TEST_CASE("the ninth root of vectors is that of numbers", "[unit]") {
  for (double x = 1e-30; x < 1e3; x *= 1.7)
    CHECK(ScalarMath<SimdReal>::ninth_root(SimdReal(x))[0] ==
          Approx(std::pow(x, 1.0 / 9.0)).epsilon(1e-15));
  CHECK(ScalarMath<SimdReal>::ninth_root(SimdReal(0.0))[0] == 0.0);
}

TEST_CASE("roller in motion: at rest it is the roller of statics", "[physics][rollers]") {
  for (const bearing::Bearing& bearing : bearings()) {
    const RollerModel m = make_roller_model(bearing, {});
    for (std::size_t j = 0; j < 2; ++j) {
      const SliceSet set = m.slices(j, m.body(0));
      const double sigma = j == 0 ? 1.0 : -1.0;
      const Vec4 p(3e-6, 0.5 * m.rollers.pitch_diameter + sigma * 4e-5,
                   -std::sin(m.rollers.axis_angle) + 1e-3, 4e-3);
      PairPotential statics;
      add_slices(set, p, statics);
      Scene scene;
      scene.slices =
          contact::roller_race_slices(set.race, set.slices, set.width, set.law, m.E_star[j]);
      scene.centre = {p(0), 0.0, p(1)};
      scene.axis = {std::sqrt(1.0 - p(2) * p(2) - p(3) * p(3)), p(3), p(2)};
      const RollerRaceAction a = action<SimdReal>(scene);
      CHECK(a.load == Approx(statics.total).epsilon(1e-12));
      // F = -(U_x A + U_r e + (U_t f - U_f t)/r y'), M = -a × (U_t e + U_f y').
      const Vec4& g = statics.gradient;
      const Vec3 force(-g(0), -(g(2) * p(3) - g(3) * p(2)) / p(1), -g(1));
      const Vec3 moment = -scene.axis.cross(Vec3(0.0, g(3), g(2)));
      CHECK((a.force - force).norm() < 1e-11 * a.load);
      CHECK((a.moment - moment).norm() < 1e-12 * a.load);
    }
  }
}

TEST_CASE("roller in motion: the rollers of a solved bearing are in balance",
          "[physics][rollers]") {
  auto bearing = roller_bearings::cylindrical(9000.0);  // an NU bearing, 5 kN
  const RollerModel m = make_roller_model(bearing, {});
  const RollerSolution solution = solve_roller_statics(bearing, {});
  const auto& q = solution.displacement;
  contact::RacePose inner;
  inner.centre = {q[0], q[1], q[2]};
  inner.axes = turn(q[4], Vec3::UnitZ()) * turn(q[3], Vec3::UnitY());
  Vec3 carried = Vec3::Zero();
  int loaded = 0;
  for (const StaticRoller& roller : solution.rollers) {
    const double s = std::sin(roller.azimuth), c = std::cos(roller.azimuth);
    const Vec3 e_r(0.0, -s, c);
    Scene scene;
    scene.centre = roller.x * Vec3::UnitX() + roller.r * e_r;
    scene.axis = std::cos(roller.tilt) * Vec3::UnitX() + std::sin(roller.tilt) * e_r;
    std::array<RollerRaceAction, 2> a;
    for (std::size_t j = 0; j < 2; ++j) {
      const SliceSet set = m.slices(j, m.body(0));
      scene.slices =
          contact::roller_race_slices(set.race, set.slices, set.width, set.law, m.E_star[j]);
      scene.pose = j == 0 ? contact::RacePose() : inner;
      a[j] = action<SimdReal>(scene);
      CHECK(a[j].load == Approx(roller.race[j].load).epsilon(1e-8).margin(1e-6));
    }
    const Vec3 sum = a[0].force + a[1].force + solution.centrifugal_force * e_r;
    CHECK(std::abs(sum.dot(e_r)) < 1e-6);  // of 5 kN
    carried -= a[1].force;
    loaded += a[1].load > 0.0 ? 1 : 0;
  }
  CHECK(loaded >= 3);
  CHECK(carried[2] == Approx(-5000.0).epsilon(1e-8));
  CHECK(std::abs(carried[1]) < 1e-4);
}

TEST_CASE("roller in motion: a crown slips by half its drop, on the roller or on the raceway",
          "[physics][rollers]") {
  // Two bodies of one stiffness meet half way between their profiles: a drop d of the profile of
  // one leaves the surface in the contact d/2 beside that of the middle, and with W the turning of
  // roller and race against each other a slice there slips by W d/2. Crowns of d/2 on both meet in
  // a plane.
  constexpr double kCrown = 3.0, kDeep = 2e-5, kLinear = 0.05;  // [m], [m], κ/s [s/m]
  for (std::size_t j = 0; j < 2; ++j) {
    double heat[3] = {}, expected = 0.0;
    for (const int crowned : {0, 1, 2}) {  // the roller, the raceway, both by half
      bearing::Bearing b = roller_bearings::cylindrical(0.0, 0.0);
      bearing::RollerGeometry& g = *b.rollers();
      g.central_length = 0.0;
      g.race_central_length = {0.0, 0.0};
      g.crown_radius = crowned == 0 ? kCrown : crowned == 2 ? 2.0 * kCrown : 1e10;
      if (crowned != 0) g.race_crown_radius.fill(crowned == 1 ? kCrown : 2.0 * kCrown);
      const RollerModel m = make_roller_model(b, {});
      const RollerContactGeometry& body = m.body(0);
      const double sigma = j == 0 ? 1.0 : -1.0;
      Scene s;
      s.slices = contact::roller_race_slices(body.race[j], body.slices, m.slicing.width, m.law[j],
                                             m.E_star[j]);
      const double race_radius = body.race[j].radius, r = race_radius - sigma * 0.5 * g.diameter;
      s.centre = {0.0, 0.0, r + sigma * kDeep};
      s.axis = Vec3::UnitX();
      s.race = {Vec3::Zero(), Vec3::Zero(), 200.0 * Vec3::UnitX()};
      // The middle rolls: no slip half way into the overlap.
      const double spin = -900.0;
      const Vec3 touch(0.0, 0.0, race_radius + sigma * 0.5 * kDeep);
      s.roller = {touch, s.race.at(touch), spin * Vec3::UnitX()};
      const RollerRaceAction a =
          roller_race_action<double>(s.slices, s.pose, s.race, s.centre, s.axis, s.roller,
                                     [](double, double) { return kLinear; });
      heat[crowned] = a.heat;
      if (crowned != 0) continue;
      for (std::size_t k = 0; k < s.slices.count; ++k) {
        const double at = s.slices.s[k],
                     drop = at * at / (kCrown + std::sqrt(kCrown * kCrown - at * at));
        const double depth = std::max(kDeep - drop, 0.0), slip = (spin - 200.0) * 0.5 * drop;
        expected +=
            contact::slice_load(m.law[j], m.slicing.width, depth).load * kLinear * slip * slip;
      }
    }
    INFO("race " << j << ": heat " << heat[0] << " " << heat[1] << " " << heat[2] << " W, expected "
                 << expected);
    REQUIRE(expected > 1e-4);
    CHECK(heat[0] == Approx(expected).epsilon(1e-3));
    CHECK(heat[1] == Approx(expected).epsilon(2e-3));
    CHECK(heat[2] < 1e-4 * expected);
  }
}
