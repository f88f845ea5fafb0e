#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "runs/prepare.hpp"
#include "runs/solution_tables.hpp"
#include "statics/ball_friction.hpp"
#include "statics/stiffness_difference.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// Statics with the friction of balls in balance (statics/ball_friction.hpp) next to motion.
using namespace adore;
using nlohmann::json;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

/// 40° balls with little thrust: their gyroscopic moment slips.
deck::Deck thrust_deck(int mode, const Sets& more) {
  deck::Deck deck = deck::new_deck("ball");
  Sets sets{{"mode", fmt::format("{}", mode)},
            {"freeConAng", "40"},
            {"appLoadX", "500"},
            {"appLoadZ", "0"},
            {"nCseg", "0"},
            {"rpm2", "7000"}};
  if (mode >= 0)
    sets.insert(sets.end(), {{"kPrtOpt", "0"},
                             {"kPltFreq", "1000"},
                             {"kAGraf", "0"},
                             {"kLifeFreq", "0"},
                             {"kNumPltElem", "1"},
                             {"kPltElemInd", "1"},
                             {"maxStps", "1000000"},
                             {"gravityVecZ", "0"}});
  for (const auto& [name, value] : more) {
    std::erase_if(sets, [&](const auto& one) { return one.first == name; });
    sets.emplace_back(name, value);
  }
  deck.set_all(sets);
  return deck;
}

runs::Prepared prepared(deck::Deck deck) {
  runs::LoadedDeck input;
  input.path = runs::kStandardInput;
  input.deck = std::move(deck);
  return runs::prepare(std::move(input));
}

/// Race heat [W] of mode 2, without rolling resistance, between two ends in revolutions.
double heat_of_motion(const Sets& more, const std::array<double, 2>& ends) {
  const testing::TemporaryFolder folder;
  const deck::Deck deck = thrust_deck(2, more);
  deck::write_deck(deck, folder / "DATA.txt");
  const double turn = 60.0 / deck.real("rpm2");
  double heat[2] = {0.0, 0.0};
  for (const std::size_t part : {0UL, 1UL}) {
    runs::RunRequest request;
    request.deck = folder / "DATA.txt";
    request.until = fmt::format("{}s", ends[part] * turn);
    // The default rule of motion has 2 % less heat of these films.
    request.options = {{"ellipseMajor", "60"}, {"ellipseMinor", "12"}};
    request.go_on = part > 0;
    runs::run(request);
    const json report = json::parse(testing::read_bytes(folder / "RUN.json"));
    for (const auto& [name, value] : report.at("conservation").at("energy").items())
      if (name.starts_with("heat, ") && name.find("race contacts") != std::string::npos)
        heat[part] += value.get<double>();
  }
  return (heat[1] - heat[0]) / ((ends[1] - ends[0]) * turn);
}

}  // namespace

TEST_CASE("ball friction in statics: race heat of light 40 degree balls is that of motion",
          "[physics][statics][modes]") {
  Sets oil{{"kTrac", "4"},
           {"reRaceFilm", "1.0e-8"},
           {"strParam", "10.0"},
           {"appLoadX", "800"},
           {"rpm2", "6000"}};
  for (const char* name :
       {"roomTemp", "hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp", "cageTemp"})
    oil.emplace_back(name, "340");
  // Dry, the spin rule would need a coefficient of 0.075 of the 0.06 that there are. In oil the
  // spin axis takes two revolutions to settle, from pure rolling.
  for (const auto& [more, ends] : {std::pair<Sets, std::array<double, 2>>{{}, {0.5, 1.0}},
                                   std::pair<Sets, std::array<double, 2>>{oil, {2.0, 3.0}}}) {
    const runs::Prepared at = prepared(thrust_deck(-1, more));
    const statics::FrictionEstimate& friction = *at.friction;
    const double motion = heat_of_motion(more, ends);
    double still = 0.0;
    for (int j : {0, 1}) still += friction.of_race(j).total() - friction.of_race(j).rolling;
    INFO((more.empty() ? "dry" : "oil"));
    CHECK(still == Approx(motion).epsilon(0.005));
    for (const std::string& note : friction.notes)
      CHECK(note.find("no friction equilibrium") == std::string::npos);
  }
}

