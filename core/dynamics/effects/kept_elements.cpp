#include "dynamics/effects/kept_elements.hpp"

#include <algorithm>

namespace adore::dynamics {

void LastElementStates::keep(const Evaluation& e) noexcept {
  for (std::size_t q = 0; q < kQuantities.size(); ++q)
    std::copy_n(e.elements.*kQuantities[q].view, values_[q].size(), values_[q].begin());
  for (std::size_t j = 0; j < 2; ++j) race_[j] = e.race[j].motion();
}

ElementViews LastElementStates::elements(const Evaluation& e) const noexcept {
  ElementViews out = e.elements;  // sines and cosines of the azimuths are the evaluation's own
  for (std::size_t q = 0; q < kQuantities.size(); ++q) out.*kQuantities[q].view = values_[q].data();
  return out;
}

}  // namespace adore::dynamics
