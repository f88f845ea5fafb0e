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
  /// Σ along[i] across[j] table[place + i line + j] over i, j = 0 ... 3, `place` as above.
  [[gnu::always_inline]] static double patch(const double* table, int line, double place,
                                             const double* along, const double* across) {
    const double* first = table + static_cast<int>(place);
    double sum = 0.0;
    for (int j = 0; j < 4; ++j)
      sum += across[j] * (along[0] * first[j] + along[1] * first[line + j] +
                          along[2] * first[2 * line + j] + along[3] * first[3 * line + j]);
    return sum;
  }
};

}  // namespace adore
