#include "contact/race_errors.hpp"
#include "contact/roller_race.hpp"
#include "core/dynamics/roller_scene.hpp"
#include "core/dynamics/wave_record.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <optional>

/// Rollers that move on races with geometric imperfections.
using namespace adore;
using bearing::RaceErrors;
using contact::AzimuthDirection;
using contact::RaceSurface;
using roller_scene::Scene;
using scene::Snapshot;
using scene::Vec3;

namespace {

/// Waves of the radius and all that the type of race can have.
RaceErrors errors_of(bool groove, bool oval) {
  RaceErrors e;
  e.roundness = oval ? RaceErrors::Roundness::Elliptical : RaceErrors::Roundness::Sinusoidal;
  e.variation = {1.5e-6, oval ? -1e-6 : 9.0, 0.4};
  if (groove) {
    e.curvature_factor = {0.002, 5.0, 0.7};
  } else {
    e.taper = {2e-4, 4.0, 0.3};
    e.land_offset = {2e-4, 3.0, 1.0};
  }
  return e;
}

}  // namespace

TEST_CASE("wavy races: the turning of the slices' energy is its derivative over the azimuth",
          "[unit][rollers][imperfections][jacobian]") {
  std::vector<contact::RollerSlice> shape;
  for (int k = 0; k < 11; ++k) shape.push_back({0.001 * (k - 5), 0.005 - 1e-7 * (k - 5) * (k - 5)});
  RaceSurface cone = contact::cone_race(0, 0.035, 0.2);
  cone.mid_x = 0.003;
  cone.mid_r = 0.035 - 0.003 * std::tan(0.2);
  cone.land_width = 0.0093;
  RaceSurface groove = contact::groove_race(1, 0.04, 0.002, 0.064);
  const RaceSurface crowned = contact::crowned_race(cone, 0.4, 0.003);
  for (RaceSurface race : {cone, groove, crowned}) {
    const bool is_groove = race.shape == RaceSurface::Shape::Groove;
    if (is_groove) {
      race.mid_x = 0.0;
      race.mid_r = 0.0241;
    }
    const contact::WavyRace wavy =
        contact::make_wavy_race(errors_of(is_groove, false), race, 0.035, 0.03);
    const double side = is_groove ? -1.0 : 1.0, tilt = is_groove ? 0.05 : -0.2;
    contact::RollerPose pose;
    pose.axes = contact::slice_axes(std::sin(tilt), 0.01);
    pose.x = 0.003;
    // Deep by 4 µm where it is deepest.
    const auto sums_at = [&](double psi, double r) {
      pose.r = r;
      const auto here = wavy.at({std::cos(psi), std::sin(psi)});
      const auto slices = contact::roller_race_slices(here.surface, shape, 1e-3, {3e10}, 2e11);
      return contact::roller_race_sums<double>(contact::view_of(slices), pose, nullptr, here.slope);
    };
    double r = is_groove ? 0.0241 + 0.006 : 0.035 - 0.006;
    while (!(sums_at(0.7, r).load > 200.0)) r += side * 1e-6;
    for (const double psi : {0.7, 2.1, 5.0}) {
      constexpr double h = 1e-6;
      const double slope = (sums_at(psi + h, r).energy - sums_at(psi - h, r).energy) / (2 * h);
      const auto sums = sums_at(psi, r);
      INFO((is_groove ? "groove" : "cone") << " at " << psi << ", load " << sums.load);
      CHECK(sums.turning == Approx(slope).margin(1e-6 * sums.energy));
      if (sums.energy > 0.0) CHECK(std::abs(slope) > 1e-3 * sums.energy);
    }
  }
}

TEST_CASE("rollers on wavy races: the ledger balances ever better",
          "[physics][rollers][imperfections][energy]") {
  for (bearing::Bearing b : {roller_bearings::cylindrical(3000.0), roller_bearings::tapered(3000.0),
                             roller_bearings::spherical(3000.0)}) {
    const bool groove = b.rollers()->groove_factor[0] > 0.0;
    roller_scene::add_friction(b);
    b.imperfections.race = {errors_of(groove, true), errors_of(groove, false)};
    INFO("type " << static_cast<int>(b.type));
    std::vector<double> residuals;
    double work = 0.0;
    for (const double tolerance : {1e-5, 1e-7}) {
      Scene s = roller_scene::scene_of(b, roller_scene::races_only(), 9);
      const auto run = fixture::run(s.system, s.system.initial_state(), 1e-3, tolerance, "rkf5");
      const Snapshot at = s.system.snapshot(1e-3, run.y);
      residuals.push_back(std::abs(at.energy.residual()));
      for (const auto& item : at.energy.items())
        if (item.term->kind == scene::LedgerKind::Work) work += std::abs(item.value);
    }
    CAPTURE(residuals[0], residuals[1], work);
    CHECK(residuals[1] < std::max(0.1 * residuals[0], 1e-9));
    CHECK(residuals[1] < 1e-4 * work);
    CHECK(work > 1e-5);
  }
}

