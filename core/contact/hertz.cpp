#include "contact/hertz.hpp"

#include "base/errors.hpp"
#include "contact/elliptic.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace adore::contact {
namespace {

void check(const RelativeCurvature& rho, double E_star) {
  if (!(std::isfinite(rho.along_major) && rho.along_major > 0.0)) {
    throw InputError(
        fmt::format("Hertz contact: the relative curvature along the major axis is {} 1/m; it must "
                    "be a positive number "
                    "(the bodies must curve away from each other in both directions)",
                    rho.along_major));
  }
  if (!(std::isfinite(rho.along_minor) && rho.along_minor >= rho.along_major)) {
    throw InputError(
        fmt::format("Hertz contact: the relative curvature along the minor axis is {} 1/m; it must "
                    "be a number not below "
                    "the one along the major axis, {} 1/m",
                    rho.along_minor, rho.along_major));
  }
  if (!(std::isfinite(E_star) && E_star > 0.0)) {
    throw InputError(fmt::format(
        "Hertz contact: the contact modulus E* is {} Pa; it must be a positive number", E_star));
  }
}

/// ln κ with (κ²E - K)/(K - E) = κ² B/D = ratio. The slope of ln(κ² B/D) over ln κ lies between 3/2
/// and 2 everywhere, so Newton's iteration converges from any start.
double solve_log_kappa(double log_ratio, double start, CompleteElliptic& integrals, double& slope) {
  double x = start;
  for (int n = 0; n < 60; ++n) {
    const double mc = std::exp(-2.0 * x);
    integrals = complete_elliptic(mc);
    slope = 1.0 + mc * integrals.C / integrals.B + integrals.C / integrals.D;
    const double m = -std::expm1(-2.0 * x);
    const double log_b_over_d = std::log1p(-m * integrals.C / integrals.D);
    const double step = (log_ratio - 2.0 * x - log_b_over_d) / slope;
    x = std::max(0.0, x + step);
    // The step after a change of 1e-9 would be of the order 1e-18: the integrals above need no
    // refreshing.
    if (std::abs(step) <= 1e-9) {
      break;
    }
  }
  return x;
}

HertzSensitivity solve(const RelativeCurvature& rho, double E_star, double kappa_guess) {
  check(rho, E_star);
  const double log_ratio = std::log1p((rho.along_minor - rho.along_major) / rho.along_major);
  const double start = kappa_guess > 1.0 ? std::log(kappa_guess) : log_ratio / 1.6;
  CompleteElliptic integrals{};
  double slope = 1.5;
  const double x = solve_log_kappa(log_ratio, start, integrals, slope);
  const double mc = std::exp(-2.0 * x);
  integrals = complete_elliptic(mc);
  const double sum = rho.along_major + rho.along_minor;

  HertzSensitivity result;
  HertzConstants& c = result.constants;
  c.kappa = std::exp(x);
  c.E_integral = integrals.E;
  c.K_integral = integrals.K;
  c.a_hat = std::cbrt(3.0 * c.kappa * c.kappa * integrals.E / (std::numbers::pi * E_star * sum));
  c.b_hat = c.a_hat / c.kappa;
  const double root = 2.0 * std::numbers::pi * E_star * c.a_hat / (3.0 * integrals.K);
  c.K = root * std::sqrt(root);

  // d ln K / d ln κ = B/K, d ln E / d ln κ = -mc D/E (both from dm = 2 mc d ln κ).
  const double dx_dlogratio = 1.0 / slope;
  const double dlogK = integrals.B / integrals.K * dx_dlogratio;
  const double dlogE = -mc * integrals.D / integrals.E * dx_dlogratio;
  const double minor_share = rho.along_minor / sum;
  const double major_share = rho.along_major / sum;
  const double a_ratio = (2.0 * dx_dlogratio + dlogE) / 3.0;
  result.log_a_minor = a_ratio - minor_share / 3.0;
  result.log_a_major = -a_ratio - major_share / 3.0;
  result.log_K_minor = 1.5 * (result.log_a_minor - dlogK);
  result.log_K_major = 1.5 * (result.log_a_major + dlogK);
  result.log_E_minor = dlogE;
  result.log_E_major = -dlogE;
  return result;
}

}  // namespace

HertzConstants hertz_constants(const RelativeCurvature& rho, double E_star) {
  return solve(rho, E_star, 0.0).constants;
}

HertzSensitivity hertz_sensitivity(const RelativeCurvature& rho, double E_star,
                                   double kappa_guess) {
  return solve(rho, E_star, kappa_guess);
}

}  // namespace adore::contact
