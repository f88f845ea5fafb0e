#include "contact/roller_race.hpp"
#include "core/statics/roller_bearings.hpp"
#include "statics/friction.hpp"
#include "statics/roller_friction.hpp"
#include "statics/roller_model.hpp"
#include "statics/stiffness_difference.hpp"
#include "tribology/traction_curve.hpp"
#include "tribology/traction_law.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

/// Rollers of an equilibrium in balance of friction (statics/roller_friction.hpp).
using namespace adore;
using statics::RollerOptions;
using statics::RollerSolution;
using statics::StaticRoller;

namespace {

/// Largest coefficient on races and flanges, reached over some cm/s.
bearing::Bearing with_friction(bearing::Bearing b, double race, double flange) {
  const auto curve = [](double kappa) {
    return kappa > 0.0 ? tribology::traction_curve(2, {0.0, kappa, 30.0 * kappa, 0.0})
                       : bearing::TractionCurve{};
  };
  b.race_traction = curve(race);
  b.flange_traction = curve(flange);
  return b;
}

RollerSolution solved(const bearing::Bearing& b, bool friction = true, double difference = 0.0) {
  RollerOptions options;
  options.friction_balance = friction;
  options.difference_share = difference;
  return statics::solve_roller_statics(b, options);
}

double largest_skew(const RollerSolution& s) {
  double out = 0.0;
  for (const StaticRoller& r : s.rollers) out = std::max(out, std::abs(r.skew));
  return out;
}

/// Largest difference of contact loads over the largest load.
double difference(const RollerSolution& a, const RollerSolution& b) {
  double out = 0.0;
  for (std::size_t k = 0; k < a.rollers.size(); ++k)
    for (std::size_t j = 0; j < 2; ++j)
      out = std::max(out, std::abs(a.rollers[k].race[j].load - b.rollers[k].race[j].load));
  return out / a.max_load;
}

/// All that races and flanges do to a roller of a solution, in its azimuth frame (x, y, z) with z
/// outwards, and the power that both races put in: of double slices, one after another.
struct Wrench {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< about its middle
  double power = 0.0;
  std::array<Vec3, 2> by_race{Vec3::Zero(), Vec3::Zero()};
};
Wrench wrench_on(const bearing::Bearing& b, const RollerSolution& s, std::size_t k) {
  const statics::RollerModel model = statics::make_roller_model(b, {});
  const StaticRoller& roller = s.rollers[k];
  const double c = std::cos(roller.azimuth), sn = std::sin(roller.azimuth);
  Mat3 to_frame;  // rows x, y, z
  to_frame << 1.0, 0.0, 0.0, 0.0, c, sn, 0.0, -sn, c;
  const Vec3 C(roller.x, 0.0, roller.r);
  const Vec3 a(std::cos(roller.tilt) * std::cos(roller.skew), std::sin(roller.skew),
               std::sin(roller.tilt) * std::cos(roller.skew));
  const contact::RigidMotion motion{C, roller.orbital_speed * Vec3::UnitX().cross(C),
                                    roller.orbital_speed * Vec3::UnitX() + roller.spin_speed * a};
  Wrench out;
  for (std::size_t j = 0; j < 2; ++j) {
    contact::RacePose pose;
    if (j == 1)
      pose.centre = to_frame * Vec3(s.displacement[0], s.displacement[1], s.displacement[2]);
    const contact::RigidMotion race{pose.centre, Vec3::Zero(), b.speed[j] * Vec3::UnitX()};
    const tribology::TractionLaw law = b.race_traction;
    const auto slices = contact::roller_race_slices(
        model.race[j], model.bodies[0].slices, model.slicing.width, model.law[j], model.E_star[j]);
    law.visit_regularized([&](const auto& rounded) {
      const contact::RollerRaceAction on =
          contact::roller_race_action<double>(slices, pose, race, C, a, motion, rounded);
      out.force += on.force;
      out.moment += on.moment;
      out.power -= on.race_moment.dot(race.omega);
      out.by_race[j] += on.force;
    });
    const contact::RollerInMeridian in = contact::roller_in_meridian(pose, race, C, a, motion);
    const auto back = [&](const Vec3& v) { return in.back(pose, {v[0], v[1], v[2]}); };
    const auto& axis = in.roller.axes.a;
    for (const statics::FlangeEndPair& pair : model.bodies[0].flanges) {
      if (pair.race != static_cast<int>(j)) continue;
      const contact::FlangeContact touch = contact::flange_contact(
          pair.face, pair.end, Vec3(in.roller.x, 0.0, in.roller.r), Vec3(axis.x, axis.y, axis.z));
      if (!(touch.gap < 0.0)) continue;
      const double load = touch.steepness * contact::hertz_load(pair.K, -touch.gap);
      contact::ContactWrench one;
      const Vec3 X = pose.centre + back(touch.point), n = back(touch.normal);
      const Vec3 slip = contact::contact_slip(race, motion, X, n);
      const tribology::TractionLaw on_flange = *b.flange_traction;
      on_flange.visit_regularized(
          [&](const auto& rounded) { contact::add_contact(one, load, X, -n, slip, C, rounded); });
      out.force += one.force;
      out.moment += one.moment;
      out.power += (X - pose.centre).cross(one.force).dot(race.omega);
      out.by_race[j] += one.force;
    }
  }
  return out;
}

bearing::Bearing under_thrust(bearing::Bearing b) {
  b.constraints.load = {4000.0, 0.0, 0.0, 0.0, 0.0};
  return b;
}

bearing::Bearing flanged_cylindrical() {
  bearing::Bearing b = roller_bearings::cylindrical(3000.0);
  b.rollers()->flange[1][0] = bearing::Flange{0.5 * roller_bearings::kDegree, 0.0015};
  b.rollers()->flange_play = {5e-5, 0.0};
  b.constraints.displacement_given[0] = false;
  b.constraints.load[0] = 300.0;
  return b;
}

}  // namespace

