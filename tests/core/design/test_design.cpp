#include "base/errors.hpp"
#include "core/runs/deck_runs.hpp"
#include "deck/catalogue.hpp"
#include "deck/unit_change.hpp"
#include "design/design_inputs.hpp"
#include "design/design_summary.hpp"
#include "design/moving_deck.hpp"
#include "runs/check.hpp"
#include "runs/equilibrium.hpp"
#include "runs/run.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numbers>

/// Values of the design page, and decks that it writes.
using namespace adore;
namespace fs = std::filesystem;

namespace {

deck::Deck catalogue(const char* designation) {
  return deck::read_deck_text(deck::catalogue_deck(deck::find_bearing(designation)), "catalog")
      .deck;
}

double value(const design::DesignSummary& summary, const char* id) {
  const design::DesignValue* one = summary.find(id);
  REQUIRE(one != nullptr);
  INFO(id << ": " << one->note);
  REQUIRE(one->value);
  return *one->value;
}

deck::Deck moving(const deck::Deck& deck) {
  deck::Deck out = deck;
  out.set_all(design::propose_dynamic_deck(deck).sets);
  return out;
}

runs::RunRequest request_of(const deck::Deck& deck, const fs::path& folder) {
  runs::RunRequest request;
  request.text = deck::write_deck(deck);
  request.in_memory = true;
  request.deck = "moving";
  request.out = folder;
  request.overwrite = true;
  return request;
}

constexpr const char* kBearings[] = {"7208", "NU209", "30208", "22210"};

}  // namespace

TEST_CASE("design summary: 7208 → the values of the equilibrium", "[unit][design][design]") {
  const deck::Deck deck = catalogue("7208");
  const design::DesignSummary summary = design::design_summary(deck);
  runs::DeckRequest request;
  request.text = deck::write_deck(deck);
  request.in_memory = true;
  request.deck = "7208";
  const runs::Equilibrium same = runs::solve_equilibrium(request);
  const auto key = [&](std::string_view id) {
    for (const results::KeyResult& one : same.results)
      if (one.of.id == id) return one.value;
    FAIL(id);
    return 0.0;
  };
  const double pressure =
      std::max(value(summary, "pressure_outer"), value(summary, "pressure_inner"));
  CHECK(pressure == Approx(key("largest_pressure_Pa")));
  CHECK(value(summary, "static_safety") == Approx(std::pow(4.2e9 / pressure, 3.0)));
  CHECK(value(summary, "life_lundberg_palmgren") == Approx(key("life_lp_hours")));
  CHECK(value(summary, "stiffness_axial") == Approx(key("stiffness_x_N_per_m")));
  CHECK(value(summary, "stiffness_radial") == Approx(key("stiffness_z_N_per_m")));
  CHECK(value(summary, "torque_total") == Approx(key("friction_torque_Nm")));
  double torque = 0.0;
  for (const char* cause : {"rolling", "sliding", "spin", "flange", "drag"})
    torque += summary.find(std::string("torque_") + cause)->value.value_or(0.0);
  CHECK(torque == Approx(value(summary, "torque_total")));
  const double speed = deck.real("rpm2") * std::numbers::pi / 30.0;
  CHECK(value(summary, "heat") == Approx(torque * speed));
  // Every element passes one of both: Z (n_i - n_o).
  CHECK(value(summary, "bpfo") + value(summary, "bpfi") ==
        Approx(static_cast<double>(deck.integer("nRe")) * deck.real("rpm2") / 60.0));
  CHECK(value(summary, "bpfo") ==
        Approx(static_cast<double>(deck.integer("nRe")) * value(summary, "ftf")));
  CHECK(value(summary, "life_iso281") > 0.0);
  CHECK(value(summary, "life_iso16281") > 0.0);
  // Not computed is not 0.
  for (const char* id :
       {"film_inner", "lambda_outer", "torque_cage", "torque_rolling", "torque_drag"}) {
    REQUIRE(summary.find(id) != nullptr);
    CHECK_FALSE(summary.find(id)->value);
    CHECK(design::quantity_text(*summary.find(id)) == "not computed");
    CHECK_FALSE(summary.find(id)->note.empty());
  }
  CHECK_FALSE(summary.findings.empty());
}

