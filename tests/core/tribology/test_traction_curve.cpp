#include "base/errors.hpp"
#include "tribology/newton_film.hpp"
#include "tribology/traction_curve.hpp"
#include "tribology/traction_law.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <string>

using adore::bearing::TractionCurve;
using adore::tribology::traction_coefficient;
using adore::tribology::traction_curve;
using adore::tribology::traction_slope;
using Catch::Matchers::Contains;

namespace {
std::string refusal(int type, const std::array<double, 4>& tc) {
  try {
    (void)traction_curve(type, tc);
  } catch (const adore::InputError& error) {
    return error.what();
  }
  return "accepted";
}
}  // namespace

TEST_CASE("traction_curve: type 1 meets its four conditions over the whole range of A/M",
          "[unit][analytic]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const double km = 0.01 + 0.1 * uniform(random);
    // From nearly flat maxima (k0 -> km) to nearly asymptotic laws (kinf -> km).
    const double k0 = i % 3 == 0 ? km * (1.0 - std::pow(10.0, -5.0 * uniform(random)))
                                 : km * uniform(random) * 0.99;
    const double kinf = i % 3 == 1 ? km * (1.0 - std::pow(10.0, -8.0 * uniform(random)))
                                   : km * uniform(random) * 0.99;
    const double um = std::pow(10.0, -3.0 + 4.0 * uniform(random));
    const TractionCurve curve = traction_curve(1, {k0, km, kinf, um});
    INFO("k0 = " << k0 << ", km = " << km << ", kinf = " << kinf << ", um = " << um);
    REQUIRE(curve.C > 0.0);
    CHECK(traction_coefficient(curve, 0.0) == Approx(k0).epsilon(1e-12).margin(1e-15));
    CHECK(curve.D == kinf);
    // Rounding of C M exp(x) near a flat maximum grows like 1/x: 1e-12 of km leaves two decades.
    CHECK(traction_coefficient(curve, um) == Approx(km).epsilon(1e-12));
    CHECK(std::abs(traction_slope(curve, um)) < 1e-9 * km / um);
    CHECK(traction_coefficient(curve, 0.9 * um) < km);
    CHECK(traction_coefficient(curve, 1.1 * um) < km);
  }
}

TEST_CASE("traction_curve: equal end values give x = 1, B = e (km - kinf)/um", "[unit][analytic]") {
  const TractionCurve curve = traction_curve(1, {0.03, 0.05, 0.03, 0.2});
  CHECK(curve.A == 0.0);
  CHECK(curve.C == Approx(5.0).epsilon(1e-15));
  CHECK(curve.B == Approx(std::exp(1.0) * 0.02 / 0.2).epsilon(1e-14));
}

TEST_CASE("traction_curve: type 2 starts with the given slope and ends at the asymptote",
          "[unit][analytic]") {
  const TractionCurve rising =
      traction_curve(2, {0.01, 0.06, 2.0, 7.0});  // the fourth value is unused
  CHECK(traction_coefficient(rising, 0.0) == Approx(0.01).epsilon(1e-14));
  CHECK(traction_slope(rising, 0.0) == Approx(2.0).epsilon(1e-14));
  CHECK(traction_coefficient(rising, 50.0) == Approx(0.06).epsilon(1e-14));
  const TractionCurve constant = traction_curve(2, {0.05, 0.05, 0.0, 0.0});
  CHECK(traction_coefficient(constant, 0.3) == 0.05);
}

TEST_CASE("traction_curve: two slopes are continuous at u0", "[unit][analytic]") {
  const TractionCurve curve = traction_curve(0, {0.01, 0.5, 0.02, 0.1});
  CHECK(traction_coefficient(curve, 0.0) == 0.01);
  CHECK(traction_coefficient(curve, 0.1) == Approx(0.06).epsilon(1e-15));
  CHECK(traction_coefficient(curve, 0.1 + 1e-12) == Approx(0.06).epsilon(1e-11));
  CHECK(traction_coefficient(curve, 1.1) == Approx(0.08).epsilon(1e-15));
}

TEST_CASE("traction_slope is the derivative of every form", "[unit][jacobian]") {
  for (const TractionCurve& curve :
       {traction_curve(1, {0.02, 0.08, 0.05, 0.5}), traction_curve(0, {0.01, 0.5, 0.02, 0.1}),
        traction_curve(2, {0.08, 0.05, -0.3, 0.0}), traction_curve(-1, {-0.04, 0.02, 8.0, 0.04})}) {
    for (double u : {0.01, 0.05, 0.3, 2.0}) {
      const double step =
          1e-6;  // error of the difference ~ step² and 1e-16/step: 1e-9 of slopes ~1
      const double difference =
          (traction_coefficient(curve, u + step) - traction_coefficient(curve, u - step)) /
          (2.0 * step);
      CHECK(traction_slope(curve, u) == Approx(difference).epsilon(1e-7).margin(1e-9));
    }
  }
}

