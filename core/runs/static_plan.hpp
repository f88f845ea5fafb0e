#pragma once

#include "runs/prepare.hpp"

/// Parts of the solution of a quasi-static deck (mode below 0), each with the switch that selects
/// it.
namespace adore::runs {

/// Bodies with the unknowns that the constraints leave them, and every part of the model with the
/// deck variable or run option that turns it on or off. `prepared` needs its deck, bearing, control
/// and options; nothing has been solved yet.
[[nodiscard]] scene::ScenePlan static_plan(const Prepared& prepared);

/// Size of the problem and what its solution took just now.
[[nodiscard]] std::string static_cost_text(const Prepared& prepared);

}  // namespace adore::runs
