#pragma once

#include "scene/look.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace adore::dynamics {

/// Normal forces or slips of one kind of contacts from the last evaluation, for a sample
/// (scene/look.hpp): the state that they came from may have changed since.
struct LastContactValues {
  std::vector<double> at;  ///< by place [N or m/s]; sized before the first evaluation
  std::size_t row = 1;     ///< places of one pocket or element

  void size(std::size_t rows, std::size_t of_each) {
    row = of_each;
    at.assign(rows * of_each, 0.0);
  }
  void none() noexcept { std::fill(at.begin(), at.end(), 0.0); }
  void add(std::size_t i, std::size_t k, double value) noexcept { at[i * row + k] += value; }
  /// Forces of one pocket or element to its contacts in a snapshot.
  template <class Contacts>
  void give(std::size_t i, Contacts& contacts) const {
    for (std::size_t k = 0; k < contacts.size(); ++k) contacts[k].force = at[i * row + k];
  }
};

/// Pockets of all elements, and the last halves of segments in the order of the segments.
template <class Set>
void sample_pocket_forces(const LastContactValues& pockets, const std::optional<Set>& last_halves,
                          const LastContactValues& of_halves, scene::Look& out) {
  std::vector<double>& all = out[scene::ExtremeQuantity::PocketForce];
  const std::size_t row = pockets.row;
  all.resize(pockets.at.size() + of_halves.at.size());
  std::copy(pockets.at.begin(), pockets.at.end(), all.begin());
  if (!last_halves) return;
  for (std::size_t i = 0; i < last_halves->size(); ++i) {
    const auto from = of_halves.at.begin() + static_cast<std::ptrdiff_t>(i * row);
    std::copy_n(from, row,
                all.begin() + static_cast<std::ptrdiff_t>(
                                  pockets.at.size() +
                                  static_cast<std::size_t>(last_halves->segment(i)) * row));
  }
}

}  // namespace adore::dynamics
