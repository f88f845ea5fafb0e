#include "base/constants.hpp"
#include "base/errors.hpp"
#include "contact/elliptic.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "contact/subsurface.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace adore;
using namespace adore::contact;

namespace {

/// ∫ f over 0..π/2 by the trapezoidal rule, which converges exponentially for these periodic
/// integrands.
template <class F>
double quarter_period(F f, int n) {
  double sum = 0.5 * (f(0.0) + f(0.5 * kPi));
  for (int k = 1; k < n; ++k) sum += f(0.5 * kPi * k / n);
  return sum * 0.5 * kPi / n;
}

}  // namespace

TEST_CASE("complete elliptic integrals agree with quadrature and Legendre's relation",
          "[unit][hertz]") {
  for (double mc : {1.0, 0.999999, 0.7, 0.1, 1e-2}) {
    const CompleteElliptic e = complete_elliptic(mc);
    const double m = 1.0 - mc;
    const auto root = [&](double p) { return std::sqrt(1.0 - m * std::sin(p) * std::sin(p)); };
    // 400 panels resolve mc >= 0.01 to rounding; a few ulp are left for the sum.
    CHECK(e.K ==
          Approx(quarter_period([&](double p) { return 1.0 / root(p); }, 400)).epsilon(2e-15));
    CHECK(e.E == Approx(quarter_period(root, 400)).epsilon(2e-15));
    CHECK(e.D ==
          Approx(quarter_period([&](double p) { return std::sin(p) * std::sin(p) / root(p); }, 400))
              .epsilon(4e-15));
    CHECK(e.B ==
          Approx(quarter_period([&](double p) { return std::cos(p) * std::cos(p) / root(p); }, 400))
              .epsilon(4e-15));
  }
  for (double mc : {0.3, 1e-3, 1e-6}) {
    const auto a = complete_elliptic(mc);
    const auto b = complete_elliptic(1.0 - mc);
    // E K' + E' K - K K' = π/2; the products reach 30, so 1e-14 is their rounding.
    CHECK(a.E * b.K + b.E * a.K - a.K * b.K == Approx(0.5 * kPi).epsilon(1e-14));
  }
}

TEST_CASE("complete elliptic integrals keep their digits next to m = 1 and m = 0",
          "[unit][hertz]") {
  for (double mc : {1e-8, 1e-14, 1e-24}) {
    const auto e = complete_elliptic(mc);
    const double lambda = 0.5 * std::log(16.0 / mc);
    // K = Λ + mc/4 (Λ-1), E = 1 + mc/2 (Λ - 1/2), next terms mc² ln mc.
    CHECK(e.K == Approx(lambda + 0.25 * mc * (lambda - 1.0)).epsilon(4e-15));
    CHECK(e.E == Approx(1.0 + 0.5 * mc * (lambda - 0.5)).epsilon(1e-14));
  }
  const double m = 1e-9;  // D = π/4 (1 + 3m/8), B = π/4 (1 + m/8), C = π/16 (1 + O(m))
  const auto e = complete_elliptic(1.0 - m);
  CHECK(e.D == Approx(0.25 * kPi * (1.0 + 0.375 * m)).epsilon(4e-16));
  CHECK(e.C == Approx(kPi / 16.0).epsilon(1e-8));
}

TEST_CASE("Carlson's R_D satisfies its special values and homogeneity", "[unit][hertz]") {
  CHECK(carlson_rd(2.5, 2.5, 2.5) == Approx(std::pow(2.5, -1.5)).epsilon(1e-15));
  // Published test values of the algorithm [carlson1995].
  CHECK(carlson_rd(0.0, 2.0, 1.0) == Approx(1.7972103521033883).epsilon(1e-14));
  CHECK(carlson_rd(2.0, 3.0, 4.0) == Approx(0.16510527294261053).epsilon(1e-14));
  CHECK(carlson_rd(2e-8, 3e-8, 4e-8) == Approx(0.16510527294261053e12).epsilon(1e-14));
}

TEST_CASE("equal curvatures give the circular contact of Hertz", "[physics][hertz]") {
  const double R = 0.012;
  const double E_star = 1.1e11;
  const auto h = hertz_constants({1.0 / R, 1.0 / R}, E_star);
  CHECK(h.kappa == 1.0);
  CHECK(h.K == Approx(4.0 / 3.0 * E_star * std::sqrt(R)).epsilon(1e-14));
  CHECK(h.a_hat == Approx(std::cbrt(0.75 * R / E_star)).epsilon(1e-14));
  CHECK(h.b_hat == Approx(h.a_hat).epsilon(1e-15));
}

