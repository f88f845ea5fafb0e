#pragma once

#include "base/scalar_math.hpp"
#include "contact/race_shape.hpp"
#include "contact/triple.hpp"

/// Where the circle of a roller slice is deepest in a race: the one statement, for one slice (T =
/// double) and for a slice a lane (T = vector). SI.
///
/// Slice: the circle of radius ρ about P = C + s a in the plane across the roller axis a. Its
/// penetration is the greatest depth of that circle in the race [choice]: δ = φ(X), X = P + ρ u(χ),
/// u = cos χ b1 + sin χ b2 with b1, b2 across a. Newton on δ_χ = ρ n·u_χ = 0, with the curvature
/// tensor N = ∇∇φ of the race's distance function: δ_χχ = ρ (ρ u_χ·N u_χ - n·u), N = n_r/r along
/// the hoop and 1/l along the meridian of a groove, -k/S of a crown [derived]. Two or three passes
/// end at rounding.
///
/// All in the race's axes turned about x so that C lies in the plane of x and z ("meridian frame"),
/// z > 0: x along the race axis, y = z × x.
namespace adore::contact {

/// Depth at a point of the race, with the local axes of the curvature tensor.
template <class T>
struct SurfaceDepth {
  T depth{};                         ///< φ [m]
  Triple<T> n;                       ///< ∇φ, from the roller into the race
  Triple<T> hoop, meridian;          ///< principal directions
  T A_hoop = 0.0, A_meridian = 0.0;  ///< ∇∇φ on them [1/m]
};

template <class T>
[[gnu::always_inline]] inline SurfaceDepth<T> surface_depth(const RaceSurface& race,
                                                            const Triple<T>& X) {
  using M = ScalarMath<T>;
  SurfaceDepth<T> s;
  // Arc centres of barrels can lie beyond the axis: there r is negative.
  const T r = M::copysign(M::sqrt(X.y * X.y + X.z * X.z), X.z);
  const T over_r = 1.0 / r;
  const T ey = X.y * over_r;
  const T ez = X.z * over_r;
  T nx, nr;
  if (race.shape == RaceSurface::Shape::Cone) {
    const double sigma = race.sigma();
    s.depth = sigma * ((r - race.radius) * race.cos_angle + X.x * race.sin_angle);
    nx = sigma * race.sin_angle;
    nr = sigma * race.cos_angle;
  } else if (race.shape == RaceSurface::Shape::Groove) {
    const T x = X.x - race.groove_x;
    const T y = r - race.groove_centre_radius;
    const T l = M::sqrt(x * x + y * y);
    s.depth = l - race.groove_radius;
    s.A_meridian = 1.0 / l;
    nx = x * s.A_meridian;
    nr = y * s.A_meridian;
  } else {
    const double sigma = race.sigma(), k = race.crown_curvature;
    const T cone = sigma * ((r - race.radius) * race.cos_angle + X.x * race.sin_angle);
    const T l =
        (X.x - race.mid_x) * race.cos_angle - (r - race.mid_r) * race.sin_angle - race.land_offset;
    const T e = M::max(M::abs(l) - 0.5 * race.crown_land, T(0.0));
    const T up = 1.0 - k * cone, out = k * M::copysign(e, l);
    const T S = M::sqrt(out * out + up * up), over_S = 1.0 / S;
    s.depth = (2.0 * cone - k * (e * e + cone * cone)) / (1.0 + S);
    s.A_meridian = M::pick(e > 0.0, -k * over_S, T(0.0));
    const T along = -out * over_S, across = sigma * up * over_S;
    nx = across * race.sin_angle + along * race.cos_angle;
    nr = across * race.cos_angle - along * race.sin_angle;
  }
  s.n = {nx, nr * ey, nr * ez};
  s.hoop = {T(0.0), ez, -ey};
  s.meridian = {nr, -nx * ey, -nx * ez};
  s.A_hoop = nr * over_r;
  return s;
}

/// Roller axis in the meridian frame and two directions across it: b1 in the meridian plane, b2
/// towards y.
struct SliceAxes {
  Triple<double> a, b1, b2;
};
/// From t = a_z and f = a_y: a = (c, f, t), b1 = (-t, 0, c)/m, b2 = (-f c, m², -f t)/m with m² =
/// 1 - f², c² = m² - t². Needs a_x > 0.
[[nodiscard, gnu::always_inline]] inline SliceAxes slice_axes(double t, double f) noexcept {
  const double m2 = 1.0 - f * f;
  const double m = std::sqrt(m2);
  const double c = std::sqrt(m2 - t * t);
  return {{c, f, t}, {-t / m, 0.0, c / m}, {-f * c / m, m, -f * t / m}};
}

/// Slices at the places where their circles are deepest in the race.
template <class T>
struct DeepestSlicePoint {
  T s, radius;
  Triple<T> u, w;  ///< from the roller axis to the point, and across: u_χ
  Triple<T> X;
  SurfaceDepth<T> at;
  T hoop = 0.0, meridian = 0.0;  ///< w in the race's principal directions
};

/// tan χ of the deepest point to first order in the skew a_y (the next term is of third order): the
/// first step of Newton from the meridian plane, with a normal that need not be a unit vector.
template <class T>
[[nodiscard, gnu::always_inline]] inline T first_order_tan_chi(const RaceSurface& race,
                                                               const SliceAxes& axes, double x,
                                                               double r, const T& s,
                                                               const T& radius) {
  using M = ScalarMath<T>;
  const double sigma = race.sigma();
  const T reach = sigma * radius;
  const T z = r + s * axes.a.z + reach * axes.b1.z;
  T nx = race.sin_angle, nr = race.cos_angle;
  if (race.shape != RaceSurface::Shape::Cone) {
    const T X = x + s * axes.a.x + reach * axes.b1.x;
    if (race.shape == RaceSurface::Shape::Groove) {
      nx = X - race.groove_x;
      nr = z - race.groove_centre_radius;
    } else {
      const double k = race.crown_curvature;
      const T cone = sigma * ((z - race.radius) * race.cos_angle + X * race.sin_angle);
      const T l =
          (X - race.mid_x) * race.cos_angle - (z - race.mid_r) * race.sin_angle - race.land_offset;
      const T e = M::max(M::abs(l) - 0.5 * race.crown_land, T(0.0));
      const T along = -k * M::copysign(e, l), across = sigma * (1.0 - k * cone);
      nx = across * race.sin_angle + along * race.cos_angle;
      nr = across * race.cos_angle - along * race.sin_angle;
    }
  }
  const double across = axes.b2.y;
  const T slope = (nx * axes.b2.x + nr * axes.b2.z) * z + nr * (s * (axes.a.y * across));
  const T curvature = (nx * axes.b1.x + nr * axes.b1.z) * z - reach * nr * (across * across);
  return slope / curvature;
}

/// Newton from tan χ, which becomes that of the deepest point. Nothing leaves the meridian plane
/// when a_y = 0.
/// @param x, r place of C along and from the race axis [m]
template <class T>
[[gnu::always_inline]] inline DeepestSlicePoint<T> deepest_slice_point(const RaceSurface& race,
                                                                       const SliceAxes& axes,
                                                                       double x, double r,
                                                                       const T& s, const T& radius,
                                                                       T& tan_chi) {
  using M = ScalarMath<T>;
  const double sigma = race.sigma();
  constexpr double kSmallTurn = 1e-8;
  DeepestSlicePoint<T> d;
  d.s = s;
  d.radius = radius;
  const Triple<T> middle{x + s * axes.a.x, s * axes.a.y, r + s * axes.a.z};
  for (int pass = 0; pass < 6; ++pass) {
    const T cosine = sigma / M::sqrt(1.0 + tan_chi * tan_chi);
    const T sine = tan_chi * cosine;
    d.u = cosine * axes.b1 + sine * axes.b2;
    d.w = cosine * axes.b2 + -sine * axes.b1;
    d.X = middle + radius * d.u;
    d.at = surface_depth(race, d.X);
    d.hoop = dot(d.at.hoop, d.w);
    d.meridian = dot(d.at.meridian, d.w);
    if (axes.a.y == 0.0) return d;
    const T h = radius * d.at.A_hoop * d.hoop;
    const T m = radius * d.at.A_meridian * d.meridian;
    const T turn = dot(d.at.n, d.w) / (dot(d.at.n, d.u) - h * d.hoop - m * d.meridian);
    tan_chi += (1.0 + tan_chi * tan_chi) * turn;
    if (!M::any(M::abs(turn) >= kSmallTurn)) {
      // What this leaves is of the order of the turn's square.
      const Triple<T> u = d.u;
      d.u = u + turn * d.w;
      d.X = d.X + radius * turn * d.w;
      d.w = d.w + -turn * u;
      d.at.n = d.at.n + turn * h * d.at.hoop + turn * m * d.at.meridian;
      return d;
    }
  }
  return d;
}

/// The meridian frame of a point off the race axis: base = race axes.
struct MeridianRotation {
  double ey = 0.0, ez = 1.0;  ///< z of the frame in the race's axes
  template <class T = double>
  [[nodiscard]] Triple<T> to_meridian(const Triple<T>& v) const noexcept {
    return {v.x, v.y * ez - v.z * ey, v.y * ey + v.z * ez};
  }
  template <class T = double>
  [[nodiscard]] Triple<T> from_meridian(const Triple<T>& v) const noexcept {
    return {v.x, v.y * ez + v.z * ey, v.z * ez - v.y * ey};
  }
};
[[nodiscard]] inline MeridianRotation meridian_rotation(double y, double z, double& r) noexcept {
  r = std::sqrt(y * y + z * z);
  return {y / r, z / r};
}

}  // namespace adore::contact