TEST_CASE("design summary: all bearings with and without oil → every value is named and finite",
          "[unit][design][design]") {
  for (const char* bearing : kBearings)
    for (const bool oil : {false, true}) {
      deck::Deck deck = catalogue(bearing);
      if (oil) deck.set_all(design::design_oils(deck).at(4).sets);
      INFO(bearing << (oil ? " with oil" : ""));
      const design::DesignSummary summary = design::design_summary(deck);
      CHECK(summary.values.size() > 28);
      for (const design::DesignValue& one : summary.values) {
        INFO(one.id);
        if (one.value) CHECK(std::isfinite(*one.value));
        CHECK_FALSE(one.note.empty());
      }
      CHECK(summary.find("film_inner")->value.has_value() == oil);
      CHECK(value(summary, "life_iso16281") > 0.0);
    }
}

TEST_CASE("design summary: a deck of motion, a stiffness table → the same values",
          "[unit][design][design]") {
  const deck::Deck deck = catalogue("NU209");
  const design::DesignSummary still = design::design_summary(deck);
  const design::DesignSummary moves = design::design_summary(moving(deck));
  for (const char* id : {"life_iso281", "pressure_inner", "torque_total", "stiffness_radial"})
    CHECK(value(still, id) == Approx(value(moves, id)));
}

TEST_CASE("design values: numbers → four digits without powers of ten", "[unit][design][design]") {
  design::DesignValue one;
  one.unit = "h";
  const auto text = [&](double number) {
    one.value = number;
    return design::quantity_text(one);
  };
  CHECK(text(123456.0) == "123500 h");
  CHECK(text(2.0e9) == "> 1 000 000 h");
  CHECK(text(0.012345) == "0.01235 h");
  CHECK(text(3.0) == "3 h");
  CHECK(text(-12.5) == "-12.5 h");
  one.unit = "°C";
  one.offset = -273.15;
  CHECK(text(293.15) == "20 °C");
}

TEST_CASE("design inputs: values of a deck in units of people, and back to the digit",
          "[unit][design][design]") {
  const deck::Deck deck = catalogue("7208 B");
  const auto text = [](const deck::Deck& of, const char* variable) {
    for (const design::DesignInput& one : design::design_inputs(of))
      if (one.variables.front() == variable) return design::input_text(of, one);
    return std::string("none");
  };
  CHECK(text(deck, "brgBore") == "40");
  CHECK(text(deck, "bReDia") == "11.90625");
  CHECK(text(deck, "hsngTemp") == "20");
  CHECK(text(deck, "bReLen") == "none");
  CHECK(text(deck::in_units(deck, deck::UnitSystem::English), "brgBore") == "40");
  deck::Deck warm = deck;
  warm.set("reTemp", "333.15");
  CHECK(text(warm, "hsngTemp").empty());  // different temperatures
}

TEST_CASE("design oils: a grade → record X2 and nothing of the oil before it",
          "[unit][facade][design]") {
  deck::Deck deck = catalogue("7208");
  const auto oil = [&](const char* name) {
    const auto oils = design::design_oils(deck);
    const auto found = std::find_if(oils.begin(), oils.end(), [&](const design::DesignOil& one) {
      return one.name.find(name) != std::string::npos;
    });
    REQUIRE(found != oils.end());
    return static_cast<std::size_t>(found - oils.begin());
  };
  const auto take = [&](const char* name) {
    deck.set_all(design::design_oils(deck)[oil(name)].sets);
  };
  CHECK(design::design_oil_index(deck) == oil("dry"));
  take("VG 68");
  CHECK(deck.integer("kTrac") == 21);
  CHECK(deck.integer("oilGrade") == 68);
  CHECK(deck.real("strParam") == 10.0);
  CHECK(design::design_oil_index(deck) == oil("VG 68"));
  // Another oil of this record is none of the page, and a choice replaces all of it.
  deck.set_all(std::vector<std::pair<std::string, std::string>>{
      {"oilGrade", ""}, {"oilVisc1", "110"}, {"oilVisc2", "14"}, {"kOilBase", "2"}});
  CHECK_FALSE(design::design_oil_index(deck));
  CHECK(design::replace_bearing(deck, "6205", true).real("oilVisc2") == 14.0);
  take("VG 220");
  CHECK(design::design_oil_index(deck) == oil("VG 220"));
  CHECK_FALSE(deck.has("oilVisc1"));
  CHECK_FALSE(deck.has("kOilBase"));
  const design::DesignSummary thick = design::design_summary(deck);
  take("VG 32");
  CHECK(value(thick, "film_inner") > 1.5 * value(design::design_summary(deck), "film_inner"));
  take("MIL-L-23699, Newtonian");
  CHECK(design::design_oil_index(deck) == oil("MIL-L-23699, Newtonian"));
  CHECK_FALSE(deck.has("oilGrade"));
  take("dry");
  CHECK(deck.integer("kTrac") == 0);
}

