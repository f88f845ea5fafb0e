#include "base/errors.hpp"
#include "calculators/calculators.hpp"
#include "calculators/lubricant_curves.hpp"
#include "tribology/lubricant.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

using namespace adore;
using calculators::LubricantContact;
using calculators::LubricantContactResult;

namespace {

// Visco-elastic films take a second each to set up.
bool is_slow(int code) {
  return tribology::lubricant(code).model == tribology::LubricantModel::ViscoElastic;
}

}  // namespace

TEST_CASE("traction of lubricants: odd in slip, 0 at zero slip, decreasing with temperature",
          "[physics][film]") {
  const std::vector<double> slips{0.0, 0.01, 0.1, 1.0, -0.01, -0.1, -1.0};
  for (const int code : tribology::lubricant_codes()) {
    if (is_slow(code)) continue;
    CAPTURE(code);
    LubricantContact c;
    c.code = code;
    c.speed = 20.0;
    c.critical_film = 0.0;  // full film
    std::vector<double> hottest;
    for (const double T : {340.0, 370.0, 400.0}) {
      c.temperature = T;
      const LubricantContactResult p = calculators::solve_lubricant_contact(c, slips);
      CHECK(p.traction[0] == 0.0);
      for (std::size_t i = 1; i < 4; ++i) {
        CHECK(p.traction[i] > 0.0);
        CHECK(p.traction[i + 3] == Approx(-p.traction[i]).epsilon(1e-12));
      }
      hottest.push_back(p.traction[2]);
    }
    CHECK(hottest[1] < hottest[0]);
    CHECK(hottest[2] < hottest[1]);
  }
}

TEST_CASE("film: increases with speed; cold, cryogenic and 4 GPa → finite numbers",
          "[physics][film]") {
  for (const int code : tribology::lubricant_codes()) {
    CAPTURE(code);
    LubricantContact c;
    c.code = code;
    double before = 0.0;
    for (const double speed : {0.0, 0.01, 0.1, 1.0, 10.0, 100.0}) {
      c.speed = speed;
      const LubricantContactResult p = calculators::solve_lubricant_contact(c, {});
      if (speed == 0.0) {
        CHECK(p.central == 0.0);
        continue;
      }
      const double isothermal = p.central / (p.thermal * p.starvation);
      CHECK(isothermal > before);
      before = isothermal;
    }
    if (is_slow(code)) continue;
    c.speed = 10.0;
    for (const double T : {223.15, 95.0, 450.0})
      for (const double pressure : {1e6, 4e9}) {
        c.temperature = T;
        c.pressure = pressure;
        const LubricantContactResult p = calculators::solve_lubricant_contact(c, {1e-6, 0.5, 50.0});
        CAPTURE(T, pressure);
        for (const double kappa : p.traction) CHECK(std::isfinite(kappa));
      }
  }
}

TEST_CASE("calc traction: film, lambda and traction; impossible contact → error", "[unit][film]") {
  const nlohmann::json in{{"kTrac", 4}, {"T", 360.0}, {"slip", {0.1, -0.1}}};
  const nlohmann::json out = calculators::calculate("traction", in);
  CHECK(out.at("kappa").size() == 2);
  CHECK(out.at("hMin").get<double>() < out.at("hCentral").get<double>());
  CHECK(out.at("lambda").get<double>() == Approx(out.at("hMin").get<double>() / 1e-7));
  for (const nlohmann::json& bad :
       {nlohmann::json{{"kTrac", 9}, {"slip", {0.1}}}, nlohmann::json{{"kTrac", 4}},
        nlohmann::json{{"kTrac", 4}, {"slip", {0.1}}, {"radius", 1.0}},
        nlohmann::json{{"kTrac", 4}, {"slip", {0.1}}, {"speed", -1.0}}})
    CHECK_THROWS_AS(calculators::calculate("traction", bad), InputError);
}

TEST_CASE("charts of a lubricant: one curve for each of four pressures and three temperatures",
          "[unit][film]") {
  LubricantContact c;
  c.code = 4;
  const calculators::LubricantCurves all = calculators::lubricant_curves(c);
  CHECK(all.traction.curves.size() == 4);
  CHECK(all.viscosity.curves.size() == 3);
  CHECK(all.film.curves.size() == 3);
  CHECK(all.lambda.curves.size() == 3);
  CHECK(all.name.find("23699") != std::string::npos);
  CHECK_FALSE(all.beyond_heating);
  LubricantContact cold = c;
  cold.temperature = 223.15;
  CHECK(calculators::lubricant_curves(cold).beyond_heating);
  for (const auto* chart : {&all.traction, &all.viscosity, &all.film, &all.lambda})
    for (const calculators::NamedCurve& curve : chart->curves) {
      CHECK(curve.x.size() == curve.y.size());
      for (const double y : curve.y) CHECK((std::isfinite(y) && y > 0.0));
    }
}
