#pragma once

#include "dynamics/effect.hpp"
#include "dynamics/effects/contact_damping.hpp"

/// Elements that touch the ones before and after them in a bearing without cage.
namespace adore::dynamics {

/// In the contacts of balls or rollers.
inline constexpr LedgerTerm kElementHeat{LedgerKind::Heat,
                                         "element_heat",
                                         "heat between elements",
                                         {"contacts between elements"},
                                         "dissipated since the start"};

/// Element i touches `other`.
struct NeighbourPair {
  std::size_t i = 0, other = 0;
};
/// Each with the next one; two elements meet once.
[[nodiscard]] inline std::vector<NeighbourPair> neighbour_pairs(std::size_t elements) {
  std::vector<NeighbourPair> out;
  for (std::size_t i = 0; i + 1 < elements; ++i) out.push_back({i, i + 1});
  if (elements > 2) out.push_back({elements - 1, 0});
  return out;
}

/// visit(pair) of the two (at most) that element i is in; `pairs` as above.
template <class Pair, class Visit>
void for_pairs_of(std::size_t i, std::size_t elements, const std::vector<Pair>& pairs,
                  const Visit& visit) {
  if (i < pairs.size()) visit(pairs[i]);
  const std::size_t before = (i + elements - 1) % elements;
  if (before < pairs.size() && before != i) visit(pairs[before]);
}

}  // namespace adore::dynamics
