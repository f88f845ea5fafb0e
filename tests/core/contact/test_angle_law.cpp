#include "bearing/bearing.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "contact/make_angle_law.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace adore;
using contact::HertzAngleLaw;

namespace {

constexpr double kE = 1.1e11;

bearing::BallGeometry balls(double D, double pitch, double f = 0.52) {
  bearing::BallGeometry b;
  b.diameter = D;
  b.pitch_diameter = pitch;
  b.groove_factor = {f, f};
  b.contact_angle = 0.4;
  return b;
}

/// Largest relative error of K, a/√δ and b/√δ over all contact angles.
double largest_error(const bearing::BallGeometry& b, int race) {
  const HertzAngleLaw law = contact::make_angle_law(b, race, kE);
  double worst = 0.0;
  for (double alpha = 0.0; alpha <= 3.14159; alpha += 0.01) {
    const auto h = contact::hertz_constants(contact::race_curvature(b, race, alpha), kE);
    const double u = race == 0 ? std::cos(alpha) : -std::cos(alpha), root = std::cbrt(h.K);
    worst = std::max({worst, std::abs(contact::polynomial(law.K, u) / h.K - 1.0),
                      std::abs(contact::polynomial(law.major, u) / (h.a_hat * root) - 1.0),
                      std::abs(contact::polynomial(law.minor, u) / (h.b_hat * root) - 1.0)});
  }
  return worst;
}

}  // namespace

TEST_CASE("Hertz constants over the contact angle are held by a short series",
          "[unit][contact][hertz]") {
  for (const int race : {0, 1}) {
    CAPTURE(race);
    CHECK(largest_error(balls(0.0127, 0.0127 / 0.10), race) < 1e-10);
    CHECK(largest_error(balls(0.0127, 0.0127 / 0.25), race) < 1e-7);
    CHECK(largest_error(balls(0.0127, 0.0127 / 0.45), race) < 1e-5);
    CHECK(largest_error(balls(0.0127, 0.0127 / 0.25, 0.5005), race) < 1e-5);
  }
}

TEST_CASE("slopes of the angle law are its derivatives", "[unit][contact][hertz]") {
  const HertzAngleLaw law = contact::make_angle_law(balls(0.0127, 0.0463), 1, kE);
  for (double u = -0.95; u < 1.0; u += 0.1) {
    const double h = 1e-4;
    const auto at = contact::hertz_constant_at_angle(law, u);
    const auto pair = contact::polynomial_with_slope(law.K, u);
    const double up = contact::polynomial(law.K, u + h), down = contact::polynomial(law.K, u - h);
    CAPTURE(u);
    CHECK(at.K == contact::polynomial(law.K, u));
    CHECK(at.K == pair.value);
    CHECK(at.slope == Approx(pair.slope).epsilon(1e-13));
    CHECK(at.slope == Approx((up - down) / (2.0 * h)).epsilon(1e-6));
    CHECK(at.bend == Approx((up - 2.0 * at.K + down) / (h * h)).epsilon(1e-4));
  }
}

TEST_CASE("a race of infinite pitch has constants that do not follow the angle",
          "[unit][contact][hertz]") {
  const HertzAngleLaw law = contact::make_angle_law(balls(0.0127, 1e6), 0, kE);
  CHECK(contact::polynomial(law.K, 1.0) == Approx(contact::polynomial(law.K, 0.3)).epsilon(1e-7));
}