TEST_CASE("roller friction: forces, moments and power of each roller are in balance",
          "[physics][rollers][friction]") {
  const std::array bearings{roller_bearings::tapered(3000.0),
                            roller_bearings::spherical_tapered(3000.0), flanged_cylindrical(),
                            under_thrust(roller_bearings::tapered(3000.0)),
                            under_thrust(roller_bearings::spherical_tapered(3000.0))};
  for (std::size_t number = 0; number < bearings.size(); ++number) {
    CAPTURE(number);
    const bearing::Bearing b = with_friction(bearings[number], 0.06, 0.08);
    const RollerSolution s = solved(b);
    REQUIRE(s.friction.findings().empty());
    CHECK(largest_skew(s) > 1e-5);
    const double R = 0.5 * b.element_diameter(), m = s.roller_mass;
    Vec3 on_race = Vec3::Zero();
    for (std::size_t k = 0; k < s.rollers.size(); ++k) {
      const StaticRoller& roller = s.rollers[k];
      if (!roller.balanced) continue;
      CAPTURE(k);
      const Wrench w = wrench_on(b, s, k);
      const Vec3 a(std::cos(roller.tilt) * std::cos(roller.skew), std::sin(roller.skew),
                   std::sin(roller.tilt) * std::cos(roller.skew));
      const Vec3 from_C = s.mass_offset * a, G = Vec3(roller.x, 0.0, roller.r) + from_C;
      const double W = roller.orbital_speed, along = b.element_inertia.moments.x(),
                   across = b.element_inertia.moments.y();
      const Vec3 omega = W * Vec3::UnitX() + roller.spin_speed * a;
      const Vec3 H = across * omega + (along - across) * omega.dot(a) * a;
      const Vec3 force = w.force + m * W * W * Vec3(0.0, G[1], G[2]);
      const Vec3 moment = w.moment - from_C.cross(w.force) - W * Vec3::UnitX().cross(H);
      CHECK(force.norm() < 1e-7 * s.max_load);
      CHECK(moment.norm() < 1e-7 * s.max_load * R);
      const double heat = roller.heat.traction[0] + roller.heat.traction[1] +
                          roller.heat.flange[0] + roller.heat.flange[1];
      // Steady where all are alike: what the races put in is the heat.
      if (number > 2) CHECK(w.power == Approx(heat).epsilon(1e-6));
      const double c = std::cos(roller.azimuth), sn = std::sin(roller.azimuth);
      on_race += Vec3(w.by_race[1][0], c * w.by_race[1][1] - sn * w.by_race[1][2],
                      sn * w.by_race[1][1] + c * w.by_race[1][2]);
    }
    if (number > 2)
      for (Eigen::Index i = 0; i < 3; ++i)
        CHECK(on_race[i] ==
              Approx(b.constraints.load[static_cast<std::size_t>(i)]).margin(1e-6 * s.max_load));
  }
}

