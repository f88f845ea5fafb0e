#pragma once

#include <cmath>

/// The numbers in what ScalarMath<T> calculates with, one by one: for look-ups in tables. Of
/// vectors in base/simd_math.hpp. Seen by the race kernels.
namespace adore {

template <class T>
struct ScalarLanes;

template <>
struct ScalarLanes<double> {
  static constexpr int kCount = 1;
  [[gnu::always_inline]] static double get(double x, int) { return x; }
  [[gnu::always_inline]] static double from(const double* values) { return *values; }
  [[gnu::always_inline]] static double floor(double x) { return std::floor(x); }
};

}  // namespace adore