TEST_CASE("rollers on wavy races: at rest the loads are those of the static solution",
          "[physics][rollers][imperfections]") {
  for (bearing::Bearing b : {roller_bearings::cylindrical(0.0), roller_bearings::tapered(0.0),
                             roller_bearings::spherical(0.0)}) {
    const bool groove = b.rollers()->groove_factor[0] > 0.0;
    b.imperfections.race = {errors_of(groove, false), errors_of(groove, true)};
    // Statics do not follow taper, land and curvature while the inner race moves over the rollers:
    // 1e-4 rad, which is up to 0.05 N on slices of 100 N.
    INFO("type " << static_cast<int>(b.type));
    Scene s = roller_scene::scene_of(b, roller_scene::races_only());
    const Snapshot at = s.system.snapshot(0.0, s.system.initial_state());
    const double load = s.rollers->solution.max_load;
    for (std::size_t i = 0; i < at.elements.size(); ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        const std::vector<double>& solved = s.rollers->solution.rollers[i].race[j].slice_load;
        REQUIRE(at.elements[i].race[j].slice_load.size() == solved.size());
        for (std::size_t k = 0; k < solved.size(); ++k)
          CHECK(at.elements[i].race[j].slice_load[k] == Approx(solved[k]).margin(2e-4 * load));
      }
    // Statics know the push of an oval; of the other waves, a changing taper or land, they do not.
    CHECK(at.races[1].applied_force[2] ==
          Approx(b.constraints.load[2]).epsilon(1e-3).margin(1e-3 * load));
  }
}

TEST_CASE("rollers on wavy races: amplitudes of zero change no bit",
          "[unit][rollers][imperfections]") {
  bearing::Bearing b = roller_bearings::cylindrical(3000.0);
  Scene perfect = roller_scene::scene_of(b, roller_scene::races_only(), 9);
  for (RaceErrors& e : b.imperfections.race) {
    e.roundness = RaceErrors::Roundness::Sinusoidal;
    e.variation = {0.0, 5.0, 1.0};
    e.taper = {0.0, 2.0, 0.0};
  }
  Scene wavy = roller_scene::scene_of(b, roller_scene::races_only(), 9);
  CHECK(fixture::run(perfect.system, perfect.system.initial_state(), 2e-4, 1e-6).y ==
        fixture::run(wavy.system, wavy.system.initial_state(), 2e-4, 1e-6).y);
}

TEST_CASE("rollers on a wavy race: turned by an angle it gives turned results",
          "[physics][rollers][imperfections][symmetry]") {
  bearing::Bearing b = roller_bearings::cylindrical(3000.0);
  roller_scene::add_friction(b);
  b.imperfections.race = {errors_of(false, true), errors_of(false, false)};
  const double angle = 0.7;
  bearing::Bearing turned = b;
  turned.constraints.load[1] = -std::sin(angle) * b.constraints.load[2];
  turned.constraints.load[2] = std::cos(angle) * b.constraints.load[2];
  for (RaceErrors& e : turned.imperfections.race) {
    if (e.roundness == RaceErrors::Roundness::Elliptical)
      e.variation[2] += angle;
    else
      e.variation[2] -= e.variation[1] * angle;
    for (bearing::Harmonic* wave : {&e.taper, &e.land_offset}) wave->phase -= wave->waves * angle;
  }
  const auto end_of = [&](const bearing::Bearing& of, double first) {
    Scene s = roller_scene::scene_of(of, roller_scene::races_only(), 9, first);
    return s.system.snapshot(
        5e-4, fixture::run(s.system, s.system.initial_state(), 5e-4, 1e-9, "rkf5").y);
  };
  const Snapshot a = end_of(b, 0.0), c = end_of(turned, angle);
  for (std::size_t i = 0; i < a.elements.size(); ++i) {
    CHECK(c.elements[i].theta - a.elements[i].theta == Approx(angle).margin(1e-8));
    CHECK(c.elements[i].r == Approx(a.elements[i].r).margin(1e-11));
    CHECK(c.elements[i].race[1].load == Approx(a.elements[i].race[1].load).margin(1e-3));
  }
}

