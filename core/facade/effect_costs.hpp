#pragma once

#include "facade/prepare.hpp"

#include <string>
#include <vector>

/// What the effects of a motion cost, measured before it is run.
namespace adore::facade {

struct EffectCost {
  std::string name;
  double share = 0.0;  ///< of the right-hand side's time, 0..1
};

/// Evaluates the right-hand side at the start state for about a tenth of a second and books the
/// time of each block, the dearest first. Empty for a quasi-static deck. Measured: no two calls
/// agree to the last digit.
[[nodiscard]] std::vector<EffectCost> effect_costs(const Prepared& prepared);

/// The same as lines for a person, with the time of one evaluation; empty for a quasi-static deck.
[[nodiscard]] std::string effect_costs_text(const Prepared& prepared);

}  // namespace adore::facade
