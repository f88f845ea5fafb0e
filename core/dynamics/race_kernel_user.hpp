#pragma once

#include "base/simd_math.hpp"
#include "dynamics/race_kernel.hpp"
#include "tribology/laws/user_law.hpp"

#include <cstddef>

/// Laws of the race kernels for a routine of the user: the contacts of a race are gone through
/// once to collect where κ is wanted, and once more with what the routine answered to all of it
/// in one call. Contacts, rows and 1/slip are kept, so that the second pass takes no roots; both
/// take the same points in the same order as a built-in law.
namespace adore::dynamics {
namespace {

inline constexpr std::size_t kKeptOfRow = 4;  ///< ξ, half width, load, height

/// Nothing is loaded, no point is wanted.
inline void mark_open_contacts(UserPoints& points, std::size_t column) {
  points.rows_of[column] = -1;
  for (double* values : points.contact)
    SimdReal(0.0).copy_to(values + column, stdx::element_aligned);
}

class CollectingLaw {
 public:
  static constexpr bool kDependsOnPressure = true;
  CollectingLaw(UserPoints& points, std::size_t column) : to_(points), column_(column) {}
  struct Here {};
  template <class T>
  [[gnu::always_inline]] Here at(const tribology::ContactConditions<T>& c) const {
    const T* values[7] = {&c.load,        &c.peak_pressure, &c.half_major, &c.half_minor,
                          &c.entrainment, &c.curvature,     &c.slip};
    for (int k = 0; k < 7; ++k) values[k]->copy_to(to_.contact[k] + column_, stdx::element_aligned);
    return {};
  }

 private:
  UserPoints& to_;
  std::size_t column_;
};

struct ReplayingLaw {
  static constexpr bool kDependsOnPressure = false;
  struct Here {};
  template <class T>
  [[gnu::always_inline]] Here at(const tribology::ContactConditions<T>&) const {
    return {};
  }
};

/// First pass of one vector, whose first lane is the contact `column`.
template <class S>
[[gnu::always_inline]] inline void collect_points(
    const RaceKernelInput& in, const tribology::EllipseContact<SimdReal, S>& ellipse, bool pressure,
    UserPoints& points, std::size_t column) {
  using T = SimdReal;
  const CollectingLaw law(points, column);
  const tribology::EllipseQuadrature<T, CollectingLaw, S> sum(
      in.nodes, ellipse, law, in.regularization_slip_squared, in.slip_scale);
  const std::size_t stride = points.stride;
  double *slip = points.slip + column, *inverse = points.inverse + column,
         *pressures = points.pressure + column, *row = points.row + column;
  int rows = 0;
  sum.for_each_row([&](const T& xi, const T& chord, const T& half_width, const T& load)
                       __attribute__((always_inline)) {
                         const auto r = sum.row(xi, half_width, load);
                         const T* kept[kKeptOfRow] = {&r.xi, &r.half_width, &r.load, &r.h};
                         for (const T* one : kept) {
                           one->copy_to(row, stdx::element_aligned);
                           row += stride;
                         }
                         for (int j = 0; j < in.nodes.minor; ++j) {
                           const T u_c = sum.transverse_slip(r, j);
                           T over;
                           ScalarMath<T>::sqrt_and_inverse(u_c * u_c + r.fixed, over)
                               .copy_to(slip, stdx::element_aligned);
                           over.copy_to(inverse, stdx::element_aligned);
                           if (pressure)
                             sum.pressure(chord, j).copy_to(pressures, stdx::element_aligned);
                           slip += stride;
                           inverse += stride;
                           pressures += stride;
                         }
                         ++rows;
                       });
  points.rows_of[column] = rows;
}

/// Second pass.
template <class S>
[[gnu::always_inline]] inline tribology::EllipseResultants<SimdReal> replay_points(
    const RaceKernelInput& in, const tribology::EllipseContact<SimdReal, S>& ellipse,
    const UserPoints& points, std::size_t column) {
  using T = SimdReal;
  const ReplayingLaw law;
  tribology::EllipseQuadrature<T, ReplayingLaw, S> sum(
      in.nodes, ellipse, law, in.regularization_slip_squared, in.slip_scale);
  const std::size_t stride = points.stride;
  const double *slip = points.slip + column, *inverse = points.inverse + column,
               *kappa = points.kappa + column, *row = points.row + column;
  const auto next = [stride](const double*& from) {
    const T out(from, stdx::element_aligned);
    from += stride;
    return out;
  };
  for (int i = points.rows_of[column]; i > 0; --i) {
    const T xi = next(row), half_width = next(row), load = next(row), h = next(row);
    const auto r = sum.row(xi, half_width, load, h);
    if (in.nodes.minor == 2) {
      const T s_behind = next(slip), s_ahead = next(slip);
      const T g_behind = ScalarMath<T>::over(next(kappa), s_behind, next(inverse));
      const T g_ahead = ScalarMath<T>::over(next(kappa), s_ahead, next(inverse));
      sum.add_two_point_row(r, {g_ahead + g_behind, g_ahead - g_behind, s_ahead + s_behind});
      continue;
    }
    T g0 = 0.0, g1 = 0.0, g2 = 0.0, speed = 0.0;
    for (int j = 0; j < in.nodes.minor; ++j) {
      const T s = next(slip);
      const T g = ScalarMath<T>::over(next(kappa), s, next(inverse));
      g0 += g * in.nodes.weight_v[j];
      g1 += g * in.nodes.weight_v1[j];
      g2 += g * in.nodes.weight_v2[j];
      speed += s * in.nodes.weight_v[j];
    }
    sum.add_moments(r, g0, g1, g2, speed);
  }
  return sum.sums();
}

/// Asks for what was collected. Contacts of fewer points than others get points without load.
inline void call_user_routine(const tribology::UserTractionLaw& law, UserPoints& points,
                              std::size_t n, int minor) {
  constexpr std::size_t kLanes = SimdReal::size();
  int most = 0;
  for (std::size_t i = 0; i < n; i += kLanes)
    most = points.rows_of[i] > most ? points.rows_of[i] : most;
  if (most == 0) return;
  const int wanted = most * minor;
  const SimdReal slow = 1e-3, none = 0.0;
  for (std::size_t i = 0; i < n; i += kLanes)
    for (int k = (points.rows_of[i] > 0 ? points.rows_of[i] : 0) * minor; k < wanted; ++k) {
      const std::size_t at = static_cast<std::size_t>(k) * points.stride + i;
      slow.copy_to(points.slip + at, stdx::element_aligned);
      none.copy_to(points.pressure + at, stdx::element_aligned);
    }
  law.of->ask(law.of->routine,
              {law.kind, law.race, static_cast<long>(n), wanted, static_cast<long>(points.stride),
               points.slip, law.of->wants_pressure ? points.pressure : nullptr, points.contact[0],
               points.contact[1], points.contact[2], points.contact[3], points.contact[4],
               points.contact[5], points.contact[6], points.kappa});
}

}  // namespace
}  // namespace adore::dynamics
