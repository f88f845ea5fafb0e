#pragma once

#include "tribology/ellipse_sum.hpp"

/// The largest slip of a contact is at the edge of its ellipse, ξ = a sin φ, where |u_c| is
/// |mean| + |W_n| b cos φ (u_t and mean: ellipse_sum.hpp). It is searched at fifteen fixed φ,
/// closer towards the ends, and where u_t, taken as a parabola in ξ, has its vertex; that is never
/// above the exact value. Of 40,000 contacts of all kinds of motion 99 of 100 are at most 0.2 %
/// larger elsewhere, the worst 1.2 %. For numbers and vectors.
namespace adore::tribology {

/// |u|² there [m²/s²].
template <class T, class S>
[[gnu::always_inline]] inline T largest_slip_square(const EllipseContact<T, S>& e) {
  using M = ScalarMath<T>;
  // sin φ and cos φ of 90°, 83°, 73°, 60°, 45°, 30°, 15° and 0°; both signs at once.
  constexpr int kPlaces = 8;
  constexpr double kSine[kPlaces] = {1.0,
                                     0.99254615164132198,
                                     0.95630475596303544,
                                     0.86602540378443865,
                                     0.70710678118654752,
                                     0.5,
                                     0.25881904510252076,
                                     0.0};
  constexpr double kCosine[kPlaces] = {0.0,
                                       0.12186934340514748,
                                       0.29237170472273677,
                                       0.5,
                                       0.70710678118654752,
                                       0.86602540378443865,
                                       0.96592582628906829,
                                       1.0};
  const EllipseMotion<T>& m = e.motion;
  const T swing = M::abs(m.W_n * e.b), spin = M::abs(m.W_n * e.a);
  T largest = 0.0, at_end = 0.0, at_middle = 0.0;
  for (int k = 0; k < kPlaces; ++k) {
    const T h = e.surface.height(kSine[k] * e.a);
    const T even = m.u_t - m.W_c * h;
    const T along = M::abs(even) + kSine[k] * spin;
    const T across = M::abs(m.u_c + m.W_t * h) + kCosine[k] * swing;
    largest = M::max(largest, along * along + across * across);
    if (k == 0) at_end = even;
    at_middle = even;
  }
  // u_t = at_middle + (at_end - at_middle) s² + W_n a s
  const T bend = M::abs(at_end - at_middle);
  const T vertex = M::pick(spin < 2.0 * bend, spin / M::max(2.0 * bend, T(1e-300)), T(0.0));
  const T h = e.surface.height(vertex * e.a);
  const T even = m.u_t - m.W_c * h;
  const T rest = M::max(1.0 - vertex * vertex, T(0.0));
  const T across = M::abs(m.u_c + m.W_t * h) + M::root(rest) * swing;
  const T along = M::abs(even) + vertex * spin;
  return M::max(largest, along * along + across * across);
}

}  // namespace adore::tribology