TEST_CASE("ball friction in statics: tractions along both ellipses carry the gyroscopic moment",
          "[physics][statics][analytic]") {
  const runs::Prepared at = prepared(thrust_deck(-1, {}));
  statics::StaticSolution solution = statics::solve_ball_statics(at.bearing);
  const statics::FrictionBalance found =
      statics::solve_ball_friction_balance(at.bearing, runs::ball_statics_options(at), solution);
  REQUIRE(found.left.empty());
  for (const statics::BallMotion& ball : found.balls) {
    REQUIRE(ball.balanced);
    // About e_θ: (f_o + f_i) D/2 = J ω_m ω_r; the arc of the contact is at most 2 % lower.
    const double moment = at.bearing.element_inertia.moments.x() * ball.orbit * ball.omega[1];
    CHECK((ball.along[0] + ball.along[1]) * 0.5 * at.bearing.element_diameter() ==
          Approx(moment).epsilon(0.02));
    CHECK(std::abs(ball.omega[2]) > 1e-3 * std::abs(ball.omega[0]));  // it slips
    CHECK(ball.along[1] / ball.along[0] > 0.1);  // both races, not one in control
  }
}

TEST_CASE("ball friction in statics: reported speeds are those of the balance and give its heat",
          "[physics][statics]") {
  for (const Sets& more :
       {Sets{}, Sets{{"appLoadZ", "300"}, {"appLoadX", "1500"}}, Sets{{"rpm2", "50"}}}) {
    const runs::Prepared at = prepared(thrust_deck(-1, more));
    statics::StaticSolution again = statics::solve_ball_statics(at.bearing);
    const statics::FrictionBalance found =
        statics::solve_ball_friction_balance(at.bearing, runs::ball_statics_options(at), again);
    const statics::ContactLaws laws(at.bearing);
    const tribology::EllipseRule rule = tribology::make_split_ellipse_rule(30, 8);
    const double gamma = at.bearing.element_diameter() / at.bearing.pitch_diameter();
    const auto table = runs::solution_tables(at).tables.front();
    for (std::size_t k = 0; k < at.statics.balls.size(); ++k) {
      const statics::StaticBall& ball = at.statics.balls[k];
      REQUIRE(found.balls[k].balanced);
      CHECK(ball.orbital_speed == found.balls[k].orbit);
      CHECK(ball.omega_theta == found.balls[k].omega[2]);
      statics::BallMotion shown;
      shown.omega = {ball.omega_x, ball.omega_r, ball.omega_theta};
      shown.orbit = ball.orbital_speed;
      double along = 0.0;
      for (const std::size_t j : {0UL, 1UL}) {
        const statics::BallContact contact = statics::ball_contact(at.bearing, laws, ball, j);
        const auto slip = statics::contact_kinematics(at.bearing, contact, shown, ball.r, j);
        CHECK(contact.film.speed == Approx(slip.entrainment).epsilon(1e-9));
        const auto traction = tribology::ellipse_traction(contact.law, contact.ellipse, slip, rule);
        const statics::FrictionOfContact& heat = at.friction->race[j][k];
        CHECK(traction.heat == Approx(heat.spin + heat.sliding).epsilon(1e-9));
        CHECK(ball.friction[j] == Approx(std::abs(traction.F_c) / ball.Q[j]).epsilon(0.01));
        along += traction.F_t;
        // spin.hpp: σ_o = γ sin α - (1 + γ cos α) tan(α - β), σ_i with the other signs.
        const double side = j == 0 ? -1.0 : 1.0, alpha = ball.alpha[j];
        CHECK(ball.spin_roll[j] ==
              Approx(gamma * std::sin(alpha) + side * (1.0 - side * gamma * std::cos(alpha)) *
                                                   std::tan(alpha - ball.pitch_angle))
                  .margin(0.01));
        CHECK(table.find(j == 0 ? "outer spin to roll" : "inner spin to roll")->values[k] ==
              ball.spin_roll[j]);
      }
      // Nothing else holds the ball along its orbit; nodes differ from those of the balance.
      CHECK(std::abs(along) < 1e-3 * ball.Q[0]);
    }
  }
}

