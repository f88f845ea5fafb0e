#include "base/errors.hpp"
#include "bearing/material.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

using namespace adore::bearing;

TEST_CASE("material code 0: 52100 for races and elements, mild steel for other parts",
          "[unit][material]") {
  for (const Part part : {Part::RollingElement, Part::OuterRace, Part::InnerRace}) {
    const Material steel = material_from_table(0, part);
    CHECK(steel.name == material_from_table(100, part).name);
    CHECK(steel.code == 0);
    CHECK(steel.density == 7810.0);
    CHECK(steel.elastic_modulus == 207e9);
    CHECK(steel.poisson_ratio == 0.29);
    CHECK(steel.fatigue_limit_stress == 684e6);
    CHECK(steel.provenance == "estimated");  // its wear coefficient is an order of magnitude
  }
  for (const Part part : {Part::Housing, Part::Shaft, Part::Cage}) {
    const Material steel = material_from_table(0, part);
    CHECK_THAT(steel.name, Catch::StartsWith("Mild steel"));
    CHECK(steel.fatigue_limit_stress == 235e6);  // no fatigue limit known: yield
  }
}

TEST_CASE("materials: every material of the table → physically possible values",
          "[unit][material]") {
  const std::vector<int> codes = material_codes();
  CHECK(codes.size() == 32);
  CHECK(std::is_sorted(codes.begin(), codes.end()));
  for (const int code : codes) {
    CAPTURE(code);
    const Material m = material_from_table(code, Part::Cage);
    CHECK(m.code == code);
    CHECK_FALSE(m.name.empty());
    CHECK((m.density > 500.0 && m.density < 20000.0));
    CHECK((m.elastic_modulus > 1e8 && m.elastic_modulus < 1e12));
    CHECK((m.poisson_ratio > 0.0 && m.poisson_ratio < 0.5));
    CHECK((m.thermal_expansion > 1e-7 && m.thermal_expansion < 1e-3));
    CHECK((m.conductivity > 0.05 && m.conductivity < 500.0));
    CHECK((m.specific_heat > 100.0 && m.specific_heat < 5000.0));
    CHECK((m.elastic_strain_limit > 1e-4 && m.elastic_strain_limit < 0.1));
    CHECK((m.hardness > 1e7 && m.hardness < 1e11));
    CHECK((m.wear_coefficient > 0.0 && m.wear_coefficient < 1e-2));
    CHECK(m.fatigue_limit_stress > 1e6);
  }
}

TEST_CASE("material code: unknown → error with the valid ones", "[unit][material]") {
  for (const int code : {1, 2, 99, 164, -5}) {
    CAPTURE(code);
    try {
      (void)material_from_table(code, Part::Cage);
      FAIL("no error for an unknown code");
    } catch (const adore::InputError& error) {
      CHECK_THAT(error.what(), Catch::Contains("material code " + std::to_string(code)) &&
                                   Catch::Contains("100, 101") && Catch::Contains("207"));
    }
  }
}

TEST_CASE("hardness: Rockwell C → indentation pressure by the table", "[unit][material]") {
  constexpr double kVickers = 9.80665e6;
  CHECK(hardness_from_hrc(60.0) == Approx(697.0 * kVickers).epsilon(1e-14));  // a table point
  CHECK(hardness_from_hrc(20.0) == Approx(238.0 * kVickers).epsilon(1e-14));  // first point
  CHECK(hardness_from_hrc(61.5) == Approx(733.0 * kVickers).epsilon(1e-14));  // halfway 720..746
  CHECK(hardness_from_hrc(66.0) == Approx(856.0 * kVickers).epsilon(1e-14));  // 800 + 2 * 28
  CHECK(hardness_from_hrc(10.0) == Approx(182.0 * kVickers).epsilon(1e-14));  // 238 - 10 * 5.6
  double last = 0.0;
  for (double hrc = 0.0; hrc <= 80.0; hrc += 0.25) {
    CHECK(hardness_from_hrc(hrc) > last);
    last = hardness_from_hrc(hrc);
  }
  CHECK_THROWS_AS(hardness_from_hrc(-60.0), adore::InputError);
}

TEST_CASE("contact modulus: compliances of both bodies are added", "[unit][material]") {
  const Material steel = material_from_table(100, Part::InnerRace);
  const Material ceramic = material_from_table(150, Part::RollingElement);
  // Equal bodies: E / (2 (1 - nu^2)).
  CHECK(contact_modulus(steel, steel) == Approx(207e9 / (2 * (1 - 0.29 * 0.29))).epsilon(1e-14));
  CHECK(contact_modulus(steel, ceramic) == Approx(contact_modulus(ceramic, steel)).epsilon(1e-15));
  CHECK(contact_modulus(steel, ceramic) > contact_modulus(steel, steel));
}
