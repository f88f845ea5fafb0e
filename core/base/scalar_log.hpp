#pragma once

#include <cmath>

/// Natural logarithm of what ScalarMath<T> calculates with, x > 0; of vectors in
/// base/simd_math.hpp. Seen by the race kernels.
namespace adore {

template <class T>
struct ScalarLog;

template <>
struct ScalarLog<double> {
  [[gnu::always_inline]] static double log(double x) { return std::log(x); }
};

}  // namespace adore
