#include "base/errors.hpp"
#include "deck/catalogue.hpp"
#include "deck/templates.hpp"
#include "design/find.hpp"
#include "life/iso281.hpp"
#include "runs/equilibrium.hpp"
#include "runs/prepare.hpp"
#include "runs/static_quantities.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

using namespace adore;
using design::find_in_deck;
using design::FindRequest;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

FindRequest ask(const std::string& bearing, const Sets& sets, const std::string& unknown,
                const std::string& target) {
  FindRequest request;
  request.deck = "deck";
  request.in_memory = true;
  request.text = bearing.find_first_of("0123456789") == 0
                     ? deck::catalogue_deck(deck::find_bearing(bearing))
                     : std::string(deck::template_text(bearing));
  request.sets = sets;
  request.sets.emplace_back("mode", "-1");
  request.unknown = parse_unknown(unknown);
  request.target = parse_target(target);
  return request;
}

runs::Prepared at(FindRequest request, double x) {
  request.changes.emplace_back(request.unknown.name, fmt::format("{:.17g}", x));
  return runs::prepare(request);
}

const Sets kAtRest{{"rpm1", "0"}, {"rpm2", "0"}};

Sets with(Sets base, const Sets& more) {
  base.insert(base.end(), more.begin(), more.end());
  return base;
}

}  // namespace

TEST_CASE("find: least thrust that keeps all balls loaded, angular contact → edge of contact",
          "[physics][find]") {
  const FindRequest request =
      ask("7210 B",
          with(kAtRest, {{"appLoadY", "0"}, {"appLoadZ", "500"}, {"kFS4", "1"}, {"kFS5", "1"}}),
          "appLoadX=10:5000", "least_element_load_N=0");
  const FindReport report = find_in_deck(request);
  REQUIRE(report.outcome.answer == FindAnswer::One);
  const FindSolution& one = report.outcome.solutions[0];
  CHECK(one.kind == FindSolutionKind::Range);
  CHECK(report.unknown.unit == "N");
  // Just below a ball is unloaded, just above all are loaded.
  const auto least = [&](double x) {
    const runs::Prepared prepared = at(request, x);
    double out = 1e30;
    for (const statics::StaticBall& ball : prepared.statics.balls) out = std::min(out, ball.Q[1]);
    return out;
  };
  CHECK(least(0.999 * one.x) == 0.0);
  CHECK(least(1.001 * one.x) > 0.0);
  // Closed form with a constant contact angle: Q_k ~ (1 + cos θ_k)^1.5 where the approach of the
  // least loaded ball is 0 (ε = 1), F_r tan α / F_a = Σ Q cos θ / Σ Q.
  const runs::Prepared edge = at(request, one.x);
  double sum = 0.0, along = 0.0;
  const auto n = edge.statics.balls.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double c = std::cos(edge.statics.balls[k].azimuth);
    sum += std::pow(1.0 + c, 1.5);
    along += std::pow(1.0 + c, 1.5) * c;
  }
  const double alpha = edge.bearing.balls().contact_angle;
  CHECK(one.x == Approx(500.0 * std::tan(alpha) * sum / along).epsilon(0.03));
}

