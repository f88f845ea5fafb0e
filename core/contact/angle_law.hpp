#pragma once

#include "contact/ball_groove.hpp"

/// Hertz constants of a ball and a groove that follow the contact angle, with the potential kept.
/// For kernels too: plain numbers. SI.
///
/// The race is curved by 2 cos α/(d_m ∓ D cos α) along the rolling direction, so that K and the
/// axes of the ellipse are analytic functions of cos α, which is n_e (outer race) or -n_e (inner):
/// of u = n_e of contact/ball_groove.hpp on either race. With the strain energy
///   V = 0.4 K(u) δ^2.5,   ∇u = (n_k/l) c
/// the force on the ball is its exact gradient,
///   -∂V/∂d = -Q n + L c,   Q = K(u) δ^1.5,   L = -0.4 K'(u) δ^2.5 n_k/l
/// L acts at the ball's centre: turning the ball changes no energy. |L|/Q = 0.4 (δ/l)|n_k K'/K| is
/// some thousandths in bearings; statics of its own (mode -1) leaves it out, since Hertz's theory
/// of a given curvature knows none.
///   ∂²V/∂d² = Q' n nᵀ + N (n cᵀ + c nᵀ) + C c cᵀ + ((Q n_e - L n_k)/R) t tᵀ
///   N = (K' n_k δ^1.5/l)(1 - 0.4 δ/l),  C = Q/l + 0.4 (K'' n_k² - K' n_e) δ^2.5/l²
/// Limits: as ball_groove.hpp; the polynomials hold K, a and b within 1e-5 for D/d_m <= 0.45 and
/// 1e-7 for D/d_m <= 0.25 (test). Frozen constants are the case K' = 0.
namespace adore::contact {

/// Σ c_k u^k of K [N m^-1.5] and of a/√δ and b/√δ [m^0.5].
struct HertzAngleLaw {
  static constexpr int kTerms = 10;
  bool follows = false;  ///< otherwise the constants are frozen elsewhere and nothing here is read
  double K[kTerms] = {}, major[kTerms] = {}, minor[kTerms] = {};
};

/// A polynomial and its derivatives; coefficients are numbers or, of vectors, one a lane.
template <class T>
struct PolynomialValue {
  T value, slope;
};
template <class C, class T>
[[nodiscard, gnu::always_inline]] inline PolynomialValue<T> polynomial_with_slope(
    const C (&c)[HertzAngleLaw::kTerms], const T& u) {
  T value = T(c[HertzAngleLaw::kTerms - 1]), slope = T(0.0);
  for (int k = HertzAngleLaw::kTerms - 2; k >= 0; --k) {
    slope = slope * u + value;
    value = value * u + T(c[k]);
  }
  return {value, slope};
}
template <class C, class T>
[[nodiscard, gnu::always_inline]] inline T polynomial(const C (&c)[HertzAngleLaw::kTerms],
                                                      const T& u) {
  T value = T(c[HertzAngleLaw::kTerms - 1]);
  for (int k = HertzAngleLaw::kTerms - 2; k >= 0; --k) value = value * u + T(c[k]);
  return value;
}

/// K, K' and K'' over u.
template <class T>
struct AngleDependentHertzConstant {
  T K, slope, bend;
};
template <class T>
[[nodiscard, gnu::always_inline]] inline AngleDependentHertzConstant<T> hertz_constant_at_angle(
    const HertzAngleLaw& law, const T& u) noexcept {
  AngleDependentHertzConstant<T> s{T(law.K[HertzAngleLaw::kTerms - 1]), T(0.0), T(0.0)};
  for (int k = HertzAngleLaw::kTerms - 2; k >= 0; --k) {
    s.bend = s.bend * u + 2.0 * s.slope;
    s.slope = s.slope * u + s.K;
    s.K = s.K * u + T(law.K[k]);
  }
  return s;
}

/// L from the slope K' and δ, √δ, n_k, l.
template <class S, class T>
[[nodiscard, gnu::always_inline]] inline T angle_gradient_force(const S& slope, const T& approach,
                                                                const T& root, const T& n_k,
                                                                const T& length) {
  return -0.4 * slope * approach * approach * root * n_k / length;
}

}  // namespace adore::contact