TEST_CASE("replace_bearing: another designation → the operation of the user stays",
          "[unit][design][design]") {
  deck::Deck deck = catalogue("7208");
  deck.set("rpm2", "7777");
  deck.set_all(design::design_oils(deck).at(4).sets);
  const deck::Deck next = design::replace_bearing(deck, "6205", true);
  CHECK(next.text("runID") == "6205");
  CHECK(next.real("rpm2") == 7777.0);
  CHECK(next.integer("kTrac") == deck.integer("kTrac"));
  CHECK(next.real("strParam") == deck.real("strParam"));
  // The load that the catalog proposed for the 7208 is not the user's.
  CHECK(next.real("appLoadZ") == catalogue("6205").real("appLoadZ"));
  CHECK(design::replace_bearing(deck, "6205", false) == catalogue("6205"));
  CHECK_THROWS_AS(design::replace_bearing(deck, "no bearing", true), InputError);
}

TEST_CASE("moving deck: each type of the catalog → `adore check` accepts it and a run starts",
          "[unit][design][design]") {
  for (const char* bearing : kBearings) {
    INFO(bearing);
    const deck::Deck deck = moving(catalogue(bearing));
    CHECK(deck.integer("nCseg") == 1);
    CHECK(deck.real("bPocCls1") > 0.0);
    CHECK(deck.real("gravityVecZ") == -9.81);
    CHECK(deck.integer("kAGraf") == 1);
    CHECK(deck.integer("kNumPltElem") == 4);
    for (const Issue& issue : deck::check_deck(deck)) {
      INFO(issue.text());
      CHECK(issue.severity == Severity::Note);
    }
    const testing::TemporaryFolder folder;
    runs::RunRequest request = request_of(deck, folder / "run");
    const runs::CheckReport report = runs::check(request);
    for (const Finding& one : report.issues) {
      INFO(one.text());
      CHECK(one.severity != Severity::Error);
    }
    request.until = "0.02rev";
    CHECK(runs::run(request).status == runs::RunStatus::Done);
    CHECK(fs::file_size(folder / "run" / "SOL8") > 1000);
  }
}

TEST_CASE("moving deck: English units → the same bearing", "[unit][design][design]") {
  const deck::Deck si = catalogue("7208");
  const deck::Deck a = moving(si);
  const deck::Deck b = moving(deck::in_units(si, deck::UnitSystem::English));
  for (const char* name : {"cageDia1", "cageDia2", "cageWidth", "bPocCls1", "gravityVecZ"})
    CHECK(a.si(name) == Approx(b.si(name)).epsilon(1e-5));
  CHECK(a.si("cageGsCls", 2) == Approx(b.si("cageGsCls", 2)).epsilon(1e-5));
}

TEST_CASE("moving deck: own cage, gravity → kept; no speed → rejected", "[unit][design][design]") {
  deck::Deck deck = moving(catalogue("7208"));
  deck.set("bPocCls1", "0.0005");
  deck.set("gravityVecZ", "-1.62");
  const deck::Deck again = moving(deck);
  CHECK(again.real("bPocCls1") == 0.0005);
  CHECK(again.real("gravityVecZ") == -1.62);
  deck.set("rpm2", "0");
  CHECK_THROWS_AS(design::propose_dynamic_deck(deck), InputError);
}

// With a folder in ADORE_MOVING it keeps decks and results there.
TEST_CASE("moving deck: whole runs", "[.][moving]") {
  const char* folder = std::getenv("ADORE_MOVING");
  REQUIRE(folder != nullptr);
  for (const char* bearing : kBearings) {
    const deck::Deck deck = moving(catalogue(bearing));
    const fs::path out = fs::path(folder) / bearing;
    fs::create_directories(out);
    deck::write_deck(deck, out / "DATA.txt");
    if (std::getenv("ADORE_MOVING_DECKS") != nullptr) continue;
    const runs::RunOutcome end = runs::run(request_of(deck, out));
    INFO(bearing << ": " << end.message);
    CHECK(end.status == runs::RunStatus::Done);
    CHECK(end.revolutions >= 3.0);
  }
}
