#include "statics/slice_potential.hpp"

#include "base/simd_math.hpp"
#include "contact/hertz.hpp"
#include "contact/slice_circle.hpp"
#include "contact/sliced_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::statics {
namespace {

using contact::SliceDeepest;
using contact::Triple;
/// One slice per lane.
using Lanes = SimdReal;

double total(double x) { return x; }
double total(const Lanes& x) { return stdx::reduce(x); }

/// How t and f turn the roller axis a = (c, f, t): a changes by θ × a, θ = θ_t dt + θ_f df + ½ (0,
/// t, -f) (k_tt dt² + 2 k_tf dt df + k_ff df²), θ_t = a × a_t and so on. A turn about a itself
/// moves no slice circle, so that θ is free of it.
struct Axes : contact::SliceAxes {
  Triple<double> turn_t, turn_f;
  double k_tt = 0.0, k_tf = 0.0, k_ff = 0.0;  ///< x of a_tt, a_tf, a_ff, which have no y and z
  double tt = 0.0, tf = 0.0, ff = 0.0;        ///< θ_t·θ_t and so on
};

Axes axes_at(double t, double f) {
  Axes out{contact::slice_axes(t, f), {}, {}};
  const double c = out.a.x;
  const double c3 = c * c * c;
  out.turn_t = cross(out.a, Triple<double>{-t / c, 0.0, 1.0});
  out.turn_f = cross(out.a, Triple<double>{-f / c, 1.0, 0.0});
  out.k_tt = -(1.0 - f * f) / c3;
  out.k_tf = -t * f / c3;
  out.k_ff = -(c * c + f * f) / c3;
  out.tt = dot(out.turn_t, out.turn_t);
  out.tf = dot(out.turn_t, out.turn_f);
  out.ff = dot(out.turn_f, out.turn_f);
  return out;
}

/// Lower triangle of a symmetric matrix of 4, row by row.
constexpr int entry(int i, int j) { return i * (i + 1) / 2 + j; }

/// What slices add to the potential, but for the edges of lands.
template <class T>
struct Sums {
  std::array<T, 4> gradient;
  std::array<T, 10> hessian;
  T load = 0.0, slope = 0.0;
  Triple<T> X_t, X_f;     ///< of the last: how t and f move the point
  std::array<T, 4> over;  ///< of the last: ∂δ/∂p

  Sums() {
    gradient.fill(T(0.0));
    hessian.fill(T(0.0));
  }

  /// Load and stiffness of slices with the derivatives of their penetration.
  void add(const Axes& axes, const SliceDeepest<T>& d, const T& q, const T& q_slope) {
    const Triple<T>& n = d.at.n;
    const Triple<T> arm = d.s * axes.a + d.radius * d.u;
    X_t = cross(axes.turn_t, arm);
    X_f = cross(axes.turn_f, arm);
    over = {n.x, n.z, dot(n, X_t), dot(n, X_f)};
    // Motion of the point in the principal directions, and δ_χp.
    const T hoop = d.radius * d.hoop;
    const T meridian = d.radius * d.meridian;
    const std::array<T, 4> h{T(0.0), d.at.hoop.z, dot(d.at.hoop, X_t), dot(d.at.hoop, X_f)};
    const std::array<T, 4> m{d.at.meridian.x, d.at.meridian.z, dot(d.at.meridian, X_t),
                             dot(d.at.meridian, X_f)};
    const T A_h = d.at.A_hoop * hoop;
    const T A_m = d.at.A_meridian * meridian;
    const Triple<T> across = cross(d.radius * d.w, n);
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
    hessian[entry(2, 2)] += q * (axes.k_tt * bow + n_t * arm_t - axes.tt * n_arm);
    hessian[entry(3, 2)] +=
        q * (axes.k_tf * bow + 0.5 * (n_t * arm_f + n_f * arm_t) - axes.tf * n_arm);
    hessian[entry(3, 3)] += q * (axes.k_ff * bow + n_f * arm_f - axes.ff * n_arm);
    load += q;
    slope += q_slope;
  }

  void add_to(PairPotential& sum) const {
    for (int i = 0; i < 4; ++i) {
      sum.gradient(i) += total(gradient[static_cast<std::size_t>(i)]);
      for (int j = 0; j <= i; ++j) {
        const double value = total(hessian[static_cast<std::size_t>(entry(i, j))]);
        sum.hessian(i, j) += value;
        if (i != j) {
          sum.hessian(j, i) += value;
        }
      }
    }
    sum.total += total(load);
    sum.stiffness += total(slope);
  }
};

/// What depends on the place of a contact at the edge of the land, through its width.
void add_edge(const contact::RaceSurface& race, const Sums<Lanes>& slices, std::size_t lane,
              double load_slope, PairPotential& sum) {
  const double over_x = load_slope / race.cos_angle;
  const Vec4 along(1.0, 0.0, slices.X_t.x[lane], slices.X_f.x[lane]);
  const Vec4 over(slices.over[0][lane], slices.over[1][lane], slices.over[2][lane],
                  slices.over[3][lane]);
  sum.hessian += (over_x * over) * along.transpose();
}

}  // namespace

