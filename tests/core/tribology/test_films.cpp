#include "tribology/film_thickness.hpp"
#include "tribology/flash_strip.hpp"
#include "tribology/newton_film.hpp"
#include "tribology/newton_film_walls.hpp"
#include "tribology/shear_thinning_film.hpp"
#include "tribology/starvation.hpp"
#include "tribology/thermal_reduction.hpp"
#include "tribology/viscoelastic_strip.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace adore::tribology;

namespace {

/// Newtonian film at p = 0 whose viscosity falls by exp(-β ΔT), walls at one temperature: energy
/// equation in closed form, τ = μ U/h · asinh(S)/(S √(1 + S²)), S = U √(β μ/(8 K)). [derived]
double heated_newton(const NewtonFilm& film, double slip) {
  const double S =
      slip * std::sqrt(film.temperature_exponent * film.viscosity / (8.0 * film.conductivity));
  return film.viscosity * slip / film.thickness * std::asinh(S) / (S * std::sqrt(1.0 + S * S));
}

}  // namespace

TEST_CASE("film thickness: nothing at no speed, grows with speed, finite at no load",
          "[physics][film]") {
  double last_point = 0.0, last_line = 0.0;
  for (const double u : {0.0, 1e-6, 1e-3, 1.0, 10.0, 100.0, 1000.0}) {
    const FilmInlet inlet{0.02, 1.5e-8, u, 2.26e11};
    const FilmThickness point = point_film(inlet, 0.005, 300.0, 6.0),
                        line = line_film(inlet, 0.005, 1e5);
    if (u == 0.0) {
      CHECK(point.central == 0.0);
      CHECK(line.minimum == 0.0);
    } else {
      CHECK(point.central > last_point);
      CHECK(line.central > last_line);
    }
    CHECK(point.minimum <= point.central);
    CHECK(line.minimum <= line.central);
    last_point = point.central;
    last_line = line.central;
  }
  CHECK(std::isfinite(point_film({0.02, 1.5e-8, 5.0, 2.26e11}, 0.005, 0.0, 6.0).central));
}

TEST_CASE("film thickness: both point formulas agree within 10 % where both hold",
          "[physics][film]") {
  const FilmInlet inlet{0.02, 1.5e-8, 8.0, 2.26e11};
  for (const double ratio : {3.0, 6.0, 10.0}) {
    const double k = 1.03 * std::pow(ratio, 0.64);
    CHECK(point_film(inlet, 0.005, 300.0, k).central ==
          Approx(chittenden_point_film(inlet, 0.005, 0.005 * ratio, 300.0).central).epsilon(0.10));
  }
}

TEST_CASE("thermal reduction: 1 at no loading, falls with loading and slip to its floor, smooth",
          "[physics][film]") {
  CHECK(thermal_reduction(0.0, 0.0, 0.006) == 1.0);
  CHECK(thermal_reduction(0.0, 5.0, 0.006) == 1.0);
  double last = thermal_reduction(0.01, 0.1, 0.008);
  for (double L = 0.01; L < 1e4; L *= 1.02) {
    const double phi = thermal_reduction(L, 0.1, 0.008);
    CHECK(phi <= last);
    CHECK(phi >= 0.1);
    CHECK(last - phi < 0.02);  // no step
    last = phi;
  }
  CHECK(last == 0.1);
  CHECK(thermal_reduction(1.0, 0.3, 0.008) < thermal_reduction(1.0, 0.0, 0.008));
}

TEST_CASE("starvation: dry at no distance, flooded far away, rising between, near the integral",
          "[physics][film]") {
  CHECK(starvation_factor(0.0) == 0.0);
  CHECK(starvation_factor(-1.0) == 0.0);
  CHECK(starvation_factor(1e9) == 1.0);
  double last = 0.0;
  for (double psi = 0.01; psi < 200.0; psi *= 1.05) {
    const double phi = starvation_factor(psi);
    CHECK(phi >= last);
    CHECK(phi <= 1.0);
    // The published-style fit lies 0 to 6 % above Grubin's inlet, and 12 % below psi = 0.05.
    if (psi > 0.05) CHECK(phi == Approx(starvation_factor_integral(psi)).epsilon(0.06));
    last = phi;
  }
}

TEST_CASE("heated film: unequal walls meet the equal ones, heat is stress times slip",
          "[physics][film]") {
  for (const double U : {1e-6, 1e-3, 0.1, 3.0, 50.0}) {
    const FilmShear equal = film_shear_between_walls(50.0, 50.0, 0.04, 0.13, 3e-7, U);
    const NewtonFilm film{3e-7, 50.0, 0.0, 0.04, 0.13};
    // Below S = 1e-5 the heating, 2/3 S² of the stress, is left out.
    CHECK(equal.stress == Approx(heated_newton(film, U)).epsilon(1e-9));
    const FilmShear near = film_shear_between_walls(50.0, 50.0 * (1.0 + 1e-9), 0.04, 0.13, 3e-7, U);
    CHECK(near.stress == Approx(equal.stress).epsilon(1e-6));
    for (const double other : {1e-6, 1.0, 1e8}) {
      const FilmShear film_of_two = film_shear_between_walls(50.0, other, 0.04, 0.13, 3e-7, U);
      CHECK(std::isfinite(film_of_two.stress));
      CHECK(film_of_two.stress > 0.0);
      CHECK(film_of_two.heat_a + film_of_two.heat_b ==
            Approx(film_of_two.stress * U)
                .margin(1e-9 * (std::abs(film_of_two.heat_a) + std::abs(film_of_two.heat_b))));
    }
  }
  CHECK(film_shear_between_walls(50.0, 50.0, 0.04, 0.13, 3e-7, 0.0).stress == 0.0);
}

