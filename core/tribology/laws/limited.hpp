#pragma once

#include "base/inverse_roots.hpp"
#include "base/scalar_math.hpp"

namespace adore::tribology {

/// The limiting stress τ <= Λ p of a lubricant as a smooth minimum of fourth order: (κ^-4 +
/// Λ^-4)^(-1/4) [choice].
struct LimitedTraction {
  double inverse2 = 0.0;  ///< 1/Λ²; 0: no limit

  static LimitedTraction at(double ratio) { return {ratio > 0.0 ? 1.0 / (ratio * ratio) : 0.0}; }

  template <class T>
  [[gnu::always_inline]] T of(T kappa) const {
    using M = ScalarMath<T>;
    if (!(inverse2 > 0.0)) return kappa;
    // What is far beyond the limit is cut: its fourth power would leave the range of a root.
    kappa = M::min(kappa, T(1e3));
    const T over = kappa * kappa * inverse2;
    return kappa * InverseRoots<T>::fourth(1.0 + over * over);
  }
};

}  // namespace adore::tribology