void add_slices(const SliceSet& set, const Vec4& p, PairPotential& sum,
                std::span<SliceResult> each) {
  constexpr std::size_t kLanes = Lanes::size();
  const Axes axes = axes_at(p(2), p(3));
  Sums<Lanes> sums;
  Lanes tan_chi = 0.0;
  Lanes last = 0.0;
  for (std::size_t first = 0; first < set.slices.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, set.slices.size() - first);
    const auto slice = [&](std::size_t lane) -> const contact::RollerSlice& {
      return set.slices[first + std::min(lane, count - 1)];
    };
    const Lanes s([&](auto lane) { return slice(lane).s; });
    const Lanes radius([&](auto lane) { return slice(lane).radius; });
    const SliceDeepest<Lanes> d =
        contact::deepest_on_slice(set.race, axes, p(0), p(1), s, radius, tan_chi);
    // χ changes evenly along the roller: the next slices start from its extrapolation.
    const Lanes found = tan_chi;
    tan_chi = first == 0 ? found : 2.0 * found - last;
    last = found;
    std::array<contact::LandWidth, kLanes> land;
    std::array<contact::SliceLoad, kLanes> q;
    bool loaded = false;
    for (std::size_t lane = 0; lane < count; ++lane) {
      const double depth = d.at.depth[lane];
      if (depth > 0.0 || !each.empty()) {
        const double x = d.X.x[lane];
        land[lane] =
            contact::land_width(set.race, contact::land_coordinate(set.race, x), set.width);
        q[lane] = contact::slice_load(set.law, land[lane].width, depth);
        loaded = loaded || q[lane].load > 0.0;
      }
    }
    if (loaded) {
      sums.add(axes, d, Lanes([&](auto lane) { return q[lane].load; }),
               Lanes([&](auto lane) { return q[lane].slope; }));
      for (std::size_t lane = 0; lane < count; ++lane) {
        if (q[lane].load > 0.0 && land[lane].slope != 0.0) {
          add_edge(set.race, sums, lane, q[lane].load / land[lane].width * land[lane].slope, sum);
        }
      }
    }
    for (std::size_t lane = 0; lane < count && !each.empty(); ++lane) {
      const double y = d.X.y[lane];
      const double z = d.X.z[lane];
      const double r = std::sqrt(y * y + z * z);
      const double normal_r = (d.at.n.y[lane] * y + d.at.n.z[lane] * z) / r;
      each[first + lane] = {d.at.depth[lane], land[lane].width, q[lane].load,  q[lane].slope,
                            -normal_r / r,    d.at.n.x[lane],   d.at.n.z[lane]};
    }
  }
  sums.add_to(sum);
}

void add_slices_linear(const SliceSet& set, const Vec4& p, PairPotential& sum,
                       std::span<SliceResult> each) {
  const double sigma = set.race.sigma();
  contact::LineResultant line;
  for (std::size_t k = 0; k < set.slices.size(); ++k) {
    const auto& slice = set.slices[k];
    const double delta = sigma * (p(1) + slice.s * p(2) - set.race.radius) + slice.radius;
    const contact::LandWidth land = contact::land_width(
        set.race, contact::land_coordinate(set.race, slice.s + p(0)), set.width);
    const contact::SliceLoad q = contact::slice_load(set.law, land.width, delta);
    line.add(slice.s, delta, q);
    if (q.load > 0.0 && land.slope != 0.0) {
      const double over_x = q.load / land.width * land.slope;
      sum.hessian(1, 0) += over_x * sigma;
      sum.hessian(2, 0) += over_x * (sigma * slice.s);
    }
    if (!each.empty()) {
      each[k] = {delta, land.width, q.load, q.slope, -sigma / set.race.radius, 0.0, sigma};
    }
  }
  sum.gradient(1) += sigma * line.load;
  sum.gradient(2) += sigma * line.moment;
  sum.hessian(1, 1) += line.load_by_approach;
  sum.hessian(1, 2) += line.load_by_slope;
  sum.hessian(2, 1) += line.load_by_slope;
  sum.hessian(2, 2) += line.moment_by_slope;
  sum.total += line.load;
  sum.stiffness += line.load_by_approach;
}

void add_point(const PointSet& set, const Vec4& p, PairPotential& sum, SliceResult* each) {
  const Axes axes = axes_at(p(2), p(3));
  const auto deepest = [&](const contact::RaceSurface& race, const contact::RollerSlice& slice) {
    double tan_chi = 0.0;
    return contact::deepest_on_slice(race, axes, p(0), p(1), slice.s, slice.radius, tan_chi);
  };
  SliceDeepest<double> d = deepest(set.race, set.centre);
  if (d.at.depth > 0.0 || each != nullptr) {
    const double s = set.centre.s + set.crown_radius * dot(d.at.n, axes.a);
    const bool facing = dot(d.at.n, d.u) > 0.0;
    if (!(facing && s >= set.ends[0].s && s <= set.ends[1].s)) {
      const SliceDeepest<double> first = deepest(set.groove, set.ends[0]);
      const SliceDeepest<double> second = deepest(set.groove, set.ends[1]);
      d = first.at.depth > second.at.depth ? first : second;
    }
  }
  contact::SliceLoad q;
  if (d.at.depth > 0.0) {
    const double root = std::sqrt(d.at.depth);
    q = {contact::point_load(set.K, d.at.depth, root), 1.5 * set.K * root};
    Sums<double> sums;
    sums.add(axes, d, q.load, q.slope);
    sums.add_to(sum);
  }
  if (each != nullptr) {
    *each = {d.at.depth, 0.0, q.load, q.slope, 0.0, d.at.n.x, d.at.n.z};
  }
}

}  // namespace adore::statics
