#include "base/errors.hpp"
#include "base/random_table.hpp"
#include "deck/templates.hpp"
#include "listing/print_imperfections.hpp"
#include "setup/build_bearing.hpp"
#include "setup/run_control.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

using namespace adore;

namespace {

/// The template with its codes set, then complete, then the values.
deck::Deck with(const char* name, std::initializer_list<std::pair<const char*, const char*>> codes,
                std::initializer_list<std::pair<const char*, const char*>> values) {
  deck::Deck deck = deck::new_deck(name);
  deck.set("mode", "-1");
  for (const auto& [variable, value] : codes) deck.set(variable, value);
  deck.complete();
  for (const auto& [variable, value] : values) deck.set(variable, value);
  return deck;
}

}  // namespace

TEST_CASE("imperfections: random ball diameters → seed and rms of the deck",
          "[unit][imperfections]") {
  const deck::Deck deck = with("ball", {{"kReGeoImp", "1"}}, {{"reDiaVar", "2e-6"}});
  const auto b = setup::build_bearing(deck);
  REQUIRE(b.imperfections.ball_diameter.size() == static_cast<std::size_t>(b.balls().count));
  const RandomTable table(setup::kDefaultSeed);
  for (std::size_t k = 0; k < b.imperfections.ball_diameter.size(); ++k)
    CHECK(b.imperfections.ball_diameter[k] == 2e-6 * table.standard_normal(k, 0));
  CHECK(setup::build_bearing(deck).imperfections.ball_diameter == b.imperfections.ball_diameter);
  CHECK(setup::build_bearing(deck, 2).imperfections.ball_diameter != b.imperfections.ball_diameter);
  CHECK(setup::build_run_options({{"seed", "77"}}).seed == 77);
  CHECK_THROWS_AS(setup::build_run_options({{"seed", "-1"}}), InputError);
  CHECK_THROWS_AS(setup::build_run_options({{"seed", "1.5"}}), InputError);
  // In inches the same bearing.
  const deck::Deck english =
      with("ball-english", {{"kReGeoImp", "1"}}, {{"reDiaVar", "7.874015748031496e-05"}});
  const auto e = setup::build_bearing(english);
  for (std::size_t k = 0; k < b.imperfections.ball_diameter.size(); ++k)
    CHECK(e.imperfections.ball_diameter[k] ==
          Approx(b.imperfections.ball_diameter[k]).epsilon(1e-12));
  // Said in PRINT.txt and RUN.json.
  listing::Report report("test", deck::UnitSystem::SI);
  listing::print_imperfections(report, b);
  const std::string text = report.take();
  CHECK(text.find("GEOMETRIC IMPERFECTIONS") != std::string::npos);
  // Tables have five digits.
  CHECK(text.find(fmt::format("{:.4e}", b.imperfections.ball_diameter[5])) != std::string::npos);
  const auto json = listing::imperfections_json(b);
  CHECK(json.at("elements").at("diameter [m]").at(3).get<double>() ==
        b.imperfections.ball_diameter[3]);
}

TEST_CASE("imperfections: listed diameters and race errors → in the bearing",
          "[unit][imperfections]") {
  const deck::Deck deck =
      with("ball", {{"kReGeoImp", "2"}, {"kRaceGeoImp1", "1"}, {"kRaceGeoImp2", "2"}},
           {{"reDiaVar2", "3e-6"},
            {"reDiaVar11", "-1e-6"},
            {"rndVar11", "4e-6"},
            {"rndVar21", "-4e-6"},
            {"rndVar31", "30"},
            {"rndVar12", "1e-6"},
            {"rndVar22", "6"},
            {"rndVar32", "90"},
            {"cFacVar12", "0.001"},
            {"cFacVar22", "2"},
            {"cFacVar32", "45"}});
  const auto b = setup::build_bearing(deck);
  CHECK(b.imperfections.ball_diameter[1] == 3e-6);
  CHECK(b.imperfections.ball_diameter[10] == -1e-6);
  CHECK(b.imperfections.ball_diameter[0] == 0.0);
  constexpr double kDegree = std::numbers::pi / 180.0;
  const bearing::RaceErrors& outer = b.imperfections.race[0];
  CHECK(outer.roundness == bearing::RaceErrors::Roundness::Elliptical);
  CHECK(outer.variation[1] == -4e-6);
  CHECK(outer.variation[2] == Approx(30 * kDegree));
  const bearing::RaceErrors& inner = b.imperfections.race[1];
  CHECK(inner.roundness == bearing::RaceErrors::Roundness::Sinusoidal);
  CHECK(inner.variation[1] == 6.0);
  CHECK(inner.curvature_factor.phase == Approx(45 * kDegree));
  const auto s = statics::solve_ball_statics(b);
  CHECK(s.residual < 1e-9);
  const auto json = listing::imperfections_json(b);
  // Ball 1 stands at z: 30 degrees from the major axis, R ~ 4e-6 cos 2t.
  CHECK(json.at("outer race at the elements").at("radius [m]").at(0).get<double>() ==
        Approx(4e-6 * std::cos(60 * kDegree)).epsilon(1e-3));
}

