#pragma once

#include "base/scalar_math.hpp"

#include <array>
#include <cmath>

/// Forward-mode differentiation: a value with its N partial derivatives. The equations of one ball
/// are written once for a scalar type S and run with S = double for residuals and S = Dual<N> for
/// exact Jacobians.
namespace adore::statics {

template <int N>
struct Dual {
  double v = 0.0;
  std::array<double, N> d{};

  Dual() = default;
  Dual(double value) : v(value) {}  // NOLINT: a constant is a dual number without derivatives
  static Dual variable(double value, int index) {
    Dual result(value);
    result.d[static_cast<std::size_t>(index)] = 1.0;
    return result;
  }
  /// f(this) for a function with value f and slope f'.
  [[nodiscard]] Dual chain(double value, double slope) const {
    Dual result(value);
    for (std::size_t k = 0; k < N; ++k) {
      result.d[k] = slope * d[k];
    }
    return result;
  }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }

  friend Dual operator-(const Dual& a) { return a.chain(-a.v, -1.0); }
  friend Dual operator+(const Dual& a, const Dual& b) { return combine(a.v + b.v, a, 1.0, b, 1.0); }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return combine(a.v - b.v, a, 1.0, b, -1.0);
  }
  friend Dual operator*(const Dual& a, const Dual& b) { return combine(a.v * b.v, a, b.v, b, a.v); }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double inverse = 1.0 / b.v;
    const double value = a.v * inverse;
    return combine(value, a, inverse, b, -value * inverse);
  }
  friend Dual operator+(const Dual& a, double b) { return a.chain(a.v + b, 1.0); }
  friend Dual operator+(double a, const Dual& b) { return b.chain(a + b.v, 1.0); }
  friend Dual operator-(const Dual& a, double b) { return a.chain(a.v - b, 1.0); }
  friend Dual operator-(double a, const Dual& b) { return b.chain(a - b.v, -1.0); }
  friend Dual operator*(const Dual& a, double b) { return a.chain(a.v * b, b); }
  friend Dual operator*(double a, const Dual& b) { return b.chain(a * b.v, a); }
  friend Dual operator/(const Dual& a, double b) { return a.chain(a.v / b, 1.0 / b); }

 private:
  static Dual combine(double value, const Dual& a, double slope_a, const Dual& b, double slope_b) {
    Dual result(value);
    for (std::size_t k = 0; k < N; ++k) {
      result.d[k] = slope_a * a.d[k] + slope_b * b.d[k];
    }
    return result;
  }
};

inline double value_of(double x) { return x; }
template <int N>
double value_of(const Dual<N>& x) {
  return x.v;
}

/// f(x) from its value and slope at value_of(x).
inline double chain(double, double value, double) { return value; }
template <int N>
Dual<N> chain(const Dual<N>& x, double value, double slope) {
  return x.chain(value, slope);
}

template <class S>
S square_root(const S& x) {
  const double root = std::sqrt(value_of(x));
  return chain(x, root, 0.5 / root);
}
template <class S>
S sine(const S& x) {
  return chain(x, std::sin(value_of(x)), std::cos(value_of(x)));
}
template <class S>
S cosine(const S& x) {
  return chain(x, std::cos(value_of(x)), -std::sin(value_of(x)));
}

}  // namespace adore::statics

namespace adore {

/// What templates over a scalar type ask of dual numbers: min, max and pick decide by the value.
template <int N>
struct ScalarMath<statics::Dual<N>> {
  using Dual = statics::Dual<N>;
  using Mask = bool;
  static Dual sqrt(const Dual& x) { return statics::square_root(x); }
  static Dual root(const Dual& x) { return x.v > 0.0 ? statics::square_root(x) : Dual(0.0); }
  static Dual sqrt_and_inverse(const Dual& x, Dual& inverse) {
    const double value = std::sqrt(x.v), over = 1.0 / value;
    inverse = x.chain(over, -0.5 * over / x.v);
    return x.chain(value, 0.5 * over);
  }
  static Dual min(const Dual& a, const Dual& b) { return b.v < a.v ? b : a; }
  static Dual max(const Dual& a, const Dual& b) { return a.v < b.v ? b : a; }
  static Dual pick(bool condition, const Dual& a, const Dual& b) { return condition ? a : b; }
  static bool any(bool condition) { return condition; }
};

}  // namespace adore
