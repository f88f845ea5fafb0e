#pragma once

#include "base/scalar_math.hpp"
#include "contact/slice_circle.hpp"

#include <array>
#include <cmath>
#include <cstddef>

/// Sums of slice loads with their exact derivatives: what slice_potential.hpp states, for a slice
/// (T = double) and for a slice a lane (T = vector), for kernels too. SI.
namespace adore::statics {

/// How t and f turn the roller axis a = (c, f, t): a changes by θ × a, θ = θ_t dt + θ_f df + ½ (0,
/// t, -f) (k_tt dt² + 2 k_tf dt df + k_ff df²), θ_t = a × a_t and so on. A turn about a itself
/// moves no slice circle, so that θ is free of it.
struct SliceRotations : contact::SliceAxes {
  contact::Triple<double> turn_t, turn_f;
  double k_tt = 0.0, k_tf = 0.0, k_ff = 0.0;  ///< x of a_tt, a_tf, a_ff, which have no y and z
  double tt = 0.0, tf = 0.0, ff = 0.0;        ///< θ_t·θ_t and so on
};

[[nodiscard, gnu::always_inline]] inline SliceRotations slice_rotations(double t,
                                                                        double f) noexcept {
  SliceRotations out{contact::slice_axes(t, f), {}, {}};
  const double c = out.a.x;
  const double c3 = c * c * c;
  out.turn_t = cross(out.a, contact::Triple<double>{-t / c, 0.0, 1.0});
  out.turn_f = cross(out.a, contact::Triple<double>{-f / c, 1.0, 0.0});
  out.k_tt = -(1.0 - f * f) / c3;
  out.k_tf = -t * f / c3;
  out.k_ff = -(c * c + f * f) / c3;
  out.tt = dot(out.turn_t, out.turn_t);
  out.tf = dot(out.turn_t, out.turn_f);
  out.ff = dot(out.turn_f, out.turn_f);
  return out;
}

/// Lower triangle of a symmetric matrix of 4, row by row.
[[gnu::always_inline]] constexpr int lower_triangle_index(int i, int j) {
  return i * (i + 1) / 2 + j;
}

/// Of the place of a slice along the land (contact/land_edge.hpp): derivatives over p.
template <class T>
struct LandPositionDerivatives {
  std::array<T, 4> over;
  T tt, tf, ff;  ///< second ones over t and f
};
template <class T>
[[nodiscard, gnu::always_inline]] inline LandPositionDerivatives<T> land_position_derivatives(
    const SliceRotations& axes, double sigma, const T& s, const T& radius) {
  const double c = axes.a.x, f = axes.a.y, t = axes.a.z;
  const double m = std::sqrt(1.0 - f * f), m3 = m * m * m;
  const T out = sigma * radius;
  return {{T(1.0), T(0.0), s * (-t / c) - out * (1.0 / m), s * (-f / c) - out * (t * f / m3)},
          s * axes.k_tt,
          s * axes.k_tf - out * (f / m3),
          s * axes.k_ff - out * (t / m3 * (1.0 + 3.0 * f * f / (m * m)))};
}

/// What slices at the edges of a land add (contact/land_edge.hpp).
template <class T>
struct EdgeSums {
  std::array<T, 4> gradient;
  std::array<T, 10> hessian;
  bool reached = false;

  EdgeSums() {
    gradient.fill(T(0.0));
    hessian.fill(T(0.0));
  }
  /// @param over ∂δ/∂p of the slice; narrows: w' of its width on the land over the land coordinate
  void add(const LandPositionDerivatives<T>& place, const std::array<T, 4>& over, const T& load,
           const T& depth, const T& width, const T& narrows, double cos_angle) {
    reached = true;
    const T per_width = load * narrows * (1.0 / cos_angle) / ScalarMath<T>::max(width, T(1e-30));
    const T energy = (9.0 / 19.0) * depth * per_width;
    std::size_t k = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      gradient[i] += energy * place.over[i];
      for (std::size_t j = 0; j <= i; ++j)
        hessian[k++] += per_width * (over[i] * place.over[j] + place.over[i] * over[j]);
    }
    hessian[lower_triangle_index(2, 2)] += energy * place.tt;
    hessian[lower_triangle_index(3, 2)] += energy * place.tf;
    hessian[lower_triangle_index(3, 3)] += energy * place.ff;
  }
};