TEST_CASE("the ellipticity solves its equation from 1 to far beyond any bearing",
          "[physics][hertz]") {
  double previous = 1.0;
  for (double ratio : {1.0, 1.0 + 1e-13, 1.0 + 1e-7, 1.1, 3.0, 30.0, 1e3, 1e6, 1e9, 1e14}) {
    const auto h = hertz_constants({1.0, ratio}, 1.0);
    REQUIRE(std::isfinite(h.K));
    CHECK(h.kappa >= previous);
    previous = h.kappa;
    const auto e = complete_elliptic(1.0 / (h.kappa * h.kappa));
    // The equation magnifies an error of kappa by at most two.
    CHECK(h.kappa * h.kappa * e.B / e.D == Approx(ratio).epsilon(1e-13));
  }
  // Nearly equal curvatures: kappa = ratio^(2/3).
  CHECK(hertz_constants({1.0, 1.0 + 1e-6}, 1.0).kappa - 1.0 == Approx(2e-6 / 3.0).epsilon(1e-5));
}

TEST_CASE("Hertz constants scale with modulus and size", "[physics][hertz]") {
  const auto h = hertz_constants({20.0, 300.0}, 1e11);
  const auto stiff = hertz_constants({20.0, 300.0}, 8e11);
  const auto big = hertz_constants({5.0, 75.0}, 1e11);
  CHECK(stiff.K == Approx(8.0 * h.K).epsilon(1e-14));          // K ~ E*
  CHECK(stiff.a_hat == Approx(0.5 * h.a_hat).epsilon(1e-14));  // a ~ E*^(-1/3)
  CHECK(big.K == Approx(2.0 * h.K).epsilon(1e-14));            // K ~ length^(1/2)
  CHECK(big.kappa == Approx(h.kappa).epsilon(1e-15));
}

TEST_CASE("the logarithmic derivatives of the Hertz constants match differences", "[unit][hertz]") {
  for (double ratio : {1.0 + 1e-4, 2.0, 17.0, 500.0}) {
    const RelativeCurvature rho{40.0, 40.0 * ratio};
    const auto s = hertz_sensitivity(rho, 1e11);
    const double h = 1e-5 * (ratio < 1.01 ? 0.5 : 1.0);
    const auto up = hertz_constants({rho.along_major, rho.along_minor * (1 + h)}, 1e11);
    const auto down = hertz_constants({rho.along_major, rho.along_minor * (1 - h)}, 1e11);
    // Central differences: h² truncation 1e-10, rounding 1e-16/h = 1e-11.
    CHECK(s.log_K_minor == Approx(std::log(up.K / down.K) / (2 * h)).epsilon(1e-8));
    CHECK(s.log_a_minor == Approx(std::log(up.a_hat / down.a_hat) / (2 * h)).epsilon(1e-8));
    CHECK(s.log_E_minor ==
          Approx(std::log(up.E_integral / down.E_integral) / (2 * h)).epsilon(1e-7).margin(1e-10));
    const auto wide = hertz_constants({rho.along_major * (1 + h), rho.along_minor}, 1e11);
    const auto narrow = hertz_constants({rho.along_major * (1 - h), rho.along_minor}, 1e11);
    CHECK(s.log_K_major == Approx(std::log(wide.K / narrow.K) / (2 * h)).epsilon(1e-8));
    // Scaling both curvatures by c scales K by c^(-1/2) and a by c^(-1/3).
    CHECK(s.log_K_minor + s.log_K_major == Approx(-0.5).epsilon(1e-13));
    CHECK(s.log_a_minor + s.log_a_major == Approx(-1.0 / 3.0).epsilon(1e-13));
  }
}

TEST_CASE("Hertz input out of range is named", "[unit][hertz]") {
  CHECK_THROWS_WITH(hertz_constants({-1.0, 2.0}, 1e11), Catch::Contains("major axis is -1"));
  CHECK_THROWS_WITH(hertz_constants({3.0, 2.0}, 1e11), Catch::Contains("minor axis is 2"));
  CHECK_THROWS_WITH(hertz_constants({1.0, 2.0}, 0.0), Catch::Contains("E* is 0"));
  CHECK_THROWS_AS(hertz_constants({1.0, std::nan("")}, 1e11), InputError);
}

