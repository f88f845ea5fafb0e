#include "base/errors.hpp"
#include "thermal/assembly.hpp"
#include "thermal/ring.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace adore::thermal;

namespace {

const Elastic kSteel{207e9, 0.3, 7810.0};
const Elastic kAluminium{70e9, 0.33, 2700.0};

/// A cold, still inner ring on a shaft and outer ring in a housing.
MountedRings cold_rings() {
  MountedRings rings;
  rings.shaft = {kSteel, 0.010, 0.020};
  rings.inner = {kSteel, 0.020, 0.0236};
  rings.outer = {kSteel, 0.0364, 0.040};
  rings.housing = {kAluminium, 0.040, 0.060};
  return rings;
}

}  // namespace

TEST_CASE("press fit: surfaces meet where the interference was", "[physics][fit]") {
  const double a = 0.01, c = 0.025, b = 0.032, interference = 24e-6;
  const double p = fit_pressure(a, c, b, kSteel, kAluminium, interference);
  REQUIRE(p > 0.0);
  const double bore = pressure_displacement(c, c, b, kAluminium, p, 0.0);
  const double outside = pressure_displacement(c, a, c, kSteel, 0.0, p);
  CHECK(2.0 * (bore - outside) == Approx(interference).epsilon(1e-13));  // compatibility, rounding
  // Hooke's law at the bore of the outer part: u = r (σ_t - ν σ_r)/E with σ_r = -p.
  const double hoop = pressure_hoop_stress(c, c, b, p, 0.0);
  CHECK(bore == Approx(c / kAluminium.E * (hoop + kAluminium.nu * p)).epsilon(1e-12));
}

TEST_CASE("press fit: loose fit and part without wall → no pressure", "[unit][fit]") {
  CHECK(fit_pressure(0.01, 0.02, 0.03, kSteel, kSteel, -1e-6) == 0.0);
  CHECK(fit_pressure(0.01, 0.02, 0.03, kSteel, kSteel, 0.0) == 0.0);
  CHECK(fit_pressure(0.01, 0.02, 0.0, kSteel, kSteel, 1e-5) == 0.0);
  CHECK(fit_pressure(0.02, 0.02, 0.03, kSteel, kSteel, 1e-5) == 0.0);
}

TEST_CASE("thin rings: membrane stress p r/t and spinning hoop rho w^2 r^2", "[physics][fit]") {
  const double r = 0.05, w = 1000.0, p = 1e6;
  double last = 1.0;
  for (const double t : {1e-3, 1e-4, 1e-5}) {
    const double hoop = pressure_hoop_stress(r, r, r + t, p, 0.0);
    const double error = std::abs(hoop * t / (p * r) - 1.0);
    CHECK(error < t / r);  // the membrane is the leading term of an expansion in t/r
    CHECK(error < last);
    last = error;
    CHECK(pressure_displacement(r, r, r + t, kSteel, p, 0.0) ==
          Approx(p * r * r / (kSteel.E * t)).epsilon(2.0 * t / r));
    CHECK(centrifugal_hoop_stress(r, r, r + t, kSteel, w) ==
          Approx(kSteel.rho * w * w * r * r).epsilon(2.0 * t / r));
    CHECK(centrifugal_displacement(r, r, r + t, kSteel, w) ==
          Approx(kSteel.rho * w * w * r * r * r / kSteel.E).epsilon(2.0 * t / r));
  }
}

TEST_CASE("ring: pinhole in a solid shaft → outside unchanged, hoop stress doubled",
          "[physics][fit]") {
  const double b = 0.02, hole = 1e-7, p = 1e7, w = 3000.0;
  // The hole changes the displacement by terms of order (a/b)^2 = 2.5e-11.
  CHECK(pressure_displacement(b, hole, b, kSteel, 0.0, p) ==
        Approx(pressure_displacement(b, 0.0, b, kSteel, 0.0, p)).epsilon(1e-9));
  CHECK(centrifugal_displacement(b, hole, b, kSteel, w) ==
        Approx(centrifugal_displacement(b, 0.0, b, kSteel, w)).epsilon(1e-9));
  CHECK(pressure_hoop_stress(hole, hole, b, 0.0, p) ==
        Approx(2.0 * pressure_hoop_stress(0.0, 0.0, b, 0.0, p)).epsilon(1e-9));
  CHECK(centrifugal_hoop_stress(hole, hole, b, kSteel, w) ==
        Approx(2.0 * centrifugal_hoop_stress(0.0, 0.0, b, kSteel, w)).epsilon(1e-9));
  CHECK(fit_pressure(hole, b, 0.03, kSteel, kSteel, 1e-5) ==
        Approx(fit_pressure(0.0, b, 0.03, kSteel, kSteel, 1e-5)).epsilon(1e-9));
}

TEST_CASE("ring: spinning → in equilibrium, and stresses follow strains", "[physics][growth]") {
  const double a = 0.03, b = 0.05, w = -2500.0, h = 1e-6;
  CHECK(centrifugal_radial_stress(a, a, b, kSteel, w) == Approx(0.0).margin(1e-6));  // free surface
  CHECK(centrifugal_radial_stress(b, a, b, kSteel, w) == Approx(0.0).margin(1e-6));
  for (const double r : {0.031, 0.04, 0.049}) {
    const auto s_r = [&](double x) { return centrifugal_radial_stress(x, a, b, kSteel, w); };
    const double s_t = centrifugal_hoop_stress(r, a, b, kSteel, w);
    const double slope = ((r + h) * s_r(r + h) - (r - h) * s_r(r - h)) / (2.0 * h);
    // d(r s_r)/dr - s_t + rho w^2 r^2 = 0; central difference: error ~ h^2 s''' and rounding/h
    CHECK(slope - s_t + kSteel.rho * w * w * r * r == Approx(0.0).margin(1e-6 * s_t));
    CHECK(centrifugal_displacement(r, a, b, kSteel, w) ==
          Approx(r / kSteel.E * (s_t - kSteel.nu * s_r(r))).epsilon(1e-12));
  }
}

