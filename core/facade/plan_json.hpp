#pragma once

#include "dynamics/scene_plan.hpp"

#include <nlohmann/json.hpp>

namespace adore::facade {

/// The scene plan as JSON: `adore plan --json` and RUN.json.
[[nodiscard]] nlohmann::ordered_json plan_json(const dynamics::ScenePlan& plan);

}  // namespace adore::facade
