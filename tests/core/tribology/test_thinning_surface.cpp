#include "tribology/film_law.hpp"
#include "tribology/pressure_fits.hpp"
#include "tribology/shear_thinning_film.hpp"
#include "tribology/thinning_surface.hpp"
#include "tribology/traction_curve.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

/// The surface that films which thin with shear are read from.
using namespace adore;
using namespace adore::tribology;

TEST_CASE("thinning surface: error within the run's tolerance everywhere", "[physics][film_law]") {
  for (const double n : {0.35, 0.4, 0.45, 0.74, 0.78})
    for (const double tolerance : {1e-4, 1e-6, 1e-7, 1e-9}) {
      const double half = 0.5 * (n - 1.0), wanted = target_thinning_error(tolerance);
      const ThinningSurface surface = thinning_surface(half, wanted);
      CAPTURE(n, tolerance, wanted, surface.error[0], surface.error[1], surface.size[0]);
      CHECK(surface.error[0] <= wanted);
      CHECK(surface.held_out > 9000);
      // Places of another kind than those it was measured at, by the law itself, against bisection.
      ShearThinningFriction film;
      film.modulus = 1.0;
      film.half_power = half;
      surface.give(film);
      double largest = 0.0;
      for (double rate = -9.9; rate < 35.0; rate += 1.137)
        for (double heat = -9.3; heat < 15.9; heat += 0.873) {
          // μ = 1, h = 1, Δu = r0, β/(8K) = S²/r0².
          const double slip = std::exp(rate), S = std::exp(heat);
          film.log_viscosity.c[0] = 0.0;
          film.log_heating.c[0] = heat - rate;
          const double kappa = film.at(ContactConditions<double>{}, 1.0)(slip, 1.0);
          const double stress =
              shear_thinning_stress({1.0, 1.0, 1.0, n, 2.0, 8.0 * S * S / (slip * slip), 1.0}, slip)
                  .thermal;
          largest = std::max(largest, std::abs(kappa / stress - 1.0));
        }
      CHECK(largest < 1.2 * wanted + 1e-7);
    }
}

TEST_CASE("thinning surface: points beyond it are solved", "[physics][film_law]") {
  ShearThinningFriction film;
  film.modulus = 1.0;
  film.half_power = -0.3;
  const ShearThinningFriction direct = film;
  thinning_surface(film.half_power, 3e-4).give(film);
  for (const auto& [rate, heat] : {std::pair{41.0, 3.0}, {3.0, 17.0}, {45.0, 20.0}}) {
    ShearThinningFriction one = film, other = direct;
    one.log_heating.c[0] = other.log_heating.c[0] = heat - rate;
    const double slip = std::exp(rate);
    CHECK(one.at(ContactConditions<double>{}, 1.0)(slip, 1.0) ==
          other.at(ContactConditions<double>{}, 1.0)(slip, 1.0));
  }
  // What is no number reads nothing beside the table, and stays none.
  CHECK(std::isnan(film.at(ContactConditions<double>{}, std::nan(""))(1.0, 1.0)));
}

TEST_CASE("filmStress: thinning interpolated or solved, and reported", "[unit][film_law]") {
  bearing::Lubrication lubrication;
  lubrication.code = 11;
  lubrication.critical_film = 1e-9;
  lubrication.meniscus = 10.0;
  RaceFilmInputs surface;
  surface.radius = 0.005;
  surface.modulus = 2.26e11;
  surface.wall_temperature = 350.0;
  surface.race_speed = 30.0;
  surface.width_over_pressure = 1.2e-13;
  const Lubricant& oil = lubricant(11);
  const std::string read = describe_film_evaluation(oil, lubrication, surface);
  CHECK_THAT(read,
             Catch::Contains("check points") && Catch::Contains("The tolerance of the run allows"));
  const TractionLaw by_surface =
      film_law(traction_curve(1, {0.0, 0.12, 0.08, 0.5}), oil, lubrication, surface);
  lubrication.direct_strips = true;
  CHECK(describe_film_evaluation(oil, lubrication, surface) ==
        "the shear stress is computed at each integration point");
  const TractionLaw solved =
      film_law(traction_curve(1, {0.0, 0.12, 0.08, 0.5}), oil, lubrication, surface);
  const auto fluid_of = [](const TractionLaw& law) {
    return law.visit([](const auto& one) -> const ShearThinningFriction* {
      if constexpr (std::is_same_v<std::decay_t<decltype(one)>, ThinningFilmLaw>)
        return &one.fluid;
      else
        return nullptr;
    });
  };
  REQUIRE(fluid_of(by_surface) != nullptr);
  CHECK(fluid_of(by_surface)->surface != nullptr);
  CHECK(fluid_of(solved)->surface == nullptr);
}

TEST_CASE("pressure fit in powers: equals its Chebyshev sum", "[unit][film_law]") {
  for (const double width : {0.3, 1.0}) {
    const auto value = [&](double p) {
      return 1.0 / (1.0 + std::pow((p - 1e9) / (width * 1e9), 2));
    };
    const PolynomialWithError fit = fit_over_pressure(value, 2e9, 1e-4);
    CAPTURE(width, fit.fit.terms, fit.error);
    for (double p = 0.0; p <= 2e9; p += 1.7e7)
      CHECK(std::abs(fit.fit.at(p) - value(p)) <= 1.3 * fit.error + 1e-12);
    CHECK(fit.error < (width < 0.5 ? 2e-2 : 1e-4));
  }
}
