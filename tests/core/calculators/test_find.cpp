#include "base/errors.hpp"
#include "calculators/calculators.hpp"
#include "calculators/find.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace adore;
using calculators::find_in_calculator;

namespace {

/// Two equal spheres, R 50 mm, E 20 GPa, ν 0.3: R* = 25 mm, E* = 10.989 GPa.
const nlohmann::json kSpheres{{"body1", {{"Rx", 0.05}, {"Ry", 0.05}, {"E", 2e10}, {"nu", 0.3}}},
                              {"body2", {{"Rx", 0.05}, {"Ry", 0.05}, {"E", 2e10}, {"nu", 0.3}}},
                              {"load", 1.0},
                              {"stress_poisson", 0.3}};
constexpr double kRadius = 0.025, kModulus = 2e10 / (2.0 * (1.0 - 0.09));

FindReport ask(const char* target, double value) {
  return find_in_calculator("hertz", kSpheres, {"load", "", 1.0, 1e7},
                            {target, "", Relation::Equal, value});
}

}  // namespace

TEST_CASE("find in a calculator: Hertz load for approach, pressure, half width → closed forms",
          "[physics][find]") {
  // Published as code_aster SSNV104: approach 4 mm, a = sqrt(R* d) = 10 mm, F = 586,081 N.
  const double load = 4.0 / 3.0 * kModulus * std::sqrt(kRadius) * std::pow(4e-3, 1.5);
  CHECK(load == Approx(586081.0).epsilon(1e-6));
  for (const auto& [name, value] : {std::pair{"delta", 4e-3},
                                    {"b", 1e-2},
                                    {"p_max", 2.0 * kModulus * 0.01 / (M_PI * kRadius)}}) {
    INFO(name);
    const FindReport report = ask(name, value);
    REQUIRE(report.outcome.answer == FindAnswer::One);
    CHECK(report.outcome.solutions[0].x == Approx(load).epsilon(1e-8));
    CHECK(report.unknown.unit == "N");
    CHECK_FALSE(report.target.unit.empty());
  }
}

TEST_CASE("find in a calculator: thrust at which a ball begins to carry load", "[physics][find]") {
  // 6204 with 10 µm, 2000 N radial. An independent solver: 359.9 N load half of the balls, the two
  // at 90 degrees (third of eight) are about to touch.
  const nlohmann::json input{
      {"geometry",
       {{"Z", 8},
        {"D", 0.00794},
        {"dm", 0.0335},
        {"fi", 0.5201511335012594},
        {"fo", 0.5302267002518891},
        {"Pd", 1e-5}}},
      {"material",
       {{"ball", {{"E", 2.06e11}, {"nu", 0.3}, {"rho", 7800.0}}},
        {"race", {{"E", 2.06e11}, {"nu", 0.3}, {"rho", 7800.0}}}}},
      {"speed_rpm", 0},
      {"options", {{"curvature", "free"}, {"control", "outer"}, {"orbit", "per_ball"}}},
      {"applied_load", {{"Fx", 300}, {"Fy", 0}, {"Fz", 2000}}},
      {"prescribed_displacement", {{"thy", 0}, {"thz", 0}}}};
  const auto thrust = [&](const char* target) {
    const FindReport report =
        find_in_calculator("ball-statics", input, {"applied_load.Fx", "", 100.0, 1500.0},
                           {target, "", Relation::Equal, 0.0});
    REQUIRE(report.outcome.answer == FindAnswer::One);
    return report.outcome.solutions[0].x;
  };
  CHECK(thrust("Qi[3]") == Approx(359.9).epsilon(2e-4));
  // All balls: at the edge the groove centers of the ball opposite the load have their free
  // distance A again, ux² + (A cos α - uz)² = A², cos α = 1 - Pd/(2A); ux counts from the plane of
  // both grooves.
  nlohmann::json edge = input;
  edge["applied_load"]["Fx"] = thrust("least(Qi)");
  const nlohmann::json q = calculators::calculate("ball-statics", edge).at("displacement");
  const double A = (0.5201511335012594 + 0.5302267002518891 - 1.0) * 0.00794;
  CHECK(std::hypot(q.at("ux").get<double>(), A - 0.5 * 1e-5 - q.at("uz").get<double>()) ==
        Approx(A).epsilon(1e-7));
}

TEST_CASE("find in a calculator: whole-number input, wrong names", "[unit][find]") {
  CHECK_THROWS_WITH(ask("dleta", 1e-3), Catch::Contains("Did you mean delta"));
  CHECK_THROWS_WITH(find_in_calculator("hertz", kSpheres, {"laod", "", 1.0, 10.0},
                                       {"delta", "", Relation::Equal, 1e-6}),
                    Catch::Contains("laod"));
  CHECK_THROWS_AS(find_in_calculator("hertz", kSpheres, {"load[x]", "", 1.0, 10.0},
                                     {"delta", "", Relation::Equal, 1e-6}),
                  InputError);
}
