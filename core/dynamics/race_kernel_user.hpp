#pragma once

#include "base/simd_math.hpp"
#include "dynamics/race_kernel.hpp"
#include "tribology/laws/user_law.hpp"

#include <cstddef>

/// Laws of the race kernels for a routine of the user: the contacts of a race are gone through
/// twice, once to collect where κ is wanted, and once with what the routine answered to all of it
/// in one call. Both passes take the same points in the same order.
namespace adore::dynamics {
namespace {

class CollectPoints {
 public:
  static constexpr bool kOfPressure = true;
  CollectPoints(UserPoints& points, bool pressure) : to_(points), pressure_(pressure) {}
  /// The vector whose first lane is this contact comes next.
  void begin(std::size_t contact) const { column_ = contact; }

  template <class T>
  struct Here {
    double *slip, *pressure;
    std::size_t stride;
    int* rows;
    [[gnu::always_inline]] T operator()(const T& s, const T& p) const {
      const std::size_t at = static_cast<std::size_t>((*rows)++) * stride;
      s.copy_to(slip + at, stdx::element_aligned);
      if (pressure != nullptr) p.copy_to(pressure + at, stdx::element_aligned);
      return 0.0;
    }
  };
  template <class T>
  [[gnu::always_inline]] Here<T> at(const tribology::ContactPoint<T>& c) const {
    const T* values[7] = {&c.load,        &c.peak_pressure, &c.half_major, &c.half_minor,
                          &c.entrainment, &c.curvature,     &c.slip};
    for (int k = 0; k < 7; ++k) values[k]->copy_to(to_.contact[k] + column_, stdx::element_aligned);
    return {to_.slip + column_, pressure_ ? to_.pressure + column_ : nullptr, to_.stride,
            to_.rows_of + column_};
  }

 private:
  UserPoints& to_;
  bool pressure_;
  mutable std::size_t column_ = 0;
};

class ReplayPoints {
 public:
  static constexpr bool kOfPressure = false;
  explicit ReplayPoints(const UserPoints& points) : from_(points) {}
  void begin(std::size_t contact) const { column_ = contact; }

  template <class T>
  struct Here {
    mutable const double* kappa;
    std::size_t stride;
    [[gnu::always_inline]] T operator()(const T&, const T&) const {
      const T out(kappa, stdx::element_aligned);
      kappa += stride;
      return out;
    }
  };
  template <class T>
  [[gnu::always_inline]] Here<T> at(const tribology::ContactPoint<T>&) const {
    return {from_.kappa + column_, from_.stride};
  }

 private:
  const UserPoints& from_;
  mutable std::size_t column_ = 0;
};

/// Nothing is loaded, no point is wanted.
inline void clear_points(UserPoints& points, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    points.rows_of[i] = 0;
    for (double* values : points.contact) values[i] = 0.0;
  }
}

/// Asks for what was collected. Contacts of fewer points than others get points without load.
inline void ask_user(const tribology::UserLaw& law, UserPoints& points, std::size_t n) {
  constexpr std::size_t kLanes = SimdReal::size();
  int rows = 0;
  for (std::size_t i = 0; i < n; i += kLanes)
    rows = points.rows_of[i] > rows ? points.rows_of[i] : rows;
  if (rows == 0) return;
  const SimdReal slow = 1e-3, none = 0.0;
  for (std::size_t i = 0; i < n; i += kLanes)
    for (int row = points.rows_of[i]; row < rows; ++row) {
      const std::size_t at = static_cast<std::size_t>(row) * points.stride + i;
      slow.copy_to(points.slip + at, stdx::element_aligned);
      none.copy_to(points.pressure + at, stdx::element_aligned);
    }
  law.of->ask(law.of->routine,
              {law.kind, law.race, static_cast<long>(n), rows, static_cast<long>(points.stride),
               points.slip, law.of->wants_pressure ? points.pressure : nullptr, points.contact[0],
               points.contact[1], points.contact[2], points.contact[3], points.contact[4],
               points.contact[5], points.contact[6], points.kappa});
}

}  // namespace
}  // namespace adore::dynamics
