#include "base/constants.hpp"
#include "deck/templates.hpp"
#include "listing/print_cage.hpp"
#include "setup/build_bearing.hpp"
#include "thermal/operating.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <string>

using namespace adore;

namespace {

/// A quasi-static deck from one of the examples that have a cage.
deck::Deck at_rest(const char* name) {
  deck::Deck deck = deck::new_deck(name);
  deck.set("mode", "-1");
  deck.complete();
  return deck;
}

std::string page(const bearing::Bearing& bearing, const deck::Deck& deck) {
  listing::Report report("page", deck::UnitSystem::SI);
  report.new_page("CAGE");
  listing::print_cage_geometry(report, bearing, deck);
  listing::print_cage_operation(report, bearing);
  return report.take();
}

}  // namespace

TEST_CASE("cage page: every roller type → mass, clearance and speed in a quasi-static solution",
          "[physics][cage]") {
  for (const char* name : {"cylindrical", "tapered", "spherical", "spherical-tapered"}) {
    INFO(name);
    const deck::Deck deck = at_rest(name);
    const bearing::Bearing bearing = thermal::operating_bearing(setup::build_bearing(deck));
    REQUIRE(bearing.cage);
    const bearing::Cage& cage = *bearing.cage;
    // Less than the whole shell, more than the bars and rims that windows over all of it would
    // leave.
    const double shell = cage.material.density * 0.25 * kPi * cage.width *
                         (std::pow(cage.outer_diameter, 2) - std::pow(cage.inner_diameter, 2));
    const auto& g = *bearing.rollers();
    const double window = cage.material.density * 0.5 *
                          (cage.outer_diameter - cage.inner_diameter) * g.count *
                          (g.diameter + cage.pocket_clearance_1) * g.length;
    CHECK(cage.inertia.mass < shell);
    CHECK(cage.inertia.mass ==
          Approx(shell - window).epsilon(0.12));                 // curved walls, leaning cones
    CHECK(cage.inertia.moments.x() > cage.inertia.moments.y());  // a ring
    CHECK(cage.inertia.moments.y() == Approx(cage.inertia.moments.z()).epsilon(1e-9));
    // Epicyclic: the orbit of pure rolling.
    const double gamma = g.diameter * std::cos(g.axis_angle) / g.pitch_diameter;
    CHECK(bearing.operating->cage_speed ==
          Approx(0.5 * bearing.speed[1] * (1.0 - gamma)).epsilon(1e-4));
    const std::string text = page(bearing, deck);
    for (const char* words : {"Cage mass", "Effective cage clearance", "pocket clearance I",
                              "Cage speed (epicyclic)", "Mass (from the ideal shape)"})
      CHECK_THAT(text, Catch::Contains(words));
    const auto json = listing::cage_json(bearing);
    CHECK(json["mass [kg]"] == cage.inertia.mass);
    CHECK(json["effective play"]["diametral [m]"].get<double>() > 0.0);
  }
}

TEST_CASE("conical cage: mass center towards its large end", "[physics][cage]") {
  const deck::Deck deck = at_rest("tapered");
  const bearing::Bearing bearing = thermal::operating_bearing(setup::build_bearing(deck));
  CHECK(bearing.cage->cone_angle == Approx(12.275 * kPi / 180.0));
  CHECK_THAT(page(bearing, deck),
             Catch::Contains("Axial distance of the mass center from the middle") &&
                 Catch::Contains("-0.0007"));  // the large end is at -x
}

TEST_CASE("shaped roller pockets: smallest clearance, and the cylinder of a roller-guided cage",
          "[physics][cage]") {
  deck::Deck deck = at_rest("cylindrical");
  const double D = deck.si("bReDia");
  deck.set("kPocType", "2");
  deck.complete();
  for (int pair = 1; pair <= 2; ++pair) {
    for (const char* zero : {"bPocGsAng1", "bPocGsAng2", "bPocGsAng3", "bPocGsCen1"})
      deck.set(fmt::format("{}[{}]", zero, pair), "0");
    deck.set(fmt::format("bPocGsCen2[{}]", pair),
             fmt::format("{}", 0.5 * D + (pair == 1 ? 1.5e-4 : 0.9e-4)));
    deck.set(fmt::format("bPocGsCen3[{}]", pair), pair == 1 ? "0.001" : "-0.001");
    deck.set(fmt::format("bPocGsLen1[{}]", pair), "0.002");
    deck.set(fmt::format("bPocGsLen2[{}]", pair), "0.008");
  }
  const bearing::Bearing faces = thermal::operating_bearing(setup::build_bearing(deck));
  CHECK(faces.cage->pocket_clearance_1 == Approx(1.8e-4).epsilon(1e-6));
  CHECK(faces.cage->inertia.mass > 0.0);
  CHECK_THAT(page(faces, deck),
             Catch::Contains("2 pairs of guide faces") &&
                 Catch::Contains("Smallest pocket clearance between guide faces"));

  deck = at_rest("cylindrical");
  const bearing::Bearing window = setup::build_bearing(deck);
  deck.set("kPocType", "-1");
  deck.complete();
  const bearing::Bearing guided = setup::build_bearing(deck);
  // Inside the wall a cylinder takes less than a window of parallel faces.
  CHECK(guided.cage->inertia.mass > window.cage->inertia.mass);
  CHECK_THAT(page(guided, deck), Catch::Contains("roller-guided cage"));
}

