#include "base/errors.hpp"
#include "tribology/lubricant.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace adore::tribology;

TEST_CASE("lubricants: every code of record 10.0 stands with its sources", "[unit][lubricants]") {
  const std::vector<int> codes = lubricant_codes();
  CHECK(codes.size() == 19);  // 1 to 20 without the user's own
  for (const int code : codes) {
    CAPTURE(code);
    const Lubricant& oil = lubricant(code);
    CHECK_FALSE(oil.name.empty());
    CHECK(oil.sources.size() > 10);
    CHECK((oil.provenance == "seen" || oil.provenance == "recalled" ||
           oil.provenance == "estimated"));
  }
  CHECK_THROWS_AS(lubricant(9), adore::InputError);
  CHECK_THROWS_AS(lubricant(21), adore::InputError);
}

TEST_CASE("lubricants: viscosity falls with temperature, rises with pressure, is a glass at most",
          "[physics][lubricants]") {
  for (const int code : lubricant_codes()) {
    CAPTURE(code);
    const Lubricant& oil = lubricant(code);
    double last = HUGE_VAL;
    for (double T = 223.15; T <= 473.15; T += 10.0) {
      CAPTURE(T);
      const double mu = oil.base_viscosity(T);
      CHECK(mu > 0.0);
      CHECK(mu <= 1.0000001e12);
      CHECK((mu < last || mu > 0.99e12));
      last = mu;
      CHECK(oil.base_beta(T) >= 0.0);
      CHECK(std::isfinite(oil.base_alpha(T)));
      if (T > 260.0) CHECK(oil.base_alpha(T) > 0.0);
      CHECK(oil.conductivity.at(T) > 0.03);
      CHECK(oil.density.at(T) > 500.0);
      double pressed = 0.0;
      for (const double p : {0.0, 0.5e9, 1e9, 2e9, 4e9}) {
        const double here = oil.viscosity_under_pressure(p, T);
        CHECK(std::isfinite(here));
        CHECK(here <= 1.0000001e12);
        CHECK(here >= pressed);
        pressed = here;
      }
    }
  }
}

TEST_CASE("viscosity: pressure coefficients by formula are those of the law",
          "[physics][lubricants][jacobian]") {
  for (const int code : lubricant_codes()) {
    CAPTURE(code);
    const Lubricant& oil = lubricant(code);
    for (const double T : {290.0, 330.0, 380.0, 420.0}) {
      CAPTURE(T);
      constexpr double kStep = 1e4;  // Pa; the second difference of ln μ is below 1e-5 of α there
      const double slope = (oil.base.log_at(kStep, T) - oil.base.log_at(0.0, T)) / kStep;
      CHECK(oil.base_alpha(T) == Approx(slope).epsilon(1e-3));
    }
  }
}

TEST_CASE("user lubricant: type II for the film and type I for the traction, at one temperature",
          "[unit][lubricants]") {
  const Lubricant oil = user_lubricant(
      {"mine", 313.0, 0.03, 1.5e-8, 4000.0, 0.14, 900.0, 2000.0, 0.2, 6e-9, 0.03, {}, 0.003});
  CHECK(oil.base_viscosity(313.0) == Approx(0.03));
  CHECK(oil.base_beta(350.0) == Approx(4000.0 / (350.0 * 350.0)).epsilon(1e-6));
  CHECK(oil.viscosity_under_pressure(1e9, 350.0) == Approx(0.2 * std::exp(6.0 - 0.03 * 37.0)));
  CHECK(oil.beta_under_pressure(1e9, 350.0) == 0.03);
}
