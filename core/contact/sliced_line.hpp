#pragma once

#include "contact/line_contact.hpp"
#include "contact/roller_profile.hpp"

#include <cmath>
#include <limits>
#include <vector>

/// A sliced roller against a straight race in the plane of its axis: δ_k = δ0 + slope x_k - drop_k,
/// power law. SI. The small-angle form of slice_contact.hpp for cylinders; what simple quasi-static
/// models use. Accuracy of the midpoint rule: load 0.1 % with 20 slices straight, 43 fully crowned
/// (R_c 1.8 m, L 12 mm); the moment of a pure small tilt is low by 1/n² [derived].
namespace adore::contact {

struct SlicedLine {
  std::vector<double> x, width, drop;  ///< of each slice [m]
  PowerLaw law;
};

/// Slices of a profile with widths cut to a land of width B about o (B infinite: no limit); drops
/// from the straight side.
[[nodiscard]] SlicedLine sliced_line(const RollerProfile& profile, int count, double line_constant,
                                     double land_width = std::numeric_limits<double>::infinity(),
                                     double land_offset = 0.0);

/// Sums of slices, and of all that gives loads by x.
struct LineResultant {
  double load = 0.0;    ///< Q = Σ Q_k [N]
  double moment = 0.0;  ///< M = Σ Q_k x_k [N m]
  double load_by_approach = 0.0, load_by_slope = 0.0,
         moment_by_slope = 0.0;  ///< ∂Q/∂δ0, ∂Q/∂slope = ∂M/∂δ0, ∂M/∂slope
  int loaded = 0;                ///< slices that carry load
  double largest_load = 0.0;     ///< of a slice [N]
  double largest_delta = 0.0;    ///< [m]

  void add(double x, double delta, const SliceLoad& q) noexcept {
    if (q.load <= 0.0) return;
    ++loaded;
    load += q.load;
    moment += q.load * x;
    load_by_approach += q.slope;
    load_by_slope += q.slope * x;
    moment_by_slope += q.slope * x * x;
    largest_load = std::max(largest_load, q.load);
    largest_delta = std::max(largest_delta, delta);
  }
};
/// Hot path: no allocation.
[[nodiscard]] LineResultant line_resultant(const SlicedLine& line, double delta0,
                                           double slope) noexcept;

/// δ0 that gives the load Q at this slope. Q(δ0) is convex, so Newton from above falls to the root
/// without overshooting.
/// @throws InputError when Q is not positive or no slice has width; SolverError when it does not
/// converge.
[[nodiscard]] double approach_for_load(const SlicedLine& line, double slope, double load);

/// The limit of infinitely many slices: Q = K_l L_e^(-1/9) ∫ δ^(10/9) dx, M the same with x, over
/// the part of [from, to] where δ > 0. Double-exponential rule between the edges of contact, which
/// takes the root-like ends; about 1e-12.
/// @param delta callable x -> δ, concave (one stretch of contact); @param breaks places inside
/// where its slope or curvature jumps, ascending (ends of the land)
struct ContinuumResultant {
  double load = 0.0, moment = 0.0;  ///< [N, N m]
};
template <class Delta>
[[nodiscard]] ContinuumResultant continuum_resultant(const PowerLaw& law, double from, double to,
                                                     const Delta& delta,
                                                     const std::vector<double>& breaks = {}) {
  double low = from, high = to;  // golden section for the deepest place
  constexpr double kGolden = 0.61803398874989484820;
  for (int n = 0; n < 80; ++n) {
    const double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    (delta(left) < delta(right) ? low : high) = delta(left) < delta(right) ? left : right;
  }
  const double deepest = 0.5 * (low + high);
  if (!(delta(deepest) > 0.0)) return {};
  const auto edge = [&](double outside, double inside) {
    if (delta(outside) > 0.0) return outside;
    for (int n = 0; n < 80; ++n) {
      const double middle = 0.5 * (outside + inside);
      (delta(middle) > 0.0 ? inside : outside) = middle;
    }
    return inside;
  };
  std::vector<double> ends = {edge(from, deepest)};
  const double last = edge(to, deepest);
  for (const double b : breaks)
    if (b > ends.front() && b < last) ends.push_back(b);
  ends.push_back(last);
  ContinuumResultant sum;
  constexpr double kStep = 1.0 / 32.0, kHalfPi = 1.57079632679489661923;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double half = 0.5 * (ends[k + 1] - ends[k]), middle = 0.5 * (ends[k + 1] + ends[k]);
    for (int n = -110; n <= 110; ++n) {
      const double t = n * kStep, inner = kHalfPi * std::sinh(t), cosine = std::cosh(inner);
      const double x = middle + half * std::tanh(inner);
      const double weight = half * kStep * kHalfPi * std::cosh(t) / (cosine * cosine);
      const double q = slice_load(law, weight, delta(x)).load;
      sum.load += q;
      sum.moment += q * x;
    }
  }
  return sum;
}

}  // namespace adore::contact