TEST_CASE("heated film: any viscosity meets the exponential closed form", "[physics][film]") {
  const double beta = 0.035, mu = 300.0;
  for (const double U : {1e-4, 0.05, 2.0, 10.0}) {
    const FilmShear closed = film_shear_between_walls(mu, mu, beta, 0.12, 4e-7, U);
    const FilmShear any = film_shear_any_viscosity(
        [&](double T) { return mu * std::exp(-beta * (T - 350.0)); }, 350.0, 0.12, 4e-7, U);
    CHECK(any.stress == Approx(closed.stress).epsilon(1e-6));
    CHECK(any.hottest == Approx(closed.hottest).epsilon(1e-6).margin(1e-9));
  }
}

TEST_CASE("heated film: the peak of the stress over slip stands at S = 1.509",
          "[physics][film][analytic]") {
  // τ_max = 1.3255 √(2 K μ/β)/h
  const NewtonFilm film{2e-7, 400.0, 0.0, 0.03, 0.14};
  const double at_peak = 1.509 / std::sqrt(0.03 * 400.0 / (8.0 * 0.14));
  const double peak = film_shear_stress(film, at_peak, 0.0);
  CHECK(peak == Approx(1.3255 * std::sqrt(2.0 * 0.14 * 400.0 / 0.03) / 2e-7).epsilon(1e-4));
  CHECK(film_shear_stress(film, 0.9 * at_peak, 0.0) < peak);
  CHECK(film_shear_stress(film, 1.1 * at_peak, 0.0) < peak);
}

TEST_CASE("shear thinning: Newtonian for n = 1, below it else, heated below isothermal",
          "[physics][film]") {
  for (const double U : {1e-6, 1e-3, 0.1, 3.0}) {
    const ShearThinningStress plain =
        shear_thinning_stress({3e-7, 200.0, 5e6, 1.0, 2.0, 0.04, 0.13}, U);
    CHECK(plain.isothermal == Approx(200.0 * U / 3e-7).epsilon(1e-12));
    CHECK(plain.thermal == Approx(heated_newton({3e-7, 200.0, 0.0, 0.04, 0.13}, U)).epsilon(1e-9));
    const ShearThinningStress thin =
        shear_thinning_stress({3e-7, 200.0, 5e6, 0.4, 2.0, 0.04, 0.13}, U);
    CHECK(thin.isothermal <= plain.isothermal);
    CHECK(thin.thermal <= thin.isothermal * (1.0 + 1e-12));
  }
  CHECK(shear_thinning_stress({3e-7, 200.0, 5e6, 0.4, 2.0, 0.04, 0.13}, 0.0).thermal == 0.0);
  // A glass at 4 GPa and -50 C: no overflow, no endless search.
  const ShearThinningStress glass =
      shear_thinning_stress({1e-7, 1e12, 5e6, 0.35, 2.0, 0.08, 0.1}, 10.0);
  CHECK(std::isfinite(glass.thermal));
  CHECK(glass.thermal > 0.0);
}

TEST_CASE("visco-elastic strip: no stress without slip, rises with it, below its limit",
          "[physics][film]") {
  ViscoElasticStrip strip{false,  2e-4, 1.2e9, 4e-7, 20.0, 0.0256,
                          1.2e-8, 27.6, 1e8,   0.3,  1e6,  0.055};
  CHECK(strip_coefficient(strip, 0.0, 80) == 0.0);
  for (const bool sinh_law : {false, true}) {
    strip.sinh_law = sinh_law;
    double last = 0.0;
    for (double slip = 1e-6; slip < 100.0; slip *= 3.0) {
      const double kappa = strip_coefficient(strip, slip, 80);
      CHECK(kappa > last);
      last = kappa;
    }
    // limit: ∫(1 MPa + 0.055 p)/∫p = 0.055 + 2 b 1e6/(π/2 b 1.2e9)
    if (!sinh_law) CHECK(last < 0.055 + 2e6 / (0.5 * 3.14159265 * 1.2e9));
  }
}

TEST_CASE("flash temperature: a uniform flux gives the mean of Jaeger's band",
          "[physics][film][analytic]") {
  // A film so stiff in temperature (β -> 0) that its heat is uniform but for the pressure (α = 0),
  // between walls that warm alike.
  const FlashStrip strip{2e-4, 1e9,   5e-7, 10.0, 10.5, 350.0,  350.0,
                         20.0, 350.0, 0.0,  1e-9, 0.14, 1.66e8, 1.66e8 * 10.0 / 10.5};
  const FlashResult result = flash_strip(strip, 400);
  const double q = 0.5 * 20.0 * 0.5 * 0.5 / 5e-7;
  CHECK(result.heat_a == Approx(q * 4e-4).epsilon(1e-3));
  // Largest at the trailing end: 3/2 of the mean.
  // Jaeger's band at a high speed: 2 q/√π √(length/(k ρ c speed)) at that end.
  CHECK(result.flash_a ==
        Approx(2.0 * q / std::sqrt(std::numbers::pi) * std::sqrt(4e-4 / (1.66e8 * 10.0)))
            .epsilon(2e-3));
}
