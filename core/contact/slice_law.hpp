#pragma once

#include "base/scalar_math.hpp"

/// Load of a roller slice over its penetration: numbers only, for kernels too.
namespace adore::contact {

/// Power law Q = K_l L_e^(-1/9) w δ^(10/9) [derived from Palmgren's]. L_e is the WHOLE effective
/// length: the roller law applied to each slice by itself would give n^(1/9) times the load (1.46
/// for 30 slices). C1 at δ = 0, zero below.
struct PowerLaw {
  double constant = 0.0;  ///< K_l L_e^(-1/9) [N m^(-19/9)]
};
/// Secant stiffness Q/δ for δ >= 0 [N/m]; of numbers or vectors.
template <class T>
[[nodiscard, gnu::always_inline]] inline T slice_secant_stiffness(const PowerLaw& law,
                                                                  const T& width, const T& delta) {
  return law.constant * width * ScalarMath<T>::ninth_root(delta);
}

}  // namespace adore::contact
