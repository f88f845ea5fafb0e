#include "base/errors.hpp"
#include "deck/templates.hpp"
#include "life/bearing_life.hpp"
#include "listing/print_films.hpp"
#include "setup/build_bearing.hpp"
#include "setup/build_life.hpp"
#include "statics/ball_statics.hpp"
#include "statics/contact_films.hpp"
#include "statics/deck_fault.hpp"
#include "statics/film_doubts.hpp"
#include "statics/roller_statics.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace adore;

namespace {

deck::Deck oiled(const char* type, const char* code = "4") {
  deck::Deck deck = deck::new_deck(type);
  deck.set("mode", "-1");
  deck.set("kTrac", code);
  deck.complete();
  deck.set("reRaceFilm", "2.0e-7");
  deck.set("strParam", "10.0");
  deck.set("rmsAspHt1", "1.5e-7");
  deck.set("rmsAspHt2", "1.5e-7");
  return deck;
}

statics::LubricantFilms films_of(const deck::Deck& deck) {
  const bearing::Bearing bearing = setup::build_bearing(deck);
  if (bearing.rollers() != nullptr)
    return statics::contact_films(bearing, statics::solve_roller_statics(bearing));
  return statics::contact_films(bearing, statics::solve_ball_statics(bearing));
}

}  // namespace