TEST_CASE("imperfections: all deviations of random rollers and their lands → solved",
          "[unit][imperfections]") {
  const deck::Deck deck = with("cylindrical", {{"kReGeoImp", "1"}, {"kRaceGeoImp1", "2"}},
                               {{"reDiaVar", "1e-6"},
                                {"reCrnVar", "0.1"},
                                {"reLenVar", "1e-5"},
                                {"reCLVar", "2e-4"},
                                {"reCLOffset", "1e-4"},
                                {"rlTaper11", "1e-4"},
                                {"rlTaper21", "2"},
                                {"rlOffset11", "1e-4"}});
  const auto b = setup::build_bearing(deck);
  REQUIRE(b.rollers());
  const RandomTable table(setup::kDefaultSeed);
  CHECK(b.rollers()->deviation[5].diameter == 1e-6 * table.standard_normal(5, 0));
  CHECK(b.rollers()->deviation[5].crown_radius == 0.1 * table.standard_normal(5, 1));
  CHECK(b.rollers()->deviation[5].length == 1e-5 * table.standard_normal(5, 2));
  CHECK(b.rollers()->deviation[5].central_length == 2e-4 * table.standard_normal(5, 3));
  CHECK(b.rollers()->deviation[5].land_offset == 1e-4 * table.standard_normal(5, 4));
  CHECK(b.imperfections.race[0].taper.amplitude == 1e-4);
  CHECK(b.imperfections.race[0].land_offset.amplitude == 1e-4);
  auto held = b;
  held.constraints.displacement_given[0] = true;
  const auto s = statics::solve_roller_statics(held);
  CHECK(s.residual < 1e-9);
  listing::Report report("test", deck::UnitSystem::SI);
  listing::print_imperfections(report, b);
  CHECK(report.take().find("land offs") != std::string::npos);
}

TEST_CASE("imperfections: not supported → rejected by name", "[unit][imperfections]") {
  deck::Deck moving = with("ball", {{"kReGeoImp", "3"}}, {});
  moving.set("mode", "0");
  moving.complete();
  CHECK_THROWS_WITH(setup::build_bearing(moving),
                    Catch::Contains("kReGeoImp") && Catch::Contains("ADRX8"));
  const deck::Deck routine = with("ball", {{"kRaceGeoImp2", "3"}}, {});
  CHECK_THROWS_WITH(setup::build_bearing(routine), Catch::Contains("ADRX6"));
  const deck::Deck gone = with("ball", {{"kReGeoImp", "2"}}, {{"reDiaVar4", "-1"}});
  CHECK_THROWS_WITH(setup::build_bearing(gone), Catch::Contains("rolling element 4"));
  const deck::Deck open =
      with("ball", {{"kRaceGeoImp1", "2"}}, {{"rndVar11", "1e-6"}, {"rndVar21", "2.5"}});
  const auto issues = setup::check_buildable(open);
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].severity == Severity::Warning);
  CHECK(issues[0].text().find("rndVar21") != std::string::npos);
  deck::Deck open_in_motion = open;
  open_in_motion.set("mode", "0");
  open_in_motion.complete();
  CHECK_THROWS_WITH(setup::build_bearing(open_in_motion),
                    Catch::Contains("rndVar21") && Catch::Contains("give a whole number of waves"));
  open_in_motion.set("rndVar21", "3");
  CHECK_NOTHROW(setup::build_bearing(open_in_motion));
}
