#include "statics/slice_potential.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::statics {
namespace {

struct V3 {
  double x = 0.0, y = 0.0, z = 0.0;
};
constexpr V3 operator+(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr V3 operator*(double s, const V3& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr double dot(const V3& a, const V3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A vector that follows the roller axis, with its derivatives over t and f.
struct Turning {
  V3 v, t, f, tt, tf, ff;
};
Turning combine(double a, const Turning& u, double b, const Turning& w) {
  return {a * u.v + b * w.v,   a * u.t + b * w.t,   a * u.f + b * w.f,
          a * u.tt + b * w.tt, a * u.tf + b * w.tf, a * u.ff + b * w.ff};
}

/// The roller axis and the two directions across it: b1 in the meridian plane, b2 towards y.
struct Axes {
  Turning a, b1, b2;
};

/// a = (c, f, t), b1 = (-t, 0, c)/m, b2 = (-f c, m², -f t)/m with m² = 1 - f², c² = m² - t².
Axes axes_at(double t, double f) {
  const double m2 = 1.0 - f * f;
  const double m = std::sqrt(m2);
  const double c = std::sqrt(m2 - t * t);
  const double c3 = c * c * c;
  const double m3 = m * m2;
  const double m5 = m3 * m2;
  Axes out;
  out.a = {{c, f, t},
           {-t / c, 0.0, 1.0},
           {-f / c, 1.0, 0.0},
           {-m2 / c3, 0.0, 0.0},
           {-t * f / c3, 0.0, 0.0},
           {-(c * c + f * f) / c3, 0.0, 0.0}};
  const double t2 = t * t;
  out.b1 = {{-t / m, 0.0, c / m},
            {-1.0 / m, 0.0, -t / (c * m)},
            {-t * f / m3, 0.0, -f * t2 / (c * m3)},
            {0.0, 0.0, -m / c3},
            {-f / m3, 0.0, -f / m3 * (2.0 * t / c + t * t2 / c3)},
            {-t * (1.0 / m3 + 3.0 * f * f / m5), 0.0,
             -t2 * (1.0 / (c * m3) + f * f / (c3 * m3) + 3.0 * f * f / (c * m5))}};
  out.b2 = {{-f * c / m, m, -f * t / m},
            {f * t / (c * m), 0.0, -f / m},
            {-c / m + f * f * t2 / (c * m3), -f / m, -t / m3},
            {f * m / c3, 0.0, 0.0},
            {t / (c * m) + f * f / m3 * (2.0 * t / c + t * t2 / c3), 0.0, -1.0 / m3},
            {f * t2 / (c * m3) +
                 t2 * (2.0 * f / (c * m3) + f * f * f / (c3 * m3) + 3.0 * f * f * f / (c * m5)),
             -1.0 / m3, -3.0 * t * f / m5}};
  return out;
}

/// Depth at a point of the race frame, with the local axes of the curvature tensor.
struct Surface {
  double depth = 0.0;
  V3 n;                                   ///< normal
  V3 hoop, meridian;                      ///< principal directions
  double A_hoop = 0.0, A_meridian = 0.0;  ///< ∇∇φ on them [1/m]
};

Surface surface_at(const contact::RaceSurface& race, const V3& X) {
  Surface s;
  // Arc centres of barrels (add_point) can lie beyond the axis: there r is negative.
  const double r = std::copysign(std::sqrt(X.y * X.y + X.z * X.z), X.z);
  const double ey = X.y / r;
  const double ez = X.z / r;
  double nx = 0.0;
  double nr = 0.0;
  if (race.shape == contact::RaceSurface::Shape::Cone) {
    const double sigma = race.sigma();
    s.depth = sigma * ((r - race.radius) * race.cos_angle + X.x * race.sin_angle);
    nx = sigma * race.sin_angle;
    nr = sigma * race.cos_angle;
  } else {
    const double x = X.x - race.groove_x;
    const double y = r - race.groove_centre_radius;
    const double l = std::sqrt(x * x + y * y);
    s.depth = l - race.groove_radius;
    nx = x / l;
    nr = y / l;
    s.A_meridian = 1.0 / l;
  }
  s.n = {nx, nr * ey, nr * ez};
  s.hoop = {0.0, ez, -ey};
  s.meridian = {nr, -nx * ey, -nx * ez};
  s.A_hoop = nr / r;
  return s;
}

/// Newton on n·u_χ = 0; exact at once when nothing leaves the meridian plane (f = 0).
Surface find_deepest(const contact::RaceSurface& race, const Axes& axes, const V3& P, double radius,
                     double sigma, double& cos_chi, double& sin_chi, V3& X) {
  Surface at;
  for (int pass = 0; pass < 6; ++pass) {
    const V3 u = (sigma * cos_chi) * axes.b1.v + (sigma * sin_chi) * axes.b2.v;
    X = P + radius * u;
    at = surface_at(race, X);
    if (axes.a.v.y == 0.0) {
      return at;
    }
    const V3 along = (-sigma * sin_chi) * axes.b1.v + (sigma * cos_chi) * axes.b2.v;
    const double slope = dot(at.n, along);  // δ_χ/ρ
    const double hoop = dot(at.hoop, along);
    const double meridian = dot(at.meridian, along);
    const double bend =
        -dot(at.n, u) + radius * (at.A_hoop * hoop * hoop + at.A_meridian * meridian * meridian);
    const double turn = -slope / bend;
    const double norm = 1.0 / std::sqrt(1.0 + turn * turn);
    const double c = (cos_chi - turn * sin_chi) * norm;
    sin_chi = (sin_chi + turn * cos_chi) * norm;
    cos_chi = c;
    if (std::abs(turn) < 1e-15) {
      return at;
    }
  }
  return at;
}

/// Adds Q and dQ/dδ of a slice with the derivatives of its penetration.
void add_contact(const Axes& axes, const Surface& at, double s, double radius, double sigma,
                 double cos_chi, double sin_chi, double load, double slope, double load_over_x,
                 double x_per_cos, PairPotential& sum) {
  const Turning u = combine(sigma * cos_chi, axes.b1, sigma * sin_chi, axes.b2);
  const Turning w = combine(-sigma * sin_chi, axes.b1, sigma * cos_chi, axes.b2);  // u_χ
  const std::array<V3, 4> X_p{V3{1.0, 0.0, 0.0}, V3{0.0, 0.0, 1.0}, s * axes.a.t + radius * u.t,
                              s * axes.a.f + radius * u.f};
  std::array<double, 4> g{}, hoop{}, meridian{}, chi{};
  const V3 X_chi = radius * w.v;
  const double hoop_chi = dot(at.hoop, X_chi);
  const double meridian_chi = dot(at.meridian, X_chi);
  for (std::size_t i = 0; i < 4; ++i) {
    g[i] = dot(at.n, X_p[i]);
    hoop[i] = dot(at.hoop, X_p[i]);
    meridian[i] = dot(at.meridian, X_p[i]);
    chi[i] = at.A_hoop * hoop[i] * hoop_chi + at.A_meridian * meridian[i] * meridian_chi;
  }
  chi[2] += radius * dot(at.n, w.t);
  chi[3] += radius * dot(at.n, w.f);
  const double bend = -radius * dot(at.n, u.v) + at.A_hoop * hoop_chi * hoop_chi +
                      at.A_meridian * meridian_chi * meridian_chi;
  const double tt = s * dot(at.n, axes.a.tt) + radius * dot(at.n, u.tt);
  const double tf = s * dot(at.n, axes.a.tf) + radius * dot(at.n, u.tf);
  const double ff = s * dot(at.n, axes.a.ff) + radius * dot(at.n, u.ff);
  for (std::size_t i = 0; i < 4; ++i) {
    sum.gradient(static_cast<Eigen::Index>(i)) += load * g[i];
    for (std::size_t j = 0; j <= i; ++j) {
      const double second = at.A_hoop * hoop[i] * hoop[j] +
                            at.A_meridian * meridian[i] * meridian[j] - chi[i] * chi[j] / bend;
      const double entry = slope * g[i] * g[j] + load * second;
      sum.hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) += entry;
      if (i != j) {
        sum.hessian(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) += entry;
      }
    }
  }
  sum.hessian(2, 2) += load * tt;
  sum.hessian(2, 3) += load * tf;
  sum.hessian(3, 2) += load * tf;
  sum.hessian(3, 3) += load * ff;
  if (load_over_x != 0.0) {
    for (Eigen::Index i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        sum.hessian(i, static_cast<Eigen::Index>(j)) +=
            g[static_cast<std::size_t>(i)] * load_over_x * X_p[j].x * x_per_cos;
      }
    }
  }
  sum.total += load;
  sum.stiffness += slope;
}

/// Width on the land and its derivative over the land coordinate.
struct LandWidth {
  double width = 0.0, slope = 0.0;
};
LandWidth land_width(const contact::RaceSurface& race, double x, double width) {
  if (std::isinf(race.land_width)) {
    return {width, 0.0};
  }
  const double above = race.land_offset + 0.5 * race.land_width - x;
  const double below = race.land_offset - 0.5 * race.land_width - x;
  LandWidth out;
  out.width = std::min(0.5 * width, above) - std::max(-0.5 * width, below);
  if (out.width <= 0.0) {
    return {};
  }
  out.slope = (above < 0.5 * width ? -1.0 : 0.0) + (below > -0.5 * width ? 1.0 : 0.0);
  return out;
}

}  // namespace

void add_slices(const SliceSet& set, const Vec4& p, PairPotential& sum,
                std::span<SliceResult> each) {
  const Axes axes = axes_at(p(2), p(3));
  const double sigma = set.race.sigma();
  double cos_chi = 1.0;
  double sin_chi = 0.0;
  for (std::size_t k = 0; k < set.slices.size(); ++k) {
    const auto& slice = set.slices[k];
    const V3 P{p(0) + slice.s * axes.a.v.x, slice.s * axes.a.v.y, p(1) + slice.s * axes.a.v.z};
    V3 X;
    const Surface at = find_deepest(set.race, axes, P, slice.radius, sigma, cos_chi, sin_chi, X);
    if (each.empty() && at.depth <= 0.0) {
      continue;
    }
    const LandWidth land =
        land_width(set.race, (X.x - set.race.mid_x) / set.race.cos_angle, set.width);
    const contact::SliceLoad q = contact::slice_load(set.law, land.width, at.depth);
    if (q.load > 0.0) {
      const double over_x = land.slope != 0.0 ? q.load / land.width * land.slope : 0.0;
      add_contact(axes, at, slice.s, slice.radius, sigma, cos_chi, sin_chi, q.load, q.slope, over_x,
                  1.0 / set.race.cos_angle, sum);
    }
    if (!each.empty()) {
      const double radius = std::sqrt(X.y * X.y + X.z * X.z);
      const double normal_r = (at.n.y * X.y + at.n.z * X.z) / radius;
      each[k] = {at.depth, land.width, q.load, q.slope, -normal_r / radius, at.n.x, at.n.z};
    }
  }
}

void add_slices_linear(const SliceSet& set, const Vec4& p, PairPotential& sum,
                       std::span<SliceResult> each) {
  const double sigma = set.race.sigma();
  for (std::size_t k = 0; k < set.slices.size(); ++k) {
    const auto& slice = set.slices[k];
    const double delta = sigma * (p(1) + slice.s * p(2) - set.race.radius) + slice.radius;
    const LandWidth land = land_width(set.race, slice.s + p(0) - set.race.mid_x, set.width);
    const contact::SliceLoad q = contact::slice_load(set.law, land.width, delta);
    if (q.load > 0.0) {
      const double g = sigma * slice.s;
      sum.gradient(1) += q.load * sigma;
      sum.gradient(2) += q.load * g;
      sum.hessian(1, 1) += q.slope;
      sum.hessian(1, 2) += q.slope * slice.s;
      sum.hessian(2, 1) += q.slope * slice.s;
      sum.hessian(2, 2) += q.slope * slice.s * slice.s;
      if (land.slope != 0.0) {
        const double over_x = q.load / land.width * land.slope;
        sum.hessian(1, 0) += over_x * sigma;
        sum.hessian(2, 0) += over_x * g;
      }
      sum.total += q.load;
      sum.stiffness += q.slope;
    }
    if (!each.empty()) {
      each[k] = {delta, land.width, q.load, q.slope, -sigma / set.race.radius, 0.0, sigma};
    }
  }
}

void add_point(const PointSet& set, const Vec4& p, PairPotential& sum, SliceResult* each) {
  const Axes axes = axes_at(p(2), p(3));
  const double sigma = set.race.sigma();
  double cos_chi = 1.0;
  double sin_chi = 0.0;
  V3 X;
  const auto deepest = [&](const contact::RaceSurface& race, const contact::RollerSlice& slice) {
    const V3 P{p(0) + slice.s * axes.a.v.x, slice.s * axes.a.v.y, p(1) + slice.s * axes.a.v.z};
    cos_chi = 1.0;
    sin_chi = 0.0;
    return find_deepest(race, axes, P, slice.radius, sigma, cos_chi, sin_chi, X);
  };
  contact::RollerSlice slice = set.centre;
  Surface at = deepest(set.race, slice);
  if (at.depth > 0.0 || each != nullptr) {
    const double s = set.centre.s + set.crown_radius * dot(at.n, axes.a.v);
    const double facing = sigma * (cos_chi * dot(at.n, axes.b1.v) + sin_chi * dot(at.n, axes.b2.v));
    if (!(facing > 0.0 && s >= set.ends[0].s && s <= set.ends[1].s)) {
      const double first = deepest(set.groove, set.ends[0]).depth;
      const double second = deepest(set.groove, set.ends[1]).depth;
      slice = set.ends[first > second ? 0 : 1];
      at = deepest(set.groove, slice);
    }
  }
  contact::SliceLoad q;
  if (at.depth > 0.0) {
    const double tangent = set.K * std::sqrt(at.depth);
    q = {tangent * at.depth, 1.5 * tangent};
    add_contact(axes, at, slice.s, slice.radius, sigma, cos_chi, sin_chi, q.load, q.slope, 0.0, 1.0,
                sum);
  }
  if (each != nullptr) {
    *each = {at.depth, 0.0, q.load, q.slope, 0.0, at.n.x, at.n.z};
  }
}

}  // namespace adore::statics
