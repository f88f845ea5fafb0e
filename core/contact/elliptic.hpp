#pragma once

/// Complete elliptic integrals in the form that Hertz contact needs, and Carlson's R_D for the
/// stresses under it.
namespace adore::contact {

/// Complete elliptic integrals of the parameter m = 1 - mc (modulus squared), and their
/// combinations without the cancellation that K - E and E - mc K suffer near m = 0. All are finite
/// and positive for 0 < mc <= 1.
struct CompleteElliptic {
  double K;  ///< ∫ dφ / sqrt(1 - m sin²φ), 0..π/2
  double E;  ///< ∫ sqrt(1 - m sin²φ) dφ, 0..π/2
  double B;  ///< (E - mc K)/m = ∫ cos²φ / sqrt(1 - m sin²φ) dφ
  double D;  ///< (K - E)/m    = ∫ sin²φ / sqrt(1 - m sin²φ) dφ
  double C;  ///< (D - B)/m
};

/// Arithmetic-geometric mean; full double precision for every 0 < mc <= 1, also next to m = 1,
/// because the COMPLEMENTARY parameter mc = 1/κ² is the argument ([abramowitz1964 17.6],
/// [bulirsch1965]).
[[nodiscard]] CompleteElliptic complete_elliptic(double mc) noexcept;

/// Carlson's R_D(x, y, z) = 3/2 ∫ dt / (sqrt((t+x)(t+y)) (t+z)^1.5), 0..∞; x, y >= 0, at most one
/// of them 0, z > 0. Duplication, relative error below 1e-15 times a few ([carlson1995]).
[[nodiscard]] double carlson_rd(double x, double y, double z) noexcept;

}  // namespace adore::contact