TEST_CASE("stresses on the axis match the closed form of the circle and the cylinder",
          "[physics][hertz]") {
  const double a = 1e-3;
  const double p = 2e9;
  const double nu = 0.3;
  for (double zeta : {0.0, 1e-6, 0.3, 0.48, 2.0}) {
    const auto s = axis_stress(a, a, p, nu, zeta * a);
    const double angle = zeta > 0.0 ? std::atan(1.0 / zeta) : 0.5 * kPi;
    const double radial = -p * ((1 + nu) * (1 - zeta * angle) - 0.5 / (1 + zeta * zeta));
    CHECK(s.major == Approx(radial).epsilon(1e-13));
    CHECK(s.minor == Approx(radial).epsilon(1e-13));
    CHECK(s.depth == Approx(-p / (1 + zeta * zeta)).epsilon(1e-14));
    // A long ellipse is a cylinder up to terms of order b/a = 1e-5 of the pressure.
    const auto line = axis_stress(1e5 * a, a, p, nu, zeta * a);
    const double root = std::sqrt(1 + zeta * zeta);
    const double across = -p * ((1 + 2 * zeta * zeta) / root - 2 * zeta);
    CHECK(line.minor == Approx(across).margin(2e-5 * p));
    CHECK(line.depth == Approx(-p / root).epsilon(1e-8));
    CHECK(line.major == Approx(nu * (across - p / root)).margin(2e-5 * p));
  }
}

TEST_CASE("largest subsurface stresses approach the line contact and never exceed a scan",
          "[physics][hertz]") {
  const auto line = subsurface_stress(1.0, 1e-6, 1.0, 0.3);
  CHECK(line.orthogonal_shear == Approx(0.25).epsilon(1e-10));
  CHECK(line.orthogonal_depth == Approx(0.5e-6).epsilon(1e-10));
  CHECK(line.orthogonal_offset == Approx(0.5e-6 * std::sqrt(3.0)).epsilon(1e-10));
  CHECK(line.max_shear == Approx(0.30028).epsilon(1e-4));
  CHECK(line.max_shear_depth == Approx(0.7862e-6).epsilon(1e-3));
  for (double ratio : {1.0, 2.0, 8.0, 100.0}) {
    for (double nu : {0.0, 0.26, 0.5}) {
      const auto s = subsurface_stress(ratio, 1.0, 1.0, nu);
      double best_shear = 0.0;
      double best_octahedral = 0.0;
      for (int k = 0; k <= 4000; ++k) {
        const auto at = axis_stress(ratio, 1.0, 1.0, nu, 1e-3 * k);
        best_shear = std::max(best_shear, at.max_shear());
        best_octahedral = std::max(best_octahedral, at.octahedral());
      }
      CHECK(s.max_shear >= best_shear * (1 - 1e-15));
      CHECK(s.max_shear <=
            best_shear * (1 + 1e-5));  // scan step 1e-3 b under a curvature of order one
      CHECK(s.octahedral >= best_octahedral * (1 - 1e-15));
      CHECK(s.octahedral <= best_octahedral * (1 + 1e-5));
      CHECK(s.von_mises == Approx(3.0 / std::sqrt(2.0) * s.octahedral).epsilon(1e-15));
    }
  }
}

TEST_CASE("the orthogonal shear is the maximum of its closed field", "[physics][hertz]") {
  for (double a : {1.0, 3.0, 12.0}) {
    const double b = 1.0;
    const auto s = subsurface_stress(a, b, 1.0, 0.3);
    const auto field = [&](double y,
                           double z) {  // README A: λ the positive root of y²/(b²+λ) + z²/λ = 1
      const double half = 0.5 * (y * y + z * z - b * b);
      const double lambda = half + std::sqrt(half * half + z * z * b * b);
      const double slope =
          2 * y / (b * b + lambda) /
          (y * y / ((b * b + lambda) * (b * b + lambda)) + z * z / (lambda * lambda));
      return z * z * a * b /
             (2 * std::pow(lambda, 1.5) * std::sqrt((a * a + lambda) * (b * b + lambda))) * slope;
    };
    CHECK(field(s.orthogonal_offset, s.orthogonal_depth) ==
          Approx(s.orthogonal_shear).epsilon(1e-13));
    for (double dy : {-1e-3, 0.0, 1e-3}) {
      for (double dz : {-1e-3, 0.0, 1e-3}) {
        CHECK(field(s.orthogonal_offset + dy, s.orthogonal_depth + dz) <=
              s.orthogonal_shear * (1 + 1e-14));
      }
    }
  }
}

