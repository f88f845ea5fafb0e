#include "base/errors.hpp"
#include "deck/deck.hpp"
#include "deck/orbit_records.hpp"
#include "deck/templates.hpp"
#include "runs/prepare.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// Record 9.5 in mode -1: the orbit of the bearing is part of the equilibrium.
using namespace adore;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

/// A planet on an arm of 0.1 m at 2000 rpm.
const Sets kOrbit{{"kRotFrame", "1"},    {"brgOrbitRad", "0.1"}, {"brgAngPos", "30"},
                  {"brgAngVel", "2000"}, {"brgLoadFrac1", "0"},  {"brgLoadFrac2", "0"}};

deck::Deck orbiting(const char* type, const char* mode) {
  deck::Deck out = deck::new_deck(type);
  Sets sets = kOrbit;
  sets.emplace_back("mode", mode);
  out.set_all(sets);
  return out;
}

runs::Prepared prepared(deck::Deck deck, std::map<std::string, std::string> options = {}) {
  runs::LoadedDeck input;
  input.option_values = std::move(options);
  input.path = runs::kStandardInput;
  input.deck = std::move(deck);
  return runs::prepare(std::move(input));
}

}  // namespace

TEST_CASE("orbit in mode -1: each roller feels m R Omega^2 and its own centrifugal force",
          "[physics][statics][analytic]") {
  // Friction changes the orbit of each roller a little: without it all have one.
  const runs::Prepared at = prepared(orbiting("cylindrical", "-1"), {{"rollerFriction", "none"}});
  const double pi = std::numbers::pi, turn = 2000.0 * pi / 30.0, angle = 30.0 * pi / 180.0;
  const double mass = at.rollers->roller_mass;
  const double ring = 0.5 * at.bearing.pitch_diameter();
  const double own = mass * ring * std::pow(at.rollers->orbital_speed + turn, 2);
  double largest = 0.0;
  for (const statics::StaticRoller& roller : at.rollers->rollers) {
    const double expected = own + mass * 0.1 * turn * turn * std::cos(roller.azimuth - angle);
    CHECK(roller.race[0].load - roller.race[1].load == Approx(expected).epsilon(1e-6));
    largest = std::max(largest, expected - own);
  }
  CHECK(largest > 0.1 * own);  // the field counts here
}

TEST_CASE("orbit: mode -1 has the equilibrium that modes 0, 1 and 2 start from",
          "[physics][statics][modes]") {
  for (const char* type : {"cylindrical", "tapered", "spherical", "spherical-tapered"}) {
    INFO(type);
    const runs::Prepared still = prepared(orbiting(type, "-1"));
    for (const char* mode : {"0", "1", "2"}) {
      const runs::Prepared motion = prepared(orbiting(type, mode));
      for (std::size_t i = 0; i < still.rollers->rollers.size(); ++i)
        for (std::size_t j = 0; j < 2; ++j)
          CHECK(still.rollers->rollers[i].race[j].load ==
                Approx(motion.rollers->rollers[i].race[j].load).margin(1e-6));
    }
  }
  // Balls of a given spin axis: those of others are in balance of friction in mode -1 only.
  const Sets given_axis{{"kAngVel", "2"}, {"angVelOrient", "25"}};
  deck::Deck rest = orbiting("ball", "-1"), moving = orbiting("ball", "0");
  rest.set_all(given_axis);
  moving.set_all(given_axis);
  const runs::Prepared still = prepared(rest), motion = prepared(moving);
  for (std::size_t i = 0; i < still.statics.balls.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j)
      CHECK(still.statics.balls[i].Q[j] == Approx(motion.statics.balls[i].Q[j]).margin(1e-6));
}

TEST_CASE("orbit in mode -1: shares of race inertia load the bearing", "[physics][statics]") {
  deck::Deck with = orbiting("ball", "-1");
  const runs::Prepared without = prepared(with);
  with.set("brgLoadFrac2", "1");
  const runs::Prepared at = prepared(with);
  const double turn = 2000.0 * std::numbers::pi / 30.0;
  const double force = at.bearing.race_inertia[1].mass * 0.1 * turn * turn;
  CHECK(at.statics.load[2] - without.statics.load[2] ==
        Approx(force * std::cos(std::numbers::pi / 6.0)).epsilon(1e-6));
}

TEST_CASE("orbit in mode -1: deck text keeps records 3.4 and 9.5, which act without a warning",
          "[deck]") {
  const deck::Deck deck = orbiting("ball", "-1");
  CHECK(deck.integer("kRotFrame") == 0);  // of records that mode -1 asks for
  REQUIRE(deck::orbit_records(deck).size() == 2);
  const deck::ReadResult again = deck::read_deck_text(deck::write_deck(deck), "again");
  CHECK(deck::orbit_records(again.deck) == deck::orbit_records(deck));
  for (const Issue& issue : again.issues) {
    INFO(issue.text());
    CHECK(issue.text().find("9.5") == std::string::npos);
    CHECK(issue.text().find("3.4") == std::string::npos);
  }
  const runs::Prepared at = prepared(deck);
  for (const Issue& issue : at.input.warnings)
    CHECK(issue.text().find("kRotFrame") == std::string::npos);
  // Without the switch they do not act, and back in motion they are there.
  deck::Deck off = deck;
  off.set("kRotFrame", "0");
  CHECK(deck::orbit_records(off).empty());
  deck::Deck back = deck;
  back.set_all(Sets{{"mode", "0"}});
  CHECK(back.real("brgAngVel") == 2000.0);
}

TEST_CASE("orbit in mode -1: a negative radius is rejected by its name", "[deck]") {
  deck::Deck deck = orbiting("ball", "-1");
  deck.set("brgOrbitRad", "-0.1");
  CHECK_THROWS_WITH(prepared(deck), Catch::Contains("brgOrbitRad"));
}