TEST_CASE("ball friction in statics: stiffness is the slope of the load, tractions follow",
          "[physics][statics]") {
  // The last: balls with little load, whose spin axes turn along the orbit.
  for (const Sets& more : {Sets{}, Sets{{"appLoadZ", "300"}, {"appLoadX", "1500"}},
                           Sets{{"appLoadZ", "300"}, {"appLoadX", "600"}, {"rpm2", "5000"}}}) {
    const runs::Prepared at = prepared(thrust_deck(-1, more));
    const statics::BallStaticsOptions options = runs::ball_statics_options(at);
    bearing::Bearing held = at.bearing;
    held.constraints.displacement_given.fill(true);
    const double step = 0.01 * at.statics.max_deflection;
    for (const std::size_t along : {0UL, 2UL}) {
      std::array<double, 2> load{};
      for (const std::size_t side : {0UL, 1UL}) {
        held.constraints.displacement = at.statics.displacement;
        held.constraints.displacement[along] += side == 1 ? step : -step;
        statics::StaticSolution moved = statics::solve_ball_statics(held, options);
        REQUIRE(statics::solve_ball_friction_balance(held, options, moved).left.empty());
        load[side] = moved.load[along];
      }
      const auto k = static_cast<Eigen::Index>(along);
      const double slope = (load[1] - load[0]) / (2.0 * step);
      INFO(along << " " << slope << " " << at.statics.stiffness(k, k));
      CHECK(at.statics.stiffness(k, k) == Approx(slope).epsilon(1e-3));
    }
    // The table of stiffness over speed: the same by its own differences.
    statics::BallStaticsOptions by_difference = options;
    by_difference.difference_share = 0.01;
    statics::StaticSolution solution = statics::solve_ball_statics(at.bearing, by_difference);
    REQUIRE(statics::solve_ball_friction_balance(at.bearing, by_difference, solution).left.empty());
    REQUIRE(solution.stiffness_by_difference);
    CHECK(statics::stiffness_disagreement(solution.stiffness, *solution.stiffness_by_difference) <
          1e-3);
  }
}

TEST_CASE("ball friction in statics: motions start with the specified load and in their motion",
          "[physics][statics][modes]") {
  // By the spin rule the race held at its place carries 3.6 % less, and balls push their pockets.
  const testing::TemporaryFolder folder;
  std::array<double, 2> departure{}, pockets{};
  for (const std::size_t balanced : {0UL, 1UL}) {
    deck::Deck deck = deck::new_deck("ball");
    deck.set_all(Sets{{"mode", "1"}, {"kPrtOpt", "0"}, {"kAGraf", "0"}, {"kLifeFreq", "0"}});
    deck::write_deck(deck, folder / "DATA.txt");
    runs::RunRequest request;
    request.deck = folder / "DATA.txt";
    request.until = "0.5rev";
    request.options = {{"ballFriction", balanced == 1 ? "balance" : "spin-rule"}};
    request.overwrite = true;
    runs::run(request);
    const json report = json::parse(testing::read_bytes(folder / "RUN.json"));
    departure[balanced] =
        report.at("load carried by the elements").at("departure from the asked load").get<double>();
    pockets[balanced] =
        report.at("conservation").at("energy").at("heat, cage pockets [J]").get<double>();
  }
  CHECK(departure[1] < 0.01);
  CHECK(departure[1] < 0.3 * departure[0]);
  CHECK(pockets[1] < 0.5 * pockets[0]);
}

