#pragma once

#include "dynamics/effect.hpp"

#include <array>
#include <vector>

namespace adore::dynamics {

/// Places and motion of elements and races of the evaluation made last, for a look
/// (scene/look.hpp): the state that they came from may be gone by then.
class LastElementStates {
 public:
  void size(std::size_t elements) {
    for (auto& values : values_) values.resize(elements);
  }
  void keep(const Evaluation& e) noexcept;
  [[nodiscard]] ElementViews elements(const Evaluation& e) const noexcept;
  [[nodiscard]] const RaceMotion& race(std::size_t j) const noexcept { return race_[j]; }

 private:
  std::array<std::vector<double>, kQuantities.size()> values_;
  std::array<RaceMotion, 2> race_;
};

class StoreElementStates final : public EffectBlock {
 public:
  explicit StoreElementStates(LastElementStates& kept) : kept_(kept) {}
  void apply(Evaluation& e) noexcept override { kept_.keep(e); }
  [[nodiscard]] bool acts_on_elements() const noexcept override { return false; }

 private:
  LastElementStates& kept_;
};

}  // namespace adore::dynamics