TEST_CASE("ring: mean temperature = area mean of the logarithmic profile", "[physics][growth]") {
  const double a = 0.04, b = 0.055, Ta = 400.0, Tb = 350.0;
  double sum = 0.0;
  const int n = 20000;  // midpoint rule: error ~ n^-2
  for (int i = 0; i < n; ++i) {
    const double r = a + (b - a) * (i + 0.5) / n;
    sum += (Ta + (Tb - Ta) * std::log(r / a) / std::log(b / a)) * 2.0 * r * (b - a) / n;
  }
  CHECK(mean_ring_temperature(a, b, Ta, Tb) == Approx(sum / (b * b - a * a)).epsilon(1e-9));
}

TEST_CASE("press fit: widens the inner raceway and narrows the outer; speed loosens the shaft fit",
          "[physics][fit]") {
  MountedRings rings = cold_rings();
  rings.fit = {20e-6, 20e-6};
  const MountedState tight = mount(rings);
  CHECK(tight.pressure[0] > 0.0);
  CHECK(tight.race_displacement(0, rings.outer.inner) < 0.0);
  CHECK(tight.race_displacement(1, rings.inner.outer) > 0.0);
  CHECK(tight.race_hoop_stress(0) < 0.0);  // the housing squeezes, the shaft stretches
  CHECK(tight.race_hoop_stress(1) > 0.0);
  double last = tight.interference[1];
  for (const double speed : {1000.0, 3000.0, 6000.0}) {
    rings.inner.speed = rings.shaft.speed = speed;
    const MountedState state = mount(rings);
    CHECK(state.interference[1] < last);
    CHECK(state.interference[0] == tight.interference[0]);
    last = state.interference[1];
    CHECK(mount(at_rest(rings)).pressure == tight.pressure);
  }
}

TEST_CASE("rollers: radial clearance, sizes and the axial setting of cones", "[physics][rollers]") {
  MountedRings rings = cold_rings();
  const RollerSizes free{0.0128, 0.014, 0.5, 0.060, 40e-6};
  const RollerOperatingGeometry still = roller_operating_geometry(mount(rings), free, 0.0, 0.0);
  CHECK(still.geometry.clearance == free.clearance);  // nothing moves: not a bit changes
  CHECK(still.geometry.diameter == free.diameter);
  CHECK(still.geometry.pitch_diameter == free.pitch_diameter);
  CHECK(still.axial_setting_change == 0.0);

  rings.fit[1] = 30e-6;
  const double half_angle = 0.25, g = 1.2e-3;
  const RollerOperatingGeometry warm = roller_operating_geometry(mount(rings), free, g, half_angle);
  const double u = mount(rings).race_displacement(1, rings.inner.outer);
  CHECK(warm.raceway_displacement[1] == u);
  CHECK(warm.geometry.diameter == Approx(free.diameter * (1.0 + g)).epsilon(1e-15));
  CHECK(warm.geometry.length == Approx(free.length * (1.0 + g)).epsilon(1e-15));
  const double lost = 2.0 * u + 2.0 * free.diameter * g;
  CHECK(warm.geometry.clearance == Approx(free.clearance - lost).epsilon(1e-12));
  CHECK(warm.axial_setting_change == Approx(0.5 * lost / std::tan(half_angle)).epsilon(1e-12));
  CHECK_THROWS_AS(tapered_setting_change(1e-5, 0.0), adore::InputError);
}

TEST_CASE(
    "cage clearance: opened by the race, closed by the cage; segments have no centrifugal growth",
    "[physics][cage]") {
  CHECK(land_clearance(0, 0.0332, 2e-6, 0.033, 5e-6) == Approx(2.0 * (2e-4 - 3e-6)).epsilon(1e-12));
  CHECK(land_clearance(1, 0.0288, 2e-6, 0.029, 5e-6) == Approx(2.0 * (2e-4 + 3e-6)).epsilon(1e-12));
  const RingPart cage{{3e9, 0.35, 1150.0}, 0.029, 0.033, 5e-4, 900.0};
  CHECK(cage_displacement(cage, 0.033, false) == 0.033 * 5e-4);
  CHECK(cage_displacement(cage, 0.033, true) > 0.033 * 5e-4);
  CHECK(pocket_clearance(2e-4, 0.0127, 0.0, 0.0) == 2e-4);
  CHECK(pocket_clearance(2e-4, 0.0127, 1e-3, 1e-3) == Approx(2e-4 * 1.001).epsilon(1e-14));
}

TEST_CASE("shim: needs a groove wider than the ball", "[unit][fit]") {
  CHECK_THROWS_AS(split_race(0.0065405, 0.0127, 0.0004, 3e-5, 4.4e-4), adore::InputError);
  CHECK_THROWS_AS(split_race(0.0065405, 0.0127, -1e-6, 3e-5, 4.4e-4), adore::InputError);
  const SplitRace plain = split_race(0.0065405, 0.0127, 0.0, 3e-5, 4.4e-4);
  CHECK(plain.clearance == 3e-5);
  CHECK(std::cos(plain.contact_angle) == Approx(1.0 - 3e-5 / (2.0 * 4.4e-4)).epsilon(1e-14));
}
