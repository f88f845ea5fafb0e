#pragma once

#include "dynamics/effect.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace adore::dynamics {

/// Present heat of one kind of contacts: of all, an item of the ledger, and of each pocket or land.
struct HeatByPart {
  double sum = 0.0;          ///< [W]
  std::vector<double> part;  ///< [W]; sized before the first evaluation
  double damping = 0.0;      ///< heat of contact damping, a separate ledger item [W]

  void none() noexcept {
    sum = damping = 0.0;
    std::fill(part.begin(), part.end(), 0.0);
  }
  void add(std::size_t i, double watts) noexcept {
    sum += watts;
    part[i] += watts;
  }
};

/// Sets such heat to zero before the blocks that add to it.
class ResetHeatByPart final : public EffectBlock {
 public:
  explicit ResetHeatByPart(HeatByPart& heat) : heat_(heat) {}
  [[nodiscard]] bool acts_on_elements() const noexcept override { return false; }
  void apply(Evaluation&) noexcept override { heat_.none(); }

 private:
  HeatByPart& heat_;
};

}  // namespace adore::dynamics
