#pragma once

#include "base/rotation.hpp"
#include "dynamics/state_layout.hpp"

#include <span>

/// Reading and writing slices of the state and of its rates.
namespace adore::dynamics {

[[nodiscard]] inline Vec3 vector_at(const double* y, const Slice& slice) noexcept {
  const double* p = y + slice.first;
  return {p[0], p[1], p[2]};
}
[[nodiscard]] inline Quat quaternion_at(const double* y, const Slice& slice) noexcept {
  const double* p = y + slice.first;
  return {p[0], p[1], p[2], p[3]};
}
template <class Values>
void store_at(double* y, const Slice& slice, const Values& values) noexcept {
  for (int k = 0; k < slice.count; ++k) y[slice.first + k] = values[static_cast<std::size_t>(k)];
}
inline void store_at(double* y, const Slice& slice, const Vec3& v) noexcept {
  for (int k = 0; k < 3; ++k) y[slice.first + k] = v[k];
}
/// Component k of a slice.
[[nodiscard]] inline double& component(std::span<double> y, const Slice& slice, std::size_t k = 0) {
  return y[static_cast<std::size_t>(slice.first) + k];
}

}  // namespace adore::dynamics