TEST_CASE("ball friction in statics: light balls keep their orbit by a cage, or nearly by inertia",
          "[physics][statics]") {
  const Sets sets{{"appLoadX", "400"}, {"appLoadZ", "520"}, {"rpm2", "3000"}};
  Sets with_cage = sets;
  with_cage.emplace_back("nCseg", "1");
  const runs::Prepared alone = prepared(thrust_deck(-1, sets)),
                       caged = prepared(thrust_deck(-1, with_cage));
  const auto orbits = [](const runs::Prepared& of) {
    std::vector<double> out;
    for (const statics::StaticBall& ball : of.statics.balls) out.push_back(ball.orbital_speed);
    return out;
  };
  const auto lightest = [](const runs::Prepared& of) { return of.statics.balls[6]; };
  const std::vector<double> free = orbits(alone), carried = orbits(caged);
  const auto [slow, fast] = std::minmax_element(free.begin(), free.end());
  // At once, without m r ω dω/dθ, they would orbit 1.5 times as fast as loaded ones.
  CHECK(*fast == Approx(*slow).epsilon(0.06));
  CHECK(*fast > 1.02 * *slow);
  // The angle of a ball varies by the clearance of its pocket.
  double mean = 0.0, place = 0.0, least = 0.0, most = 0.0;
  for (const double orbit : carried) mean += orbit / static_cast<double>(carried.size());
  for (std::size_t k = 0; k < carried.size(); ++k) {
    place += (carried[k] / mean - 1.0) * 2.0 * std::numbers::pi /
             static_cast<double>(carried.size()) * caged.statics.balls[k].r;
    least = std::min(least, place);
    most = std::max(most, place);
  }
  REQUIRE(caged.bearing.cage);
  CHECK(most - least == Approx(caged.bearing.cage->pocket_clearance_1).epsilon(0.05));
  CHECK(mean == Approx(free[0]).epsilon(0.02));  // of the heaviest ball
  const statics::StaticBall ball = lightest(caged);
  CHECK(ball.centrifugal_force ==
        Approx(caged.bearing.element_inertia.mass * 0.5 * caged.bearing.balls().pitch_diameter *
               ball.orbital_speed * ball.orbital_speed)
            .epsilon(1e-6));
  CHECK(ball.Q[0] == Approx(lightest(alone).Q[0]).epsilon(0.1));
  // Under thrust all orbits are the same: nothing is carried.
  Sets axial{{"nCseg", "1"}};
  const std::vector<double> same = orbits(prepared(thrust_deck(-1, axial)));
  CHECK(same == orbits(prepared(thrust_deck(-1, {}))));
}

TEST_CASE("ball friction in statics: turning spin axes of light balls have the heat of motion",
          "[physics][statics][modes]") {
  const Sets light{{"appLoadX", "600"}, {"appLoadZ", "300"}, {"rpm2", "5000"}};
  const runs::Prepared at = prepared(thrust_deck(-1, light));
  statics::StaticSolution solution = statics::solve_ball_statics(at.bearing);
  const statics::FrictionBalance found =
      statics::solve_ball_friction_balance(at.bearing, runs::ball_statics_options(at), solution);
  INFO(found.turning);
  REQUIRE(found.findings().empty());
  CHECK(found.turning > 0.1);
  double still = 0.0;
  for (int j : {0, 1}) still += at.friction->of_race(j).total() - at.friction->of_race(j).rolling;
  CHECK(still == Approx(heat_of_motion(light, {3.0, 6.0})).epsilon(0.005));
  // Under thrust nothing turns. The stiffness has the moment even there: a small radial load would
  // turn spin axes.
  const runs::Prepared axial = prepared(thrust_deck(-1, {}));
  for (const statics::StaticBall& ball : axial.statics.balls)
    CHECK(ball.orbital_speed == Approx(axial.statics.balls[0].orbital_speed).epsilon(1e-9));
}

TEST_CASE("ball friction in statics: a slow ball has the loads of the spin rule",
          "[physics][statics]") {
  const Sets slow{{"rpm2", "50"}};
  const runs::Prepared at = prepared(thrust_deck(-1, slow));
  const statics::StaticSolution rule = statics::solve_ball_statics(at.bearing);
  for (std::size_t i = 0; i < rule.balls.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j)
      CHECK(at.statics.balls[i].Q[j] == Approx(rule.balls[i].Q[j]).epsilon(1e-3));
}

TEST_CASE("ball friction in statics: a given spin axis keeps the spin rule", "[physics][statics]") {
  const runs::Prepared at = prepared(thrust_deck(-1, {{"kAngVel", "2"}, {"angVelOrient", "30"}}));
  statics::StaticSolution solution = statics::solve_ball_statics(at.bearing);
  const double before = solution.balls[0].Q[0];
  CHECK(statics::solve_ball_friction_balance(at.bearing, runs::ball_statics_options(at), solution)
            .balls.empty());
  CHECK(solution.balls[0].Q[0] == before);
}

TEST_CASE(
    "ball friction in statics: the user's traction law -> no friction, no other curve instead",
    "[physics][statics]") {
  const runs::Prepared at = prepared(thrust_deck(-1, {{"kTrac", "-1"}}));
  CHECK_FALSE(at.friction.has_value());
  for (const statics::StaticBall& ball : at.statics.balls) CHECK(ball.omega_theta == 0.0);
  CHECK(std::any_of(at.input.warnings.begin(), at.input.warnings.end(),
                    [](const Finding& one) { return one.code == "user.idle"; }));
}