TEST_CASE("traction_curve refuses what has no solution and says which condition fails", "[unit]") {
  CHECK_THAT(refusal(1, {0.0, 0.04, 0.05, 0.1}),
             Contains("must exceed the coefficient at infinite slip, 0.05"));
  CHECK_THAT(refusal(1, {0.06, 0.05, 0.02, 0.1}),
             Contains("must exceed the coefficient at zero slip, 0.06"));
  CHECK_THAT(refusal(1, {0.0, 0.05, 0.02, 0.0}),
             Contains("u_m = 0 m/s at maximum traction must be positive"));
  CHECK_THAT(refusal(1, {-0.01, 0.05, 0.02, 0.1}), Contains("cannot be negative"));
  CHECK_THAT(
      refusal(2, {0.02, 0.06, -2.0, 0.0}),
      Contains("initial slope -2 s/m of the traction law does not fit the coefficients 0.02"));
  CHECK_THAT(refusal(-1, {0.0, 0.1, -3.0, 0.0}), Contains("C = -3 s/m"));
  CHECK_THAT(refusal(-1, {0.04, -0.5, 3.0, 0.0}), Contains("negative at some slip"));
  CHECK_THAT(refusal(-1, {0.0, -0.5, 0.0, 0.1}), Contains("negative at some slip"));
  CHECK_THAT(refusal(0, {0.0, 0.5, -0.01, 0.1}), Contains("negative within the slip range"));
  CHECK_THAT(refusal(0, {0.0, 0.5, 0.0, -0.1}), Contains("u0 = -0.1 m/s"));
  CHECK_THAT(refusal(3, {0.0, 0.5, 0.0, 0.1}), Contains("no traction law of type 3"));
  CHECK_THAT(refusal(0, {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.1}),
             Contains("value 2"));
  CHECK(refusal(0, {0.05, 0.0, -1e-5, 0.1}) == "accepted");  // falls to zero only above 5000 m/s
}

TEST_CASE("max_traction_coefficient is the largest of every form", "[unit]") {
  using adore::tribology::kLargestSlip;
  for (const TractionCurve& curve :
       {traction_curve(-1, {-0.04, 0.3, 2.0, 0.04}), traction_curve(-1, {0.05, 0.0, 1.0, 0.02}),
        traction_curve(0, {0.01, 0.2, -1e-4, 0.3}), traction_curve(0, {0.0, 0.1, 1e-3, 0.5}),
        traction_curve(1, {0.0, 0.06, 0.04, 0.5}), traction_curve(1, {0.03, 0.08, 0.01, 2.0}),
        traction_curve(2, {0.0, 0.08, 0.8, 0.0}), traction_curve(2, {0.09, 0.02, -0.5, 0.0})}) {
    double largest = 0.0;
    for (int k = 0; k <= 200000; ++k)
      largest = std::max(largest, traction_coefficient(curve, kLargestSlip * k / 200000.0));
    CHECK(adore::tribology::max_traction_coefficient(curve) == Approx(largest).epsilon(1e-5));
  }
  CHECK(adore::tribology::max_traction_coefficient({}) == 0.0);
}

TEST_CASE("only laws that do not vanish at rest are regularized", "[unit]") {
  using adore::tribology::TractionLaw;
  CHECK_FALSE(TractionLaw(traction_curve(0, {0.0, 0.5, 0.0, 0.1})).is_slip_regularized());
  CHECK_FALSE(TractionLaw(traction_curve(1, {0.0, 0.06, 0.04, 0.1})).is_slip_regularized());
  CHECK(TractionLaw(traction_curve(1, {0.02, 0.06, 0.04, 0.1})).is_slip_regularized());
  CHECK(TractionLaw(traction_curve(0, {0.05, 0.0, 0.0, 0.1})).is_slip_regularized());
}

TEST_CASE("film_shear_stress: viscous when slow, peak at S = 1.509, then falling",
          "[unit][analytic]") {
  const adore::tribology::NewtonFilm film{5e-7, 0.015, 5.2e-9, 0.046, 0.144};
  const double p = 1e9, mu = film.viscosity * std::exp(film.pressure_exponent * p);
  CHECK(film_shear_stress(film, 0.0, p) == 0.0);
  CHECK(film_shear_stress(film, 1e-6, p) == Approx(mu * 1e-6 / film.thickness).epsilon(1e-6));
  const double unit = std::sqrt(8.0 * film.conductivity / (film.temperature_exponent * mu));
  const double peak = film_shear_stress(film, 1.509 * unit, p);
  // 1.3255 is rounded to four digits.
  CHECK(peak ==
        Approx(1.3255 * std::sqrt(2.0 * film.conductivity * mu / film.temperature_exponent) /
               film.thickness)
            .epsilon(1e-4));
  CHECK(film_shear_stress(film, 1.45 * unit, p) < peak);
  CHECK(film_shear_stress(film, 1.57 * unit, p) < peak);
  const double seam = 1e-4 * unit;  // series and closed form meet
  CHECK(film_shear_stress(film, seam * (1 - 1e-9), p) ==
        Approx(film_shear_stress(film, seam * (1 + 1e-9), p)).epsilon(3e-9));
}
