#include "../statics/roller_bearings.hpp"
#include "base/errors.hpp"
#include "bearing/material_laws.hpp"
#include "contact/groove.hpp"
#include "deck/reader.hpp"
#include "setup/build_bearing.hpp"
#include "statics/ball_statics.hpp"
#include "support/paths.hpp"
#include "thermal/operating.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace adore;
using bearing::Bearing;

namespace {

/// The example ball bearing with its cage: 7208, 12 balls, 10000 rpm, at room temperature, no fits.
Bearing example() {
  const deck::ReadResult read =
      deck::read_deck(adore::test::source_dir().string() + "/resources/decks/ball.txt");
  REQUIRE(read.ok());
  return setup::build_bearing(read.deck);
}

Bearing example_at_rest() {
  Bearing b = example();
  b.speed = {0.0, 0.0};
  return b;
}

void set_temperature(Bearing& b, double T) {
  b.race_temperature = {T, T};
  b.element_temperature = b.cage_temperature = T;
  b.mounting.housing_temperature = b.mounting.shaft_temperature = T;
}

void one_material(Bearing& b) {
  const bearing::Material steel = bearing::material_from_table(100, bearing::Part::Cage);
  b.element_material = steel;
  b.race_material = {steel, steel};
  b.mounting.housing = b.mounting.shaft = steel;
  b.cage->material = steel;
}

void check_same_geometry(const Bearing& a, const Bearing& b) {
  CHECK(a.balls().diameter == b.balls().diameter);
  CHECK(a.balls().pitch_diameter == b.balls().pitch_diameter);
  CHECK(a.balls().contact_angle == b.balls().contact_angle);
  CHECK(a.balls().clearance == b.balls().clearance);
  CHECK(a.balls().groove_factor == b.balls().groove_factor);
  CHECK(a.balls().shoulder_diameter == b.balls().shoulder_diameter);
  CHECK(a.element_inertia.moments == b.element_inertia.moments);
  CHECK(a.race_inertia[1].moments == b.race_inertia[1].moments);
  REQUIRE((a.cage && b.cage));
  CHECK(a.cage->outer_diameter == b.cage->outer_diameter);
  CHECK(a.cage->pocket_clearance_1 == b.cage->pocket_clearance_1);
  CHECK(a.cage->clearance_inner == b.cage->clearance_inner);
  CHECK(a.cage->inertia.moments == b.cage->inertia.moments);
  REQUIRE(a.cage->lands.size() == b.cage->lands.size());
  for (std::size_t i = 0; i < a.cage->lands.size(); ++i) {
    CHECK(a.cage->lands[i].clearance == b.cage->lands[i].clearance);
    CHECK(a.cage->lands[i].diameter == b.cage->lands[i].diameter);
    CHECK(a.cage->lands[i].edge == b.cage->lands[i].edge);
  }
}

bool warns(const Bearing& b, const std::string& part) {
  for (const adore::Finding& one : b.operating->warnings)
    if (one.message.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("operating bearing: room temperature, rest, no fit → geometry reproduced bit by bit",
          "[unit][operating]") {
  const Bearing rest = example_at_rest();
  check_same_geometry(thermal::operating_bearing(rest), rest);
  CHECK_FALSE(thermal::operating_bearing(rest).operating->changed);
  Bearing loose = rest;  // a clearance fit presses on nothing
  loose.mounting.fit = {-20e-6, -5e-6};
  check_same_geometry(thermal::operating_bearing(loose), rest);
  Bearing rigid = example();  // speeds, but their growth left out
  rigid.mounting.centrifugal_growth = false;
  check_same_geometry(thermal::operating_bearing(rigid), rigid);
  Bearing hot_room = rest;
  hot_room.room_temperature = 320.0;
  set_temperature(hot_room, 320.0);
  check_same_geometry(thermal::operating_bearing(hot_room), rest);
  CHECK_THROWS_AS(thermal::operating_bearing(thermal::operating_bearing(rest)), InternalError);
}

TEST_CASE(
    "operating bearing: one material, one temperature → lengths scale, contact angle unchanged",
    "[physics][operating]") {
  Bearing b = example_at_rest();
  one_material(b);
  set_temperature(b, 393.15);
  const double g = 1.19e-5 * 100.0;
  const Bearing warm = thermal::operating_bearing(b);
  const auto scaled = [&](double value) { return Approx(value * (1.0 + g)).epsilon(1e-12); };
  CHECK(warm.operating->changed);
  CHECK(warm.balls().diameter == scaled(b.balls().diameter));
  CHECK(warm.balls().pitch_diameter == scaled(b.balls().pitch_diameter));
  CHECK(warm.balls().clearance == scaled(b.balls().clearance));
  CHECK(warm.balls().contact_angle == Approx(b.balls().contact_angle).epsilon(1e-12));
  CHECK(warm.balls().groove_factor[0] == Approx(b.balls().groove_factor[0]).epsilon(1e-14));
  CHECK(warm.balls().shoulder_diameter[0] == scaled(b.balls().shoulder_diameter[0]));
  CHECK(warm.cage->outer_diameter == scaled(b.cage->outer_diameter));
  CHECK(warm.cage->pocket_clearance_1 == scaled(b.cage->pocket_clearance_1));
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(warm.cage->lands[i].clearance == scaled(b.cage->lands[i].clearance));
  CHECK(warm.element_inertia.mass == b.element_inertia.mass);  // mass stays, inertia follows D^2
  CHECK(warm.element_inertia.moments[0] ==
        Approx(b.element_inertia.moments[0] * (1.0 + g) * (1.0 + g)).epsilon(1e-14));
}

TEST_CASE("operating bearing: groove centers of statics are on the moved circles",
          "[physics][operating]") {
  Bearing b = example();
  b.mounting.fit = {8e-6, 18e-6};
  b.race_temperature = {340.0, 352.0};
  b.element_temperature = 355.0;
  b.mounting.shaft_temperature = 345.0;
  b.mounting.housing_temperature = 325.0;
  for (const double inner : {352.0, 500.0}) {  // with play, and so hot inside that it is preloaded
    b.race_temperature[1] = inner;
    const Bearing warm = thermal::operating_bearing(b);
    CHECK((warm.balls().contact_angle > 0.0) == (inner < 400.0));
    const contact::GrooveGeometry groove = contact::groove_geometry(warm.balls());
    const bearing::OperatingFits& fits = *warm.operating;
    for (std::size_t j = 0; j < 2; ++j) {
      CHECK(groove.centre_radius[j] == Approx(fits.locus[j]).epsilon(1e-14));
      // The groove bottom, reached from its own center, is the raceway moved by its growth.
      const double bottom =
          groove.centre_radius[j] + (j == 0 ? 1.0 : -1.0) * groove.groove_radius[j];
      CHECK(bottom == Approx(fits.raceway_radius[j] + fits.raceway[j].total()).epsilon(1e-14));
    }
    // Clearance measured between the raceways.
    const double gap = 2.0 * (fits.raceway_radius[0] + fits.raceway[0].total() -
                              fits.raceway_radius[1] - fits.raceway[1].total()) -
                       2.0 * warm.balls().diameter;
    CHECK(gap ==
          Approx(warm.balls().clearance).margin(1e-15));  // differences of 0.03 m: 1e-17 each
  }
}

TEST_CASE("operating bearing: ceramic balls in warm steel → larger clearance",
          "[physics][operating]") {
  Bearing b = example_at_rest();
  one_material(b);
  set_temperature(b, 400.0);
  const Bearing steel = thermal::operating_bearing(b);
  b.element_material = bearing::material_from_table(150, bearing::Part::RollingElement);
  const Bearing hybrid = thermal::operating_bearing(b);
  const double saved =
      2.0 * b.balls().diameter *
      (b.race_material[0].thermal_expansion - b.element_material.thermal_expansion) *
      (400.0 - 293.15);
  CHECK(saved > 1e-6);
  CHECK(hybrid.balls().clearance - steel.balls().clearance == Approx(saved).epsilon(1e-9));
  CHECK(hybrid.balls().contact_angle > steel.balls().contact_angle);
  CHECK(hybrid.cage->pocket_clearance_1 > steel.cage->pocket_clearance_1);
}

TEST_CASE("operating bearing: speed reduces clearance with its square", "[physics][operating]") {
  Bearing b = example();
  const double cold = b.balls().clearance;
  const double at_10000 = cold - thermal::operating_bearing(b).balls().clearance;
  b.speed[1] *= -2.0;  // either direction
  const double at_20000 = cold - thermal::operating_bearing(b).balls().clearance;
  CHECK(at_10000 > 1e-7);
  CHECK(at_20000 ==
        Approx(4.0 * at_10000).epsilon(1e-9));  // difference of numbers 100 times larger
}

TEST_CASE("operating bearing: fits reduce clearance; loose and broken parts are reported",
          "[physics][operating]") {
  Bearing b = example_at_rest();
  b.mounting.fit = {10e-6, 15e-6};
  const Bearing fitted = thermal::operating_bearing(b);
  const bearing::OperatingFits& fits = *fitted.operating;
  CHECK(fits.warnings.empty());
  CHECK(fits.mounted.clearance == fits.operating.clearance);  // cold and at rest
  CHECK(fits.mounted.clearance < b.balls().clearance);
  CHECK(fits.fit[1].pressure == fits.fit[1].mounted_pressure);
  CHECK(fits.operating.contact_angle == fitted.balls().contact_angle);

  Bearing fast = b;
  fast.mounting.fit = {0.0, 2e-6};
  fast.speed[1] = 6000.0;
  CHECK(warns(thermal::operating_bearing(fast), "inner race comes loose from the shaft"));
  Bearing tight = b;
  tight.mounting.fit = {60e-6, 110e-6};
  const Bearing preloaded = thermal::operating_bearing(tight);
  CHECK(preloaded.balls().clearance < 0.0);
  CHECK(preloaded.balls().contact_angle == 0.0);
  CHECK(warns(preloaded, "clearance becomes negative"));
  Bearing soft = b;
  soft.race_material[1].elastic_strain_limit = 1e-5;
  CHECK(warns(thermal::operating_bearing(soft), "hoop stress of the inner race"));
  soft.race_material[1].elastic_strain_limit = 0.0;  // not known: nothing to judge by
  CHECK_FALSE(warns(thermal::operating_bearing(soft), "hoop stress"));
  Bearing bare = b;  // a housing without wall cannot press
  bare.envelope.housing_diameter = 0.0;
  const Bearing unhoused = thermal::operating_bearing(bare);
  CHECK(unhoused.operating->fit[0].pressure == 0.0);
  CHECK(unhoused.operating->raceway[0].total() == 0.0);
}

TEST_CASE("operating bearing: statics carries the same load at another angle",
          "[physics][operating]") {
  Bearing b = example();
  b.mounting.fit = {5e-6, 15e-6};
  b.race_temperature = {330.0, 345.0};
  const Bearing warm = thermal::operating_bearing(b);
  const statics::StaticSolution cold_solution = statics::solve_ball_statics(b);
  const statics::StaticSolution warm_solution = statics::solve_ball_statics(warm);
  CHECK(warm_solution.load[0] == Approx(cold_solution.load[0]).epsilon(1e-9));
  CHECK(warm.balls().contact_angle < b.balls().contact_angle);
  CHECK(warm_solution.balls[0].alpha[0] < cold_solution.balls[0].alpha[0]);
}

TEST_CASE("operating bearing: rollers between the same raceways → same rings",
          "[physics][operating]") {
  Bearing b = example();
  b.mounting.fit = {8e-6, 18e-6};
  b.race_temperature = {340.0, 352.0};
  b.element_temperature = 355.0;
  const bearing::OperatingFits balls = *thermal::operating_bearing(b).operating;
  thermal::RollerSizes rollers;
  rollers.diameter = b.balls().diameter;
  rollers.length = b.balls().diameter;
  rollers.pitch_diameter = b.balls().pitch_diameter;
  rollers.clearance = b.balls().clearance;
  const thermal::OperatingRollers out =
      thermal::operating_roller_bearing(b, rollers, balls.raceway_radius, 0.0);
  CHECK(out.report.changed);
  CHECK(out.report.fit[1].pressure == balls.fit[1].pressure);
  CHECK(out.report.mounted.clearance == balls.mounted.clearance);
  // The diameter is rounded once more on the way: 1e-18 m of 0.0127 m.
  CHECK(out.report.operating.clearance == Approx(balls.operating.clearance).margin(1e-16));
  CHECK(out.rollers.geometry.clearance == out.report.operating.clearance);
  CHECK(out.rollers.axial_setting_change == 0.0);
  CHECK_THROWS_AS(thermal::operating_roller_bearing(b, rollers, {0.041, 0.0236}, 0.0), InputError);
}

TEST_CASE("operating bearing: impossible temperatures and rings → error with the values",
          "[unit][operating]") {
  Bearing b = example_at_rest();
  b.race_temperature[0] = 0.0;
  CHECK_THROWS_WITH(thermal::operating_bearing(b), Catch::Contains("0 K"));
  b = example_at_rest();
  b.envelope.outer_diameter = b.balls().pitch_diameter;
  CHECK_THROWS_WITH(thermal::operating_bearing(b), Catch::Contains("outer raceway radius"));
  b = example_at_rest();
  b.race_temperature[0] = b.mounting.housing_temperature = 1600.0;
  CHECK_THROWS_WITH(thermal::operating_bearing(b), Catch::Contains("exceeds 90"));
}

TEST_CASE("operating bearing: material laws change moduli and growth with temperature",
          "[physics][material]") {
  const bearing::Material steel = bearing::material_from_table(100, bearing::Part::OuterRace);
  const bearing::Material hot = bearing::material_at(steel, 500.0);
  CHECK(hot.elastic_modulus < steel.elastic_modulus);
  CHECK(hot.density == steel.density);
  CHECK(hot.poisson_ratio == steel.poisson_ratio);
  CHECK(bearing::thermal_strain(steel, 293.15, true) == 0.0);
  CHECK(bearing::thermal_growth(steel, 350.0, 350.0, true) == 0.0);
  // Growth is additive over a chain of temperatures whatever the law.
  CHECK(bearing::thermal_growth(steel, 400.0, 300.0, true) ==
        Approx(bearing::thermal_growth(steel, 400.0, 350.0, true) +
               bearing::thermal_growth(steel, 350.0, 300.0, true))
            .epsilon(1e-13));
  // Clamped outside the range; continuous where the cryogenic law takes over.
  CHECK(bearing::material_at(steel, 900.0).elastic_modulus ==
        bearing::material_at(steel, 773.15).elastic_modulus);
  for (const int code : bearing::material_codes()) {
    CAPTURE(code);
    const bearing::Material m = bearing::material_from_table(code, bearing::Part::Cage);
    // A fit to data in K and one to data in °C meet at room temperature within 10 K of expansion.
    CHECK(bearing::thermal_strain(m, 293.1499, true) ==
          Approx(bearing::thermal_strain(m, 293.15, true)).margin(10.0 * m.thermal_expansion));
    CHECK(bearing::thermal_strain(m, 250.0, true) < 0.0);
    CHECK(bearing::material_at(m, 400.0).elastic_modulus > 0.0);
  }
  bearing::Material user = steel;
  user.table_key.clear();  // given in the deck: no law
  CHECK(bearing::material_at(user, 500.0).elastic_modulus == steel.elastic_modulus);
  CHECK(bearing::thermal_growth(user, 400.0, 300.0, true) == steel.thermal_expansion * 100.0);

  Bearing b = example_at_rest();
  set_temperature(b, 420.0);
  b.mounting.fit = {0.0, 20e-6};
  const Bearing constant = thermal::operating_bearing(b);
  b.mounting.material_laws = true;
  const Bearing lawful = thermal::operating_bearing(b);
  CHECK(lawful.element_material.elastic_modulus < constant.element_material.elastic_modulus);
  CHECK(lawful.operating->fit[1].pressure < constant.operating->fit[1].pressure);
  CHECK(lawful.balls().diameter >
        constant.balls().diameter);  // α_m of 52100 rises with temperature
}

TEST_CASE("operating roller bearing: rings, rollers and clearance change only with a cause",
          "[physics]") {
  bearing::Bearing b = roller_bearings::cylindrical(0.0);
  b.envelope.bore = 0.040;
  b.envelope.outer_diameter = 0.080;
  b.envelope.housing_diameter = 0.110;
  for (bearing::Material* m : {&b.element_material, &b.race_material[0], &b.race_material[1],
                               &b.mounting.housing, &b.mounting.shaft}) {
    m->elastic_modulus = 206e9;
    m->poisson_ratio = 0.3;
    m->density = 7800.0;
    m->thermal_expansion = 1.2e-5;
  }
  const bearing::Bearing same = thermal::operating_bearing(b);
  CHECK(same.rollers()->clearance == b.rollers()->clearance);
  CHECK(same.rollers()->pitch_diameter == b.rollers()->pitch_diameter);
  CHECK_FALSE(same.operating->changed);

  bearing::Bearing pressed = b;
  pressed.mounting.fit = {0.0, 20e-6};
  const bearing::Bearing mounted = thermal::operating_bearing(pressed);
  CHECK(mounted.operating->fit[1].pressure > 1e6);
  // The inner raceway grows by less than the interference, and the play falls by as much.
  const double lost = b.rollers()->clearance - mounted.rollers()->clearance;
  CHECK(lost > 0.5 * 20e-6);
  CHECK(lost < 20e-6);
  CHECK(mounted.rollers()->race_radius(bearing::kInner) -
            b.rollers()->race_radius(bearing::kInner) ==
        Approx(0.5 * lost).epsilon(1e-9));

  bearing::Bearing warm = b;
  warm.race_temperature = {333.15, 333.15};
  warm.element_temperature = warm.cage_temperature = 333.15;
  warm.mounting.housing_temperature = warm.mounting.shaft_temperature = 333.15;
  const bearing::Bearing grown = thermal::operating_bearing(warm);
  const double growth = 1.0 + 40.0 * 1.2e-5;
  CHECK(grown.rollers()->diameter == Approx(b.rollers()->diameter * growth).epsilon(1e-12));
  CHECK(grown.rollers()->pitch_diameter ==
        Approx(b.rollers()->pitch_diameter * growth).epsilon(1e-12));
  CHECK(grown.rollers()->clearance == Approx(b.rollers()->clearance * growth).epsilon(1e-9));
}
