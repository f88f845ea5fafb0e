#pragma once

#include "base/scalar_math.hpp"

/// Points where the traction changes its character along the major axis, for the split rule
/// (ellipse_traction.hpp).
namespace adore::tribology {

inline constexpr int kEllipsePieces = 5;  ///< that the break points make

/// Break points s = ξ/a in [-1, 1], ascending.
template <class T>
struct EllipseBreaks {
  T s1, s2, s3, s4;
};

/// Both zeros of q2 s² + q1 s + q0, clipped to [-1, 1]; without real zeros twice the vertex. q2 ≠
/// 0.
template <class T>
[[gnu::always_inline]] inline void clipped_zeros(T q2, T q1, T q0, T& low, T& high) {
  using M = ScalarMath<T>;
  const T zero(0.0), one(1.0), negligible(1e-200), small(1e-100);
  const T discriminant = q1 * q1 - 4.0 * q2 * q0;
  const T root = M::sqrt(M::max(discriminant, zero));
  T w = -0.5 * M::pick(q1 < zero, q1 - root, q1 + root);  // no cancellation
  w = M::pick(w * w < negligible, small, w);
  const T first = M::max(M::min(w / q2, one), -one);
  const T second = M::pick(discriminant < zero, first, M::max(M::min(q0 / w, one), -one));
  low = M::min(first, second);
  high = M::max(first, second);
}

/// Points with u_t = -width and u_t = +width, u_t being the parabola through its values at ξ = -a,
/// 0, a. A curve that does not reach one of them has both break points at its vertex (or at an
/// end): the piece between them is empty, and the rule stays continuous in the motion. T is double
/// or a vector of doubles.
template <class T>
[[gnu::always_inline]] inline EllipseBreaks<T> ellipse_breaks(T left, T centre, T right, T width) {
  using M = ScalarMath<T>;
  const T negligible(1e-200), small(1e-100);
  const T q1 = 0.5 * (right - left);
  T q2 = 0.5 * (right + left) - centre;
  q2 = M::pick(q2 * q2 < negligible, small, q2);
  T low_above, high_above, low_below, high_below;
  clipped_zeros(q2, q1, centre - width, low_above, high_above);
  clipped_zeros(q2, q1, centre + width, low_below, high_below);
  return {M::min(low_above, low_below), M::max(low_above, low_below),
          M::min(high_above, high_below), M::max(high_above, high_below)};
}

}  // namespace adore::tribology