namespace {

/// Rollers of any type preloaded between races that stand.
bearing::Bearing preloaded(bearing::Type type, int count) {
  using bearing::Type;
  constexpr double rpm = 12000.0;
  bearing::Bearing b = type == Type::Cylindrical ? roller_bearings::cylindrical(3000.0, -2e-5)
                       : type == Type::Tapered   ? roller_bearings::tapered(rpm)
                       : type == Type::Spherical ? roller_bearings::spherical(rpm, -2e-5)
                                                 : roller_bearings::spherical_tapered(rpm);
  b.rollers()->count = count;
  if (type == Type::Cylindrical) b.rollers()->flange = {};
  b.constraints.load.fill(0.0);
  b.constraints.displacement_given.fill(true);
  b.constraints.displacement.fill(0.0);
  if (type == Type::Tapered || type == Type::SphericalTapered) b.constraints.displacement[0] = 8e-5;
  roller_scene::add_friction(b);
  return b;
}

/// As of balls (test_wavy_races.cpp): an inner race of n = qZ + p waves pushes at qZ(Ω - Ω_c), of
/// the radial force turned by p times the race, an outer one at qZ Ω_c; p = ±1 the radial force, p
/// = 0 that along the axis, which cylinders have none of, other p none. Of inclined rollers what
/// the waves add: they find their skew on the way, which moves the force along the axis by 1e-3.
void check_orders(bearing::Type type, std::initializer_list<int> waves) {
  using namespace wave_record;
  constexpr int Z = 8;
  constexpr double amplitude = 2e-7;
  bearing::Bearing b = preloaded(type, Z);
  const bool inclined = b.rollers()->race_angle[1] > 0.0;
  const auto record = [&] {
    using enum scene::Effect;
    Scene s =
        roller_scene::scene_of(b,
                               roller_scene::plan_of({RaceContact, RaceTraction, FlangeContact,
                                                      FlangeTraction, ElementBalance}),
                               9);
    return record_of(s.system, inclined ? 2.0 : 4.0);
  };
  const std::optional<Record> perfect = inclined ? std::optional(record()) : std::nullopt;
  for (const int race : {0, 1}) {
    double line = 0.0, along = 0.0;
    for (const int n : waves) {
      RaceErrors e;
      e.roundness = RaceErrors::Roundness::Sinusoidal;
      e.variation = {amplitude, static_cast<double>(n), 0.0};
      b.imperfections.race = {};
      b.imperfections.race[static_cast<std::size_t>(race)] = e;
      Record r = record();
      for (std::size_t k = 0; perfect && k < r.axial.size(); ++k) {
        r.axial[k] -= perfect->axial[k];
        r.radial[k] -= perfect->radial[k];
      }
      const double passing = race == 0 ? r.cage : r.shaft - r.cage;
      const int q = (n + 2) / Z, p = n - q * Z;
      const auto radial = about_mean(r.radial);
      const auto axial = about_mean(r.axial);
      const double turned = race == 0 ? 0.0 : p * r.shaft;
      const double peak =
          std::sqrt(std::max(Record::power(radial, r.step, q * Z * passing + turned),
                             Record::power(radial, r.step, -(q * Z * passing + turned))));
      const double axial_peak =
          std::sqrt(2.0 * Record::power(axial, r.step, q * Z * passing));  // rms of both signs
      INFO("type " << static_cast<int>(type) << ", race " << race << ", " << n << " waves: radial "
                   << peak << " of " << rms(radial) << " N, axial " << axial_peak << " of "
                   << rms(axial) << " N");
      line = std::max(line, peak);
      REQUIRE(line > 1.0);
      if (p == 1 || p == -1)
        CHECK(peak == Approx(rms(radial)).epsilon(0.05));
      else
        CHECK(rms(radial) < 0.02 * line);
      if (p == 0 && inclined) {
        along = axial_peak;
        CHECK(along > 0.1 * line);
        CHECK(axial_peak == Approx(rms(axial)).epsilon(0.05));
      } else {
        CHECK(rms(axial) < 0.02 * line);
      }
    }
    CHECK((along > 0.0) == inclined);
  }
}

}  // namespace

TEST_CASE("rollers on wavy races: the race's force shows the textbook orders and nothing else",
          "[physics][rollers][imperfections][slow][nightly]") {
  check_orders(bearing::Type::Cylindrical, {7, 9, 8, 5});
}
TEST_CASE("cones on wavy races: the race's force shows the textbook orders and nothing else",
          "[physics][rollers][imperfections][slow]") {
  check_orders(bearing::Type::Tapered, {9, 8, 5});
}
TEST_CASE("barrels on wavy races: the race's force shows the textbook orders and nothing else",
          "[physics][rollers][imperfections][slow]") {
  check_orders(bearing::Type::Spherical, {9, 8, 5});
}
TEST_CASE(
    "barrels of cones on wavy races: the race's force shows the textbook orders and nothing "
    "else",
    "[physics][rollers][imperfections][slow][nightly]") {
  check_orders(bearing::Type::SphericalTapered, {9, 8, 5});
}
