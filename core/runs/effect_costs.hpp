#pragma once

#include "runs/prepare.hpp"

#include <string>
#include <vector>

/// Cost of the effects of a motion, measured before the run.
namespace adore::runs {

struct EffectCost {
  std::string name;
  double share = 0.0;  ///< of the right-hand side's time, 0..1
};

/// Evaluates the right-hand side at the start state for about a tenth of a second and records the
/// time of each block, the slowest first. Empty for a quasi-static deck. Measured: repeated calls
/// differ slightly.
[[nodiscard]] std::vector<EffectCost> effect_costs(const Prepared& prepared);

/// The same as lines for a person, with the time of one evaluation; empty for a quasi-static deck.
[[nodiscard]] std::string effect_costs_text(const Prepared& prepared);

}  // namespace adore::runs
