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
  [[gnu::always_inline]] static void put(double x, double* values) { *values = x; }
  [[gnu::always_inline]] static double floor(double x) { return std::floor(x); }
  /// table[place], `place` a whole number below 2^31 and not negative.
  [[gnu::always_inline]] static double gather(const double* table, double place) {
    return table[static_cast<int>(place)];
  }
};

}  // namespace adore
