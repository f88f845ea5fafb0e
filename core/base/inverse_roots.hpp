#pragma once

#include <cmath>

/// Inverses that laws of traction ask for at many points, of numbers; of vectors in
/// base/simd_inverse_roots.hpp. Seen by the race kernels.
namespace adore {

template <class T>
struct InverseRoots;

template <>
struct InverseRoots<double> {
  /// x^(-1/4), 1 <= x <= 1e30
  [[gnu::always_inline]] static double fourth(double x) { return 1.0 / std::sqrt(std::sqrt(x)); }
  /// 1/x, 1e-30 <= x <= 1e30
  [[gnu::always_inline]] static double first(double x) { return 1.0 / x; }
};

}  // namespace adore