TEST_CASE("find: speed of the gyroscopic pivot → moment equals friction", "[physics][find]") {
  FindRequest request = ask("7210 B",
                            {{"appLoadX", "200"},
                             {"appLoadY", "0"},
                             {"appLoadZ", "0"},
                             {"kFS4", "1"},
                             {"kFS5", "1"},
                             {"rpm1", "0"}},
                            "rpm2=500:5000", "gyroscopic_ratio=1");
  const FindReport report = find_in_deck(request);
  REQUIRE(report.outcome.answer == FindAnswer::One);
  const double rpm = report.outcome.solutions[0].x;
  // The search asks the spin rule, although balls of the deck are in balance of friction.
  request.options.emplace_back("ballFriction", "spin-rule");
  const runs::Prepared prepared = at(request, rpm);
  const statics::StaticBall& ball = prepared.statics.balls.front();
  const bearing::BallGeometry& g = prepared.bearing.balls();
  const double limit =
      runs::available_friction(prepared.input.deck, prepared.bearing).value_or(0.06);
  // M_g = J ω_m ω_R sin β, J = m D²/10; the listed β leaves 0.1 % to the moment of the solution.
  const double J = prepared.bearing.element_inertia.moments.x();
  CHECK(
      ball.gyroscopic_moment ==
      Approx(J * ball.orbital_speed * ball.spin_speed * std::sin(ball.pitch_angle)).epsilon(2e-3));
  // The friction of both races, F_j = μ_j Q_j at the radius D/2, carries the moment.
  CHECK(ball.friction[0] * ball.Q[0] + ball.friction[1] * ball.Q[1] ==
        Approx(2.0 * std::abs(ball.gyroscopic_moment) / g.diameter).epsilon(1e-6));
  CHECK(std::max(ball.friction[0], ball.friction[1]) == Approx(limit).epsilon(1e-6));
  // M_g ~ Ω² and Q_i by the thrust: four times the thrust allows about twice the speed.
  FindRequest more = request;
  more.sets.front().second = "800";
  more.unknown.last = 9000.0;
  CHECK(find_in_deck(more).outcome.solutions.at(0).x / rpm == Approx(2.0).epsilon(0.1));
}

TEST_CASE("find: fit for a clearance, load for a pressure → the deck has them there",
          "[physics][find]") {
  const FindRequest fit =
      ask("6205", {{"appLoadX", "100"}}, "raceFit2=0:3e-5", "operating_clearance_m=2e-6");
  const FindReport report = find_in_deck(fit);
  REQUIRE(report.outcome.answer == FindAnswer::One);
  const auto solved = at(fit, report.outcome.solutions[0].x);
  REQUIRE(solved.bearing.operating);
  CHECK(solved.bearing.operating->operating.clearance == Approx(2e-6).epsilon(1e-6));

  const FindReport load =
      find_in_deck(ask("cylindrical", kAtRest, "appLoadZ=100:50000", "largest_pressure_Pa=1.5e9"));
  REQUIRE(load.outcome.solutions.size() == 1);
  CHECK(load.outcome.solutions[0].value == Approx(1.5e9).epsilon(1e-6));
}

TEST_CASE("find: viscosity of the user lubricant for kappa → ISO 281 reference viscosity",
          "[physics][find]") {
  const FindRequest request = ask("6205",
                                  {{"appLoadX", "100"},
                                   {"rpm1", "0"},
                                   {"rpm2", "1800"},
                                   {"kTrac", "9"},
                                   {"refVis", "0.02"},
                                   {"refTemp", "293.15"},
                                   {"prVisCoeff", "1e-8"},
                                   {"tempVisCoeff", "3000"},
                                   {"lubTherCond", "0.14"},
                                   {"lubDen", "900"},
                                   {"lubSpHeat", "2000"},
                                   {"refTracVis", "0.02"},
                                   {"tracVisCoeff1", "1e-8"},
                                   {"tracVisCoeff2", "0.03"}},
                                  "refVis=1e-3:0.5", "viscosity_ratio=2");
  FindReport report;
  try {
    report = find_in_deck(request);
  } catch (const InputError& error) {
    FAIL(error.what());
  }
  REQUIRE(report.outcome.answer == FindAnswer::One);
  const auto solved = at(request, report.outcome.solutions[0].x);
  const double nu1 = life::iso_reference_viscosity(1800.0, 1e3 * solved.bearing.pitch_diameter());
  const double eta =
      std::min(solved.statics.films->viscosity[0], solved.statics.films->viscosity[1]);
  CHECK(1e6 * eta / 900.0 / nu1 == Approx(2.0).epsilon(1e-6));
}

