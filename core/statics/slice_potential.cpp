#include "statics/slice_potential.hpp"

#include "base/simd_math.hpp"
#include "contact/hertz.hpp"
#include "contact/land_edge.hpp"
#include "contact/slice_circle.hpp"
#include "contact/sliced_line.hpp"
#include "statics/slice_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::statics {
namespace {

using contact::DeepestSlicePoint;
/// One slice per lane.
using Lanes = SimdReal;

double total(double x) { return x; }
double total(const Lanes& x) { return stdx::reduce(x); }

template <class Sums>
void add_matrices(PairPotential& sum, const Sums& of) {
  for (int i = 0; i < 4; ++i) {
    sum.gradient(i) += total(of.gradient[static_cast<std::size_t>(i)]);
    for (int j = 0; j <= i; ++j) {
      const double value = total(of.hessian[static_cast<std::size_t>(lower_triangle_index(i, j))]);
      sum.hessian(i, j) += value;
      if (i != j) {
        sum.hessian(j, i) += value;
      }
    }
  }
}

template <class T>
void add_to(PairPotential& sum, const SliceSums<T>& of) {
  add_matrices(sum, of);
  sum.total += total(of.load);
  sum.stiffness += total(of.slope);
}

}  // namespace

void add_slices(const SliceSet& set, const Vec4& p, PairPotential& sum,
                std::span<SliceResult> each) {
  constexpr std::size_t kLanes = Lanes::size();
  const SliceRotations axes = slice_rotations(p(2), p(3));
  SliceSums<Lanes> sums;
  EdgeSums<double> edges;
  Lanes tan_chi = 0.0;
  Lanes last = 0.0;
  for (std::size_t first = 0; first < set.slices.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, set.slices.size() - first);
    const auto slice = [&](std::size_t lane) -> const contact::RollerSlice& {
      return set.slices[first + std::min(lane, count - 1)];
    };
    const Lanes s([&](auto lane) { return slice(lane).s; });
    const Lanes radius([&](auto lane) { return slice(lane).radius; });
    const DeepestSlicePoint<Lanes> d =
        contact::deepest_slice_point(set.race, axes, p(0), p(1), s, radius, tan_chi);
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
        const double x =
            contact::slice_axial_position(set.race, axes, p(0), slice(lane).s, slice(lane).radius);
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
          edges.add(
              land_position_derivatives(axes, set.race.sigma(), slice(lane).s, slice(lane).radius),
              {sums.over[0][lane], sums.over[1][lane], sums.over[2][lane], sums.over[3][lane]},
              q[lane].load, d.at.depth[lane], land[lane].width, land[lane].slope,
              set.race.cos_angle);
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
  add_to(sum, sums);
  if (edges.reached) {
    add_matrices(sum, edges);
  }
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

void add_point_contact(const PointContactSet& set, const Vec4& p, PairPotential& sum,
                       SliceResult* each) {
  const SliceRotations axes = slice_rotations(p(2), p(3));
  const auto deepest = [&](const contact::RaceSurface& race, const contact::RollerSlice& slice) {
    double tan_chi = 0.0;
    return contact::deepest_slice_point(race, axes, p(0), p(1), slice.s, slice.radius, tan_chi);
  };
  DeepestSlicePoint<double> d = deepest(set.race, set.centre);
  if (d.at.depth > 0.0 || each != nullptr) {
    const double s = set.centre.s + set.crown_radius * dot(d.at.n, axes.a);
    const bool facing = dot(d.at.n, d.u) > 0.0;
    if (!(facing && s >= set.ends[0].s && s <= set.ends[1].s)) {
      const DeepestSlicePoint<double> first = deepest(set.groove, set.ends[0]);
      const DeepestSlicePoint<double> second = deepest(set.groove, set.ends[1]);
      d = first.at.depth > second.at.depth ? first : second;
    }
  }
  contact::SliceLoad q;
  if (d.at.depth > 0.0) {
    const double root = std::sqrt(d.at.depth);
    q = {contact::point_contact_load(set.K, d.at.depth, root), 1.5 * set.K * root};
    SliceSums<double> sums;
    sums.add(axes, d, q.load, q.slope);
    add_to(sum, sums);
  }
  if (each != nullptr) {
    *each = {d.at.depth, 0.0, q.load, q.slope, 0.0, d.at.n.x, d.at.n.z};
  }
}

}  // namespace adore::statics
