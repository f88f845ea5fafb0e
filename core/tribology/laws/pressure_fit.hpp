#pragma once

#include "base/scalar_math.hpp"

namespace adore::tribology {

/// A property of a lubricant at one temperature over pressure, Σ c_k T_k(x), x = 2 p/end - 1;
/// beyond `end`, the pressure where the lubricant is a glass or the last one that a run can meet,
/// its value there. Made by pressure_fits.hpp, which measures its error.
struct PressureFit {
  static constexpr int kMost = 24;
  int terms = 1;
  double scale = 0.0;  ///< 2/end [1/Pa]; 0: constant
  double c[kMost] = {};

  template <class T>
  [[gnu::always_inline]] T at(const T& pressure) const {
    T out[1];
    at<1>(&pressure, out);
    return out[0];
  }
  /// Of N points at once: their chains of dependent sums overlap.
  template <int N, class T>
  [[gnu::always_inline]] void at(const T* pressure, T* out) const {
    T x[N], last[N], now[N];
    for (int i = 0; i < N; ++i) {
      x[i] = ScalarMath<T>::min(pressure[i] * scale, T(2.0)) - 1.0;
      last[i] = now[i] = 0.0;
    }
    for (int k = terms - 1; k > 0; --k)  // Clenshaw
      for (int i = 0; i < N; ++i) {
        const T next = 2.0 * x[i] * now[i] - last[i] + c[k];
        last[i] = now[i];
        now[i] = next;
      }
    for (int i = 0; i < N; ++i) out[i] = x[i] * now[i] - last[i] + c[0];
  }
};

}  // namespace adore::tribology