TEST_CASE("find: quiet load → variable compliance changes its sign", "[physics][find]") {
  // 6206-like: +0.159 µm at 10 µm and 500 N, -0.343 µm at 20 µm and 100 N (own solver).
  Sets sets = with(kAtRest, {{"appLoadX", "0"},
                             {"appLoadY", "0"},
                             {"appLoadZ", "-500"},
                             {"kFS1", "1"},
                             {"kFS4", "1"},
                             {"kFS5", "1"},
                             {"freeConAng", "0"},
                             {"freeIntCls", "1e-5"}});
  const FindReport report =
      find_in_deck(ask("6206", sets, "appLoadZ=-1500:-30", "variable_compliance_m=0"));
  REQUIRE_FALSE(report.outcome.solutions.empty());
  const FindRequest request = ask("6206", sets, "appLoadZ=-1500:-30", "variable_compliance_m=0");
  const double quiet = report.outcome.solutions[0].x;
  const auto difference = [&](double x) {
    return runs::variable_compliance(at(request, x)).difference;
  };
  CHECK(difference(1.05 * quiet) * difference(0.95 * quiet) < 0.0);
  CHECK(runs::variable_compliance(at(request, quiet)).span >= 0.0);
  // Without a radial force there is none.
  sets.emplace_back("kFS3", "1");
  CHECK_THROWS_WITH(find_in_deck(ask("6206", sets, "rpm2=10:100", "variable_compliance_m=0")),
                    Catch::Contains("radial force"));
}

TEST_CASE("find: wrong or idle names → errors with a remedy", "[unit][find]") {
  CHECK_THROWS_WITH(find_in_deck(ask("ball", {}, "apLoadX=1:2", "load_x_N=1")),
                    Catch::Contains("appLoadX"));
  CHECK_THROWS_WITH(find_in_deck(ask("ball", {}, "appLoadX=1:2", "lode_x_N=1")),
                    Catch::Contains("load_x_N"));
  CHECK_THROWS_WITH(find_in_deck(ask("ball", {}, "appLoadX=1:2", "mean_load_x_N=1")),
                    Catch::Contains("there is no result"));
  CHECK_THROWS_WITH(find_in_deck(ask("ball", {}, "recID=1:2", "load_x_N=1")),
                    Catch::Contains("recID"));
  CHECK_THROWS_WITH(
      find_in_deck(ask("cylindrical", {}, "appLoadZ=1000:2000", "gyroscopic_ratio=1")),
      Catch::Contains("does not have this result"));
  // kFS1 = 1 gives the displacement: the force is not used.
  CHECK_THROWS_WITH(
      find_in_deck(ask("ball", {{"kFS1", "1"}}, "appLoadX=1:2", "largest_contact_load_N=1")),
      Catch::Contains("does not use it"));
}

TEST_CASE("find: whole-number variable and run option as unknown", "[unit][find]") {
  const FindReport count =
      find_in_deck(ask("ball", with(kAtRest, {}), "nRe=4:8", "largest_contact_load_N=least"));
  CHECK(count.outcome.solutions.at(0).x == std::round(count.outcome.solutions[0].x));
  const FindReport option = find_in_deck(ask("ball", {}, "lifeSkip=0:5", "load_x_N=1"));
  CHECK(option.outcome.constant);
}

TEST_CASE("find questions: each names a known result and variable", "[unit][find]") {
  const auto results = design::find_results();
  for (const design::FindQuestion& one : design::find_questions()) {
    CAPTURE(one.name);
    CHECK(std::string(one.example).find(one.name) != std::string::npos);
    const auto asked =
        design::parse_question(std::string(one.name) + (one.value.empty() ? "=1" : ""));
    CHECK(asked.question == &one);
    if (!one.calculator.empty()) continue;
    CHECK_FALSE(deck::find_variable(one.unknown).empty());
    CHECK(std::any_of(results.begin(), results.end(),
                      [&](const auto& result) { return result.id == one.target; }));
  }
  CHECK_THROWS_WITH(design::parse_question("quiet-laod"), Catch::Contains("quiet-load"));
  CHECK_THROWS_WITH(design::parse_question("clearance-for-life"), Catch::Contains("needs a value"));
  const auto meaning = std::find_if(results.begin(), results.end(),
                                    [](const auto& one) { return one.id == "gyroscopic_ratio"; });
  REQUIRE(meaning != results.end());
  CHECK(meaning->meaning.find("a ball pivots if this ratio is above 1") != std::string::npos);
}
