#pragma once

#include "base/scalar_math.hpp"
#include "base/single.hpp"

namespace adore::tribology {

/// A property of a lubricant at one temperature over pressure, Σ c_k x^k, x = 2 p/end - 1; beyond
/// `end`, the pressure where the lubricant is a glass or the last one that a run can meet, its
/// value there. Made by pressure_fits.hpp, which measures its error. Powers, of a Chebyshev sum
/// whose terms fall: rounding of 24 of them stays below 1e-10, at a third of the operations.
struct PressurePolynomial {
  static constexpr int kMost = 24;
  int terms = 1;
  double scale = 0.0;  ///< 2/end [1/Pa]; 0: constant
  double c[kMost] = {};
  float single[kMost] = {};  ///< the same, for films in single precision

  template <class T>
  [[gnu::always_inline]] auto power(int k) const {
    if constexpr (IsSinglePrecision<T>::value)
      return single[k];
    else
      return c[k];
  }

  template <class T>
  [[gnu::always_inline]] T place(const T& pressure) const {
    return ScalarMath<T>::min(pressure * scale, T(2.0)) - 1.0;
  }
  template <class T>
  [[gnu::always_inline]] T at(const T& pressure) const {
    const T x = place(pressure);
    T sum = c[terms - 1];
    for (int k = terms - 2; k >= 0; --k) sum = sum * x + c[k];
    return sum;
  }
};

/// Two fits at N pressures at once: their chains of dependent sums overlap.
template <int N, class T>
[[gnu::always_inline]] inline void evaluate_polynomial_pair(const PressurePolynomial& first,
                                                            const PressurePolynomial& second,
                                                            const T* pressure, T* of_first,
                                                            T* of_second) {
  T x[N], y[N];
#pragma GCC unroll 4
  for (int i = 0; i < N; ++i) {
    x[i] = first.place(pressure[i]);
    y[i] = second.place(pressure[i]);
    of_first[i] = of_second[i] = 0.0;
  }
  const int terms = first.terms > second.terms ? first.terms : second.terms;
  for (int k = terms - 1; k >= 0; --k) {  // terms that one lacks are 0
#pragma GCC unroll 4
    for (int i = 0; i < N; ++i) {
      of_first[i] = of_first[i] * x[i] + first.template power<T>(k);
      of_second[i] = of_second[i] * y[i] + second.template power<T>(k);
    }
  }
}

}  // namespace adore::tribology