TEST_CASE("roller friction: loads tend to those without friction, in proportion to the coefficient",
          "[physics][rollers][friction]") {
  // Under radial load each roller needs friction of 1e-4 of its load to pass the displaced race.
  const bearing::Bearing b = under_thrust(roller_bearings::tapered(3000.0));
  const RollerSolution none = solved(with_friction(b, 0.0, 0.0));
  CHECK_FALSE(none.friction.computed);
  CHECK(difference(none, solved(b, false)) == 0.0);
  const RollerSolution small = solved(with_friction(b, 1e-2, 1e-2)),
                       smaller = solved(with_friction(b, 1e-3, 1e-3));
  REQUIRE(small.friction.findings().empty());
  REQUIRE(smaller.friction.findings().empty());
  const double far = difference(none, small), near = difference(none, smaller);
  INFO("differences " << far << ", " << near);
  CHECK(far < 0.02);
  CHECK(far > 5.0 * near);
}

TEST_CASE("roller friction: too little to pass the displaced race → no skew there, with a note",
          "[physics][rollers][friction]") {
  const bearing::Bearing b = roller_bearings::tapered(3000.0);
  const RollerSolution none = solved(b, false), weak = solved(with_friction(b, 1e-5, 1e-5));
  REQUIRE_FALSE(weak.friction.left.empty());
  CHECK(weak.friction.findings().at(0).message.find("no stable friction equilibrium") !=
        std::string::npos);
  for (const std::size_t k : weak.friction.left) {
    CHECK_FALSE(weak.rollers[k].balanced);
    CHECK(weak.rollers[k].skew == 0.0);
  }
  CHECK(difference(none, weak) < 1e-4);
}

TEST_CASE("roller friction: skew follows the friction of the rib and the sense of rotation",
          "[physics][rollers][friction]") {
  bearing::Bearing b = under_thrust(roller_bearings::tapered(3000.0));
  const RollerSolution rib = solved(with_friction(b, 0.06, 0.08)),
                       half = solved(with_friction(b, 0.06, 0.04)),
                       smooth = solved(with_friction(b, 0.06, 0.0));
  CHECK(largest_skew(rib) > 1.2 * largest_skew(half));
  CHECK(largest_skew(half) > 1.2 * largest_skew(smooth));
  for (const StaticRoller& roller : rib.rollers)
    CHECK(roller.skew == Approx(rib.rollers[0].skew).epsilon(1e-6));
  b.speed[1] = -b.speed[1];
  const RollerSolution back = solved(with_friction(b, 0.06, 0.08));
  CHECK(back.rollers[0].skew == Approx(-rib.rollers[0].skew).epsilon(1e-6));
  CHECK(back.displacement[0] == Approx(rib.displacement[0]).epsilon(1e-8));
}

TEST_CASE("roller friction: stiffness is that of displaced equilibria",
          "[physics][rollers][friction]") {
  const bearing::Bearing b = with_friction(roller_bearings::tapered(3000.0), 0.06, 0.08);
  const RollerSolution s = solved(b, true, 1e-3);
  REQUIRE(s.stiffness_by_difference);
  CHECK(statics::stiffness_disagreement(s.stiffness, *s.stiffness_by_difference) < 1e-3);
  CHECK(statics::stiffness_disagreement(s.stiffness, solved(b, false).stiffness) > 1e-3);
}

TEST_CASE("roller friction: heat of the estimate is that of the balance",
          "[physics][rollers][friction]") {
  const bearing::Bearing b = with_friction(roller_bearings::tapered(3000.0), 0.06, 0.08);
  const RollerSolution s = solved(b);
  const statics::FrictionEstimate estimate = statics::friction_estimate(b, s);
  double race = 0.0, flange = 0.0;
  for (const StaticRoller& roller : s.rollers) {
    if (!roller.balanced) continue;
    race += roller.heat.traction[0];
    flange += roller.heat.flange[1];
  }
  CHECK(race > 0.0);
  CHECK(flange > 0.0);
  const bool all = std::all_of(s.rollers.begin(), s.rollers.end(), [](const StaticRoller& r) {
    return r.balanced || r.race[1].load == 0.0;
  });
  CHECK(all);
  CHECK(estimate.of_race(0).total() == Approx(race).epsilon(0.02));
  CHECK(estimate.flange[1] == Approx(flange).epsilon(0.02));
}
