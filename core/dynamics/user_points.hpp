#pragma once

#include "dynamics/race_kernel.hpp"
#include "statics/roller_kernel.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace adore::dynamics {

/// The memory of UserPoints.
class UserScratch {
 public:
  /// @param contacts of the race; points: the most that one contact has
  UserScratch(std::size_t contacts, std::size_t points) {
    constexpr std::size_t kWidest = 8;  // lanes of any vector unit
    const std::size_t stride = (contacts + kWidest - 1) / kWidest * kWidest;
    view_.stride = stride;
    const auto take = [&](double*& to, std::size_t count) {
      to = memory_.emplace_back(count, 0.0).data();
    };
    take(view_.slip, stride * points);
    take(view_.inverse, stride * points);
    take(view_.pressure, stride * points);
    take(view_.kappa, stride * points);
    constexpr std::size_t kKeptOfRow = 4;
    take(view_.row, kKeptOfRow * stride * points);
    for (double*& values : view_.contact) take(values, stride);
    take(view_.kept, stride * kKeptValues + kWidest);
    constexpr std::size_t kAlign = kWidest * sizeof(double);
    const auto beyond = reinterpret_cast<std::uintptr_t>(view_.kept) % kAlign;
    if (beyond != 0) view_.kept += (kAlign - beyond) / sizeof(double);
    rows_.assign(stride, 0);
    view_.rows_of = rows_.data();
  }
  [[nodiscard]] UserPoints* view() noexcept { return &view_; }

 private:
  std::vector<std::vector<double>> memory_;
  std::vector<int> rows_;
  UserPoints view_{};
};

/// The memory of statics::UserLawSlices.
class SliceScratch {
 public:
  /// @param slices the most that one roller has
  SliceScratch(std::size_t rollers, std::size_t slices) {
    constexpr std::size_t kWidest = 8;  // lanes of any vector unit
    const std::size_t all = rollers * ((slices + kWidest - 1) / kWidest * kWidest);
    const auto take = [&](double*& to) { to = memory_.emplace_back(all, 0.0).data(); };
    for (double*& values : view_.contact) take(values);
    for (double*& values : view_.kept) take(values);
    for (double** values : {&view_.slip, &view_.inverse, &view_.kappa}) take(*values);
    vector_counts_.assign(rollers, 0);
    view_.vectors_of = vector_counts_.data();
  }
  [[nodiscard]] const statics::UserLawSlices* view() const noexcept { return &view_; }

 private:
  std::vector<std::vector<double>> memory_;
  std::vector<int> vector_counts_;
  statics::UserLawSlices view_{};
};

}  // namespace adore::dynamics
