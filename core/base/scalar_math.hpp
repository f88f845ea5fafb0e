#pragma once

#include <algorithm>
#include <cmath>

/// What formulas written once for a scalar type T ask of it beyond + - * /. T is double (here), a
/// vector of doubles (base/simd_math.hpp) or a dual number (statics/dual.hpp).
///
///   Mask                     what a comparison of two T gives
///   sqrt(x), root(x)         root: for lengths, x >= 0; of vectors the cheap one
///   sqrt_and_inverse(x, i)   root of 1e-30 <= x <= 1e30, and i = 1/root
///   inverse_sqrt(x)          1e-30 <= x <= 1e30
///   over(a, x, i)            a/x where i = 1/x is known: rounded once for numbers, a i for vectors
///   exp(x), min(a, b), max(a, b), pick(condition, a, b): a where the condition holds
///   abs(x), copysign(size, sign), any(condition): does it hold anywhere?
///   ninth_root(x)            x >= 0, vectors: 1e-300 <= x or 0
///
/// Nothing else may be included here: the race kernels, which are compiled once per instruction
/// set, see this header.
namespace adore {

template <class T>
struct ScalarMath;

template <>
struct ScalarMath<double> {
  using Mask = bool;
  [[gnu::always_inline]] static double sqrt(double x) { return std::sqrt(x); }
  [[gnu::always_inline]] static double root(double x) { return std::sqrt(std::max(x, 0.0)); }
  [[gnu::always_inline]] static double sqrt_and_inverse(double x, double& inverse) {
    const double result = std::sqrt(x);
    inverse = 1.0 / result;
    return result;
  }
  [[gnu::always_inline]] static double inverse_sqrt(double x) { return 1.0 / std::sqrt(x); }
  [[gnu::always_inline]] static double over(double a, double x, double) { return a / x; }
  [[gnu::always_inline]] static double exp(double x) { return std::exp(x); }
  [[gnu::always_inline]] static double min(double a, double b) { return std::min(a, b); }
  [[gnu::always_inline]] static double max(double a, double b) { return std::max(a, b); }
  [[gnu::always_inline]] static double pick(bool condition, double a, double b) {
    return condition ? a : b;
  }
  [[gnu::always_inline]] static bool any(bool condition) { return condition; }
  [[gnu::always_inline]] static double abs(double x) { return std::abs(x); }
  [[gnu::always_inline]] static double copysign(double size, double sign) {
    return std::copysign(size, sign);
  }
  [[gnu::always_inline]] static double ninth_root(double x) { return std::pow(x, 1.0 / 9.0); }
};

}  // namespace adore
