#pragma once

#include "base/inverse_roots.hpp"
#include "base/scalar_math.hpp"

namespace adore::tribology {

/// Limiting shear stress of a film, τ <= Λ p, as a smooth minimum of eighth order:
///   κ = κ_law (1 + (κ_law/Λ)^8)^(-1/8),  κ = τ/p [-].
/// κ <= Λ always; κ_law is changed by 2 % at 0.8 Λ and by 0.05 % at 0.5 Λ (order: [choice], so that
/// laws keep their values where they were measured). Λ: resources/lubricants.json,
/// "limitingStress".
struct TractionLimiter {
  double inverse2 = 0.0;  ///< 1/Λ²; 0: no limit

  static TractionLimiter at(double ratio) { return {ratio > 0.0 ? 1.0 / (ratio * ratio) : 0.0}; }

  template <class T>
  [[gnu::always_inline]] T of(T kappa) const {
    using M = ScalarMath<T>;
    if (!(inverse2 > 0.0)) return kappa;
    // Cut far beyond the limit: the eighth power must stay in the range of the root (1e30).
    kappa = M::min(kappa, T(10.0));
    const T over = kappa * kappa * inverse2, over2 = over * over;
    const T fourth = InverseRoots<T>::fourth(1.0 + over2 * over2);
    return kappa * (fourth * M::inverse_sqrt(fourth));
  }
};

}  // namespace adore::tribology
