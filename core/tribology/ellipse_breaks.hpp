#pragma once

#include <algorithm>
#include <cmath>

/// Where the traction changes its character along the major axis, for the split rule
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
template <class T, class Pick>
[[gnu::always_inline]] inline void clipped_zeros(T q2, T q1, T q0, const Pick& pick, T& low,
                                                 T& high) {
  using std::max;
  using std::min;
  using std::sqrt;
  const T zero(0.0), one(1.0), negligible(1e-200), small(1e-100);
  const T discriminant = q1 * q1 - 4.0 * q2 * q0;
  const T root = sqrt(max(discriminant, zero));
  T w = -0.5 * pick(q1 < zero, q1 - root, q1 + root);  // no cancellation
  w = pick(w * w < negligible, small, w);
  const T first = max(min(w / q2, one), -one);
  const T second = pick(discriminant < zero, first, max(min(q0 / w, one), -one));
  low = min(first, second);
  high = max(first, second);
}

/// Where u_t = -width and u_t = +width, u_t being the parabola through its values at ξ = -a, 0, a.
/// A curve that does not reach one of them has both break points at its vertex (or at an end): the
/// piece between them is empty, and the rule stays continuous in the motion. T is double or a
/// vector of doubles; pick(condition, a, b) chooses per lane.
template <class T, class Pick>
[[gnu::always_inline]] inline EllipseBreaks<T> ellipse_breaks(T left, T centre, T right, T width,
                                                              const Pick& pick) {
  using std::max;
  using std::min;
  const T negligible(1e-200), small(1e-100);
  const T q1 = 0.5 * (right - left);
  T q2 = 0.5 * (right + left) - centre;
  q2 = pick(q2 * q2 < negligible, small, q2);
  T low_above, high_above, low_below, high_below;
  clipped_zeros(q2, q1, centre - width, pick, low_above, high_above);
  clipped_zeros(q2, q1, centre + width, pick, low_below, high_below);
  return {min(low_above, low_below), max(low_above, low_below), min(high_above, high_below),
          max(high_above, high_below)};
}

}  // namespace adore::tribology