TEST_CASE("pockets: no clearance left for the element → error with the variable", "[unit][cage]") {
  const auto refusal = [](deck::Deck deck) {
    try {
      (void)setup::build_bearing(deck);
    } catch (const InputError& refused) {
      return std::string(refused.what());
    }
    return std::string();
  };
  const auto faces = [](double beyond) {
    deck::Deck deck = deck::new_deck("cylindrical");
    deck.set("kPocType", "1");
    deck.complete();
    for (const char* zero : {"bPocGsAng1", "bPocGsAng2", "bPocGsAng3", "bPocGsCen1", "bPocGsCen3"})
      deck.set(fmt::format("{}[1]", zero), "0");
    deck.set("bPocGsCen2[1]", fmt::format("{}", 0.5 * deck.si("bReDia") + beyond));
    deck.set("bPocGsLen1[1]", "0.002");
    deck.set("bPocGsLen2[1]", "0.008");
    return deck;
  };
  CHECK(refusal(faces(1e-4)).empty());
  CHECK_THAT(refusal(faces(-1e-4)),
             Catch::Contains("bPocGsCen2[1]") && Catch::Contains("0.0002 m"));
  deck::Deck leaning = faces(1e-4);
  leaning.set("bPocGsAng3[1]", "3");
  CHECK_THAT(refusal(leaning), Catch::Contains("bPocGsAng3[1]"));
  for (const char* which : {"1", "2"}) {  // the first pocket alone, and all of them
    deck::Deck narrowed = faces(1e-4);
    narrowed.set("kCagePocImp", which);
    narrowed.complete();
    narrowed.set("bPocClsVar1", "-1e-4");
    CHECK(refusal(narrowed).empty());
    narrowed.set("bPocClsVar1", "-3e-4");
    CHECK_THAT(refusal(narrowed), Catch::Contains("bPocClsVar1") && Catch::Contains("0.0001 m"));
  }
  deck::Deck thick = faces(1e-4);
  thick.set("kReGeoImp", "2");
  thick.complete();
  thick.set("reDiaVar3", "3e-4");
  CHECK_THAT(refusal(thick), Catch::Contains("reDiaVar3") && Catch::Contains("element 3"));
  for (const char* type : {"ball", "tapered"}) {
    deck::Deck narrow = deck::new_deck(type);
    narrow.set("bPocCls1", "-1e-5");
    CHECK_THAT(refusal(narrow), Catch::Contains("bPocCls1"));
  }
  deck::Deck cone = deck::new_deck("ball");
  cone.set("kPocType", "4");
  cone.complete();
  cone.set("bPocCls1", "1e-3");
  cone.set("bPocCls2", "-1e-3");
  CHECK(refusal(cone).empty());
}

TEST_CASE("cage page: ball cages of every pocket shape", "[physics][cage]") {
  for (const auto& [code, name, clearance] : {std::tuple{"0", "cylindrical", "0"},
                                              {"1", "spherical", "0"},
                                              {"2", "elongated", "0.0002"},
                                              {"3", "rectangular", "0.0003"},
                                              {"4", "conical", "0.0004"}}) {
    INFO(name);
    deck::Deck deck = at_rest("ball");
    deck.set("kPocType", code);
    deck.set("bPocCls2", clearance);
    const bearing::Bearing bearing = thermal::operating_bearing(setup::build_bearing(deck));
    REQUIRE(bearing.cage);
    CHECK(bearing.cage->inertia.mass > 0.0);
    CHECK_THAT(page(bearing, deck), Catch::Contains(name));
  }
}

TEST_CASE("cage page: windows that cannot be cut → no mass, with the reason", "[unit][cage]") {
  deck::Deck deck = at_rest("cylindrical");
  deck.set("cageWidth", "0.009");  // narrower than the rollers are long
  deck.set("cageGsPos[1]", "-0.0045");
  deck.set("cageGsPos[2]", "0.0045");
  const bearing::Bearing bearing = thermal::operating_bearing(setup::build_bearing(deck));
  REQUIRE(bearing.cage);
  CHECK(bearing.cage->inertia.mass == 0.0);
  CHECK_THAT(page(bearing, deck), Catch::Contains("The mass of the cage is unknown") &&
                                      Catch::Contains("Effective cage clearance"));
  CHECK(listing::cage_json(bearing)["mass [kg]"].is_null());
}

TEST_CASE("cage page: given mass → from its record", "[unit][cage]") {
  deck::Deck deck = at_rest("tapered");
  deck.set("kCageIP", "1");
  deck.complete();
  deck.set("cageMass", "0.0321");
  for (const char* moment : {"cageMIx", "cageMIy", "cageMIz"}) deck.set(moment, "1.5e-5");
  const bearing::Bearing bearing = setup::build_bearing(deck);
  CHECK(bearing.cage->inertia.mass == 0.0321);
  CHECK_THAT(page(bearing, deck), Catch::Contains("Mass (record 7.7)"));
}
