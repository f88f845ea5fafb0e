#include "dynamics/state_layout.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

namespace adore::dynamics {

Slice StateLayout::add(std::string name, std::string_view unit, int count, double scale) {
  demand(count >= 0, "a group of state variables has a negative size");
  demand(scale > 0.0, "the error scale of a state variable must be positive");
  const Slice slice{size_, count};
  groups_.push_back({std::move(name), std::string(unit), slice});
  scales_.insert(scales_.end(), static_cast<std::size_t>(count), scale);
  size_ += count;
  return slice;
}

void StateLayout::begin_quadratures() {
  demand(controlled_count_ < 0, "quadratures were begun twice");
  controlled_count_ = size_;
}

std::string StateLayout::component_name(int index) const {
  for (const Group& group : groups_) {
    const int k = index - group.slice.first;
    if (k < 0 || k >= group.slice.count) continue;
    if (group.slice.count == 1) return fmt::format("{} [{}]", group.name, group.unit);
    return fmt::format("{}[{}] [{}]", group.name, k + 1, group.unit);
  }
  demand(false, "the index of a state variable is out of range");
  return {};
}

void StateLayout::set_scale(const Slice& slice, double scale) {
  demand(scale > 0.0, "the error scale of a state variable must be positive");
  for (int i = slice.first; i < slice.first + slice.count; ++i)
    scales_.at(static_cast<std::size_t>(i)) = scale;
}

}  // namespace adore::dynamics