TEST_CASE("grooves touch the ball at the free contact angle, or leave the given clearance",
          "[unit][groove]") {
  bearing::BallGeometry balls;
  balls.diameter = 0.01;
  balls.pitch_diameter = 0.05;
  balls.groove_factor = {0.53, 0.515};
  balls.contact_angle = 0.4;
  const auto g = groove_geometry(balls);
  const double dx = g.centre_x[1] - g.centre_x[0];
  const double dr = g.centre_radius[1] - g.centre_radius[0];
  CHECK(std::hypot(dx, dr) == Approx(g.offset[0] + g.offset[1]).epsilon(1e-13));
  CHECK(std::atan2(dx, dr) == Approx(0.4).epsilon(1e-13));
  balls.contact_angle = 0.0;
  balls.clearance = 3e-5;
  const auto play = groove_geometry(balls);
  CHECK(play.centre_radius[1] - play.centre_radius[0] ==
        Approx(g.offset[0] + g.offset[1] - 1.5e-5).epsilon(1e-12));
  balls.groove_factor[1] = 0.5;
  CHECK_THROWS_WITH(groove_geometry(balls), Catch::Contains("inner groove factor is 0.5"));
  balls.groove_factor[1] = 0.515;
  balls.pitch_diameter = 0.009;
  CHECK_THROWS_WITH(groove_geometry(balls), Catch::Contains("pitch diameter is 0.009"));
}

TEST_CASE("race curvature is the sum of ball and race", "[unit][groove]") {
  bearing::BallGeometry balls;
  balls.diameter = 0.01;
  balls.pitch_diameter = 0.05;
  balls.groove_factor = {0.53, 0.515};
  const double c = std::cos(0.5);
  const auto inner = race_curvature(balls, bearing::kInner, 0.5);
  const auto outer = race_curvature(balls, bearing::kOuter, 0.5);
  // 1/R of the race surface at the contact: its distance from the axis along the normal is (d_m ∓ D
  // cos α)/(2 cos α).
  CHECK(inner.along_minor == Approx(2 / 0.01 + 2 * c / (0.05 - 0.01 * c)).epsilon(1e-14));
  CHECK(outer.along_minor == Approx(2 / 0.01 - 2 * c / (0.05 + 0.01 * c)).epsilon(1e-14));
  CHECK(inner.along_major == Approx(2 / 0.01 - 1 / 0.00515).epsilon(1e-12));
}

TEST_CASE("the free state follows angle, clearance and shims", "[unit][groove]") {
  const double D = 0.0127;
  const std::array<double, 2> f{0.52, 0.515};
  const double play = 2 * D * (f[0] + f[1] - 1);
  const auto given = free_angle_and_clearance(D, f, {0, 0}, 0.5, 123.0);
  CHECK(given.contact_angle == 0.5);
  CHECK(given.clearance == Approx(play * (1 - std::cos(0.5))).epsilon(1e-14));
  const auto back = free_angle_and_clearance(D, f, {0, 0}, 0.0, given.clearance);
  CHECK(back.contact_angle == Approx(0.5).epsilon(1e-13));
  CHECK(free_angle_and_clearance(D, f, {0, 0}, 0.0, -1e-5).contact_angle == 0.0);
  CHECK(free_angle_and_clearance(D, f, {0, 0}, 0.0, 1e-12).contact_angle ==
        Approx(std::sqrt(2e-12 / play)).epsilon(1e-9));

  // Split inner ring ground with a shim: pushed together, the arches stand g/2 off center, and a
  // ball pressed radially between them rests where its contacts meet both arches: the arch angle,
  // sin αs = (g/2)/((f - 1/2)D).
  const double g = 2e-4;
  const double offset = (f[1] - 0.5) * D;
  const double lifted = offset - std::sqrt(offset * offset - 0.25 * g * g);
  const auto split = free_angle_and_clearance(D, f, {0, g}, 0.0, 2e-5);
  CHECK(split.clearance == Approx(2e-5 + 2 * lifted).epsilon(1e-12));
  CHECK_THROWS_WITH(free_angle_and_clearance(D, f, {0, 2.1 * offset}, 0.0, 0.0),
                    Catch::Contains("shim of the inner race"));
  CHECK_THROWS_WITH(free_angle_and_clearance(D, f, {0, 0}, 0.0, 1.01 * play),
                    Catch::Contains("90 degrees"));
}
