#include "deck/templates.hpp"
#include "listing/static_cut.hpp"
#include "setup/build_bearing.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"
#include "thermal/operating.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace adore;

namespace {

results::StaticTables tables_of(const deck::Deck& deck) {
  const bearing::Bearing bearing = thermal::operating_bearing(setup::build_bearing(deck));
  if (bearing.rollers()) {
    const auto solution = statics::solve_roller_statics(bearing);
    auto out = listing::static_tables(solution, bearing, deck::UnitSystem::SI);
    listing::add_radial_section(out, solution, bearing);
    return out;
  }
  const auto solution = statics::solve_ball_statics(bearing);
  auto out = listing::static_tables(solution, bearing, deck::UnitSystem::SI);
  listing::add_radial_section(out, solution, bearing);
  return out;
}

double only(const results::StaticTables& all, const std::string& column) {
  return all.find("cut")->find(column)->values.front();
}

struct Line {
  const std::vector<double>&x, &r;
};
Line line(const results::StaticTables& all, const std::string& table) {
  return {all.find(table)->find("x")->values, all.find(table)->find("r")->values};
}

/// Least distance between the points of two lines [m].
double gap(const Line& a, const Line& b) {
  double out = 1.0;
  for (std::size_t i = 0; i < a.x.size(); ++i)
    for (std::size_t k = 0; k < b.x.size(); ++k)
      out = std::min(out, std::hypot(a.x[i] - b.x[k], a.r[i] - b.r[k]));
  return out;
}

}  // namespace

TEST_CASE("static_cut: margins equal those of the angles around the bearing", "[physics][plot]") {
  const deck::Deck deck = deck::new_deck("angular-218");
  const results::StaticTables all = tables_of(deck);
  const auto& elements = *all.find("elements");
  const auto at = static_cast<std::size_t>(only(all, "element")) - 1;
  const auto value = [&](const std::string& column) { return elements.find(column)->values[at]; };
  const double largest = *std::max_element(elements.find("outer load")->values.begin(),
                                           elements.find("outer load")->values.end());
  CHECK(only(all, "outer load") == largest);
  const double radius = 0.5232 * 0.022225;
  // Thrust along +x: the outer contact lies towards +x, the inner one towards -x.
  for (const auto& [race, near, far] :
       {std::tuple<std::string, const char*, const char*>{"outer ", "+x", "-x"},
        {"inner ", "-x", "+x"}}) {
    INFO(race);
    const double end = value(race + "groove end");
    CHECK(only(all, race + near + " margin") ==
          Approx(radius * (end - value(race + "ellipse high"))).epsilon(1e-9));
    CHECK(only(all, race + far + " margin") ==
          Approx(radius * (end + value(race + "ellipse low"))).epsilon(1e-9));
  }
}

TEST_CASE("static_cut: ball touches both grooves at its contacts", "[physics][plot]") {
  const results::StaticTables all = tables_of(deck::new_deck("deep-groove-6205"));
  const Line ball = line(all, "cut element");
  for (const std::string race : {"outer", "inner"}) {
    INFO(race);
    const Line contact = line(all, "cut " + race + " contact"),
               groove = line(all, "cut " + race + " race");
    CHECK(gap(ball, contact) < 1e-4);    // a ball of 8 mm in 120 points
    CHECK(gap(groove, contact) < 1e-4);  // the contact lies on its groove
    // Shoulders where the deck has them.
    const double shoulder = race == "outer" ? 0.0214 : 0.0171;
    // Under its load the inner ring moves by the clearance and the contacts' deflection, some 25
    // um.
    CHECK(groove.r.front() == Approx(shoulder).margin(4e-5));
    CHECK(groove.r.back() == Approx(shoulder).margin(4e-5));
  }
}

TEST_CASE("static_cut: contact over the shoulder → negative margin; no shoulder → none",
          "[physics][plot]") {
  deck::Deck deck = deck::new_deck("angular-218");
  deck.set("appLoadX", "120000");
  const results::StaticTables heavy = tables_of(deck);
  CHECK(only(heavy, "inner -x margin") < 0.0);
  CHECK(only(heavy, "inner +x margin") > 0.0);
  for (const char* name : {"shoulderDia1", "shoulderDia2"}) deck.set(name, "0");
  CHECK(std::isnan(only(tables_of(deck), "inner -x margin")));
}

TEST_CASE("static_cut: rollers of every shape are on their raceways", "[physics][plot]") {
  for (const char* name : {"spherical-22210", "cylindrical-nu209", "tapered-30208"}) {
    INFO(name);
    deck::Deck deck = deck::new_deck(name);
    const results::StaticTables all = tables_of(deck);
    const Line roller = line(all, "cut element");
    for (const std::string race : {"outer", "inner"}) {
      INFO(race);
      // Half the play between them, and points 0.3 mm apart.
      CHECK(gap(roller, line(all, "cut " + race + " race")) < 1.6e-4);
      CHECK(gap(line(all, "cut " + race + " contact"), line(all, "cut " + race + " race")) <
            1.6e-4);
      CHECK(only(all, race + " -x margin") >= 0.0);
      CHECK(only(all, race + " +x margin") >= 0.0);
    }
    const double height = *std::max_element(roller.r.begin(), roller.r.end()) -
                          *std::min_element(roller.r.begin(), roller.r.end());
    CHECK(height > (1.0 - 1e-9) * deck.si("bReDia"));
    CHECK(height < 1.35 * deck.si("bReDia"));
  }
}

TEST_CASE("static_cut: barrel under light load → margin to its corners", "[physics][plot]") {
  deck::Deck deck = deck::new_deck("spherical-22210");
  deck.set("appLoadZ", "300");
  const results::StaticTables all = tables_of(deck);
  for (const char* column :
       {"outer -x margin", "outer +x margin", "inner -x margin", "inner +x margin"})
    CHECK(only(all, column) > 5e-4);
}

TEST_CASE("static_cut: no load → none", "[unit][plot]") {
  deck::Deck deck = deck::new_deck("deep-groove-6205");
  for (const char* name : {"appLoadX", "appLoadY", "appLoadZ", "rpm1", "rpm2"}) deck.set(name, "0");
  CHECK(tables_of(deck).find("cut") == nullptr);
}
