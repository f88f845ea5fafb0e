#pragma once

#include "bearing/material.hpp"
#include "contact/ball_groove.hpp"

#include <cmath>

/// Hertz contact of two smooth elastic bodies touching at a point (elliptical contact).
namespace adore::contact {

/// Relative principal curvatures where two bodies touch [1/m]; 0 < along_major <= along_minor.
/// "major" is the long axis of the contact ellipse, so it has the SMALLER curvature.
struct RelativeCurvature {
  double along_major, along_minor;
};

/// Hertz constants of one elliptical point contact; fixed while geometry and material are fixed.
struct HertzConstants {
  double K = 0.0;           ///< Q = K δ^1.5                          [N m^-1.5]
  double a_hat = 0.0;       ///< semi-major axis, a = a_hat Q^(1/3)   [m N^-1/3]
  double b_hat = 0.0;       ///< semi-minor axis, b = b_hat Q^(1/3)   [m N^-1/3]
  double kappa = 1.0;       ///< a/b >= 1
  double E_integral = 0.0;  ///< complete elliptic integral of the second kind E(1 - 1/κ²), read by
                            ///< the race-control criterion
  double K_integral = 0.0;  ///< complete elliptic integral of the first kind K(1 - 1/κ²)
};

/// Solves the elliptical Hertz problem exactly (complete elliptic integrals, no curve fit): for
/// set-up. Equations: ratio c_hi/c_lo = (κ²E - K)/(K - E), parameter m = 1 - 1/κ²; a =
/// (3κ²EQ/(πE*Σρ))^(1/3), b = a/κ, δ = 3KQ/(2πaE*). [hertz1882], [johnson1985 ch.4]. Limit: equal
/// curvatures give K = 4/3 E* sqrt(R), R = 1/curvature.
/// @param E_star 1/E* = (1-ν1²)/E1 + (1-ν2²)/E2 [Pa], > 0. NOT the E' = 2E* of film-thickness
/// papers.
/// @throws InputError naming the argument out of range; the result is never NaN.
[[nodiscard]] HertzConstants hertz_constants(const RelativeCurvature& rho, double E_star);

/// The constants with their exact logarithmic derivatives over the two curvatures, for contacts
/// whose curvature moves with the contact angle: log_K_minor = ∂ ln K / ∂ ln(along_minor), and so
/// on (K, a_hat, E_integral).
struct HertzSensitivity {
  HertzConstants constants;
  double log_K_minor = 0.0, log_K_major = 0.0;
  double log_a_minor = 0.0, log_a_major = 0.0;
  double log_E_minor = 0.0, log_E_major = 0.0;
};

/// As hertz_constants. `kappa_guess` > 1 starts the iteration there (the result does not depend on
/// it beyond rounding).
[[nodiscard]] HertzSensitivity hertz_sensitivity(const RelativeCurvature& rho, double E_star,
                                                 double kappa_guess = 0.0);

/// Normal load [N] for approach δ [m]. δ <= 0 gives exactly 0 (no tension). C1 at 0. Hot path: no
/// throw, no allocation.
[[nodiscard]] inline double hertz_load(double K, double delta) noexcept {
  return delta > 0.0 ? point_contact_load(K, delta, std::sqrt(delta)) : 0.0;
}

}  // namespace adore::contact
