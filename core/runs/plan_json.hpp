#pragma once

#include "scene/plan.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace adore::runs {

/// The scene plan as JSON: `adore plan --json` and RUN.json.
/// @param stability what was decided on the integrator's steps; empty: nothing
[[nodiscard]] nlohmann::ordered_json plan_json(const scene::ScenePlan& plan,
                                               const std::string& stability);

}  // namespace adore::runs