/// What slices add to the potential, but for the edges of lands.
template <class T>
struct SliceSums {
  std::array<T, 4> gradient;
  std::array<T, 10> hessian;
  T load = 0.0, slope = 0.0;
  std::array<T, 4> over;  ///< of the last: ∂δ/∂p

  SliceSums() {
    gradient.fill(T(0.0));
    hessian.fill(T(0.0));
  }

  /// Load and stiffness of slices with the derivatives of their penetration.
  void add(const SliceRotations& axes, const contact::DeepestSlicePoint<T>& d, const T& q,
           const T& q_slope) {
    const contact::Triple<T>& n = d.at.n;
    const contact::Triple<T> arm = d.s * axes.a + d.radius * d.u;
    const contact::Triple<T> X_t = cross(axes.turn_t, arm), X_f = cross(axes.turn_f, arm);
    over = {n.x, n.z, dot(n, X_t), dot(n, X_f)};
    // Motion of the point in the principal directions, and δ_χp.
    const T hoop = d.radius * d.hoop;
    const T meridian = d.radius * d.meridian;
    const std::array<T, 4> h{T(0.0), d.at.hoop.z, dot(d.at.hoop, X_t), dot(d.at.hoop, X_f)};
    const std::array<T, 4> m{d.at.meridian.x, d.at.meridian.z, dot(d.at.meridian, X_t),
                             dot(d.at.meridian, X_f)};
    const T A_h = d.at.A_hoop * hoop;
    const T A_m = d.at.A_meridian * meridian;
    const contact::Triple<T> across = cross(d.radius * d.w, n);
    std::array<T, 4> chi{T(0.0), T(0.0), dot(axes.turn_t, across), dot(axes.turn_f, across)};
    const T n_u = d.radius * dot(n, d.u);
    const T over_bend = q / (n_u - A_h * hoop - A_m * meridian);  // -Q/δ_χχ
    const T q_h = q * d.at.A_hoop;
    const T q_m = q * d.at.A_meridian;
    std::size_t k = 0;
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) {
      gradient[i] += q * over[i];
      chi[i] += A_h * h[i] + A_m * m[i];
      const T over_i = q_slope * over[i];
      const T h_i = q_h * h[i];
      const T m_i = q_m * m[i];
      const T chi_i = over_bend * chi[i];
#pragma GCC unroll 4
      for (std::size_t j = 0; j <= i; ++j) {
        hessian[k++] += over_i * over[j] + h_i * h[j] + m_i * m[j] + chi_i * chi[j];
      }
    }
    // n·X_pq of the turns: θ_p × (θ_q × arm), even in p and q, and what a_pq adds.
    const T n_t = dot(n, axes.turn_t);
    const T n_f = dot(n, axes.turn_f);
    const T arm_t = dot(arm, axes.turn_t);
    const T arm_f = dot(arm, axes.turn_f);
    const T n_arm = d.s * dot(n, axes.a) + n_u;
    const T bow = n.x * (axes.a.z * arm.z + axes.a.y * arm.y) -
                  arm.x * (axes.a.y * n.y + axes.a.z * n.z);  // n·((0, t, -f) × arm)
    hessian[lower_triangle_index(2, 2)] += q * (axes.k_tt * bow + n_t * arm_t - axes.tt * n_arm);
    hessian[lower_triangle_index(3, 2)] +=
        q * (axes.k_tf * bow + 0.5 * (n_t * arm_f + n_f * arm_t) - axes.tf * n_arm);
    hessian[lower_triangle_index(3, 3)] += q * (axes.k_ff * bow + n_f * arm_f - axes.ff * n_arm);
    load += q;
    slope += q_slope;
  }
};

}  // namespace adore::statics