TEST_CASE("films of a solution: every loaded contact of every type has one", "[physics][film]") {
  for (const char* type : {"ball", "cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    CAPTURE(type);
    const statics::LubricantFilms films = films_of(oiled(type));
    CHECK(films.lubricant == "MIL-L-23699 / Mobil Jet II");
    for (std::size_t j = 0; j < 2; ++j) {
      REQUIRE_FALSE(films.race[j].empty());
      CHECK(films.viscosity[j] > 0.0);
      int loaded = 0;
      for (const statics::ElementFilm& f : films.race[j]) {
        if (!(f.film.isothermal > 0.0)) continue;
        ++loaded;
        CHECK(f.speed > 0.0);
        CHECK(f.film.minimum <= f.film.central);
        CHECK(f.film.central <= f.film.isothermal);
        CHECK(f.lambda == Approx(f.film.minimum / 1.5e-7));
        CHECK(f.film.central > 1e-9);
        CHECK(f.film.central < 1e-4);
      }
      CHECK(loaded > 0);
      CHECK(films.lambda[j] > 0.0);
    }
  }
}

TEST_CASE("films of every lubricant from five kelvin on are known, doubted or refused",
          "[physics][film]") {
  int known = 0, doubted = 0, refused = 0;
  for (int code = 1; code <= 20; ++code) {
    if (code == 9) continue;  // the user's own
    bearing::Bearing bearing = setup::build_bearing(oiled("ball", std::to_string(code).c_str()));
    const statics::StaticSolution solution = statics::solve_ball_statics(bearing);
    for (const double kelvin :
         {5.0, 60.0, 100.0, 130.0, 170.0, 185.0, 200.0, 223.0, 250.0, 300.0, 400.0, 600.0}) {
      CAPTURE(code, kelvin);
      bearing.race_temperature = {kelvin, kelvin};
      bearing.element_temperature = kelvin;
      const statics::LubricantFilms films = statics::contact_films(bearing, solution);
      std::vector<Finding> doubts;
      try {
        doubts = statics::film_doubts(films, statics::FilmUse::Motion);
      } catch (const statics::DeckFault& error) {
        ++refused;
        CHECK(kelvin < 260.0);
        CHECK(std::string(error.what()).find("kTrac = 0") != std::string::npos);
        continue;
      }
      ++(doubts.empty() ? known : doubted);
      for (std::size_t j = 0; j < 2; ++j) {
        CHECK(std::isfinite(films.alpha[j]));
        CHECK(films.alpha[j] > 0.0);
        for (const statics::ElementFilm& f : films.race[j]) {
          CHECK(std::isfinite(f.film.central));
          // Thin beside the bodies (balls of 12.7 mm), or it is said.
          CHECK((f.film.central < 0.003 * 6.35e-3 || !doubts.empty()));
        }
      }
      if (kelvin >= 300.0 && kelvin <= 400.0) CHECK(doubts.empty());
    }
  }
  CHECK(known > 40);
  CHECK(doubted > 5);
  CHECK(refused > 40);
}

TEST_CASE("films of a solution: thicker with speed, thinner when starved or hot, metal when thin",
          "[physics][film]") {
  const auto thickest = [](const statics::LubricantFilms& films) {
    double out = 0.0;
    for (const statics::ElementFilm& f : films.race[1]) out = std::max(out, f.film.central);
    return out;
  };
  deck::Deck deck = oiled("ball");
  const double before = thickest(films_of(deck));
  CHECK(films_of(deck).metal[1] == 0);
  deck::Deck slow = deck, starved = deck, hot = deck, rough = deck;
  slow.set("rpm2", "1000.0");
  CHECK(thickest(films_of(slow)) < before);
  starved.set("strParam", "0.5");
  CHECK(thickest(films_of(starved)) < before);
  for (const char* name : {"raceTemp1", "raceTemp2", "reTemp"}) hot.set(name, "450.0");
  CHECK(thickest(films_of(hot)) < before);
  rough.set("reRaceFilm", "1.0e-4");
  CHECK(films_of(rough).metal[1] > 0);
}

TEST_CASE("films of a solution: all lubricants, down to -50 C, at rest too", "[physics][film]") {
  for (int code = 1; code <= 20; ++code) {
    if (code == 9) continue;
    CAPTURE(code);
    deck::Deck deck = oiled("ball", std::to_string(code).c_str());
    for (const char* T : {"223.15", "300.0", "420.0"}) {
      for (const char* name : {"raceTemp1", "raceTemp2", "reTemp"}) deck.set(name, T);
      for (const statics::ElementFilm& f : films_of(deck).race[0]) {
        CHECK(std::isfinite(f.film.central));
        CHECK(f.film.central >= 0.0);
      }
    }
    deck.set("rpm1", "0.0");
    deck.set("rpm2", "0.0");
    for (const statics::ElementFilm& f : films_of(deck).race[0]) CHECK(f.film.central == 0.0);
  }
}

TEST_CASE("the film parameter of a solution is that of its life", "[physics][film][life]") {
  const deck::Deck deck = oiled("ball");
  const bearing::Bearing bearing = setup::build_bearing(deck);
  statics::StaticSolution solution = statics::solve_ball_statics(bearing);
  const bearing::LifeInputs inputs = setup::build_life_inputs(deck);
  const auto stle = [&] {
    return life::ball_bearing_life(bearing, inputs, solution)
        .state.of(bearing::LifeModel::Original, bearing::LifeModification::Stle)
        .L10;
  };
  const double unknown = stle();
  solution.films = statics::contact_films(bearing, solution);
  const life::BearingLife known = life::ball_bearing_life(bearing, inputs, solution);
  for (std::size_t j = 0; j < 2; ++j)
    CHECK(*known.state.factors.film_parameter[j] == solution.films->lambda[j]);
  CHECK(stle() != unknown);
  // A thin film costs life.
  solution.films->lambda = {0.5, 0.5};
  const double thin = stle();
  solution.films->lambda = {3.0, 3.0};
  CHECK(stle() > thin);
  // A given film parameter goes before a computed one.
  bearing::LifeChoices given;
  given.film_parameter = 0.5;
  const life::BearingLife chosen =
      life::ball_bearing_life(bearing, setup::build_life_inputs(deck, given), solution);
  CHECK(chosen.state.of(bearing::LifeModel::Original, bearing::LifeModification::Stle).L10 ==
        Approx(thin));
}

TEST_CASE("film page: lubricant → certainty of its properties", "[unit][film]") {
  listing::Report report("films", deck::UnitSystem::SI);
  listing::print_films(report, films_of(oiled("ball", "13")), "ball");
  const std::string text = report.take();
  for (const char* part : {"PAO-100", "ESTIMATE", "lambda", "Viscosity"})
    CHECK_THAT(text, Catch::Contains(part));
}
