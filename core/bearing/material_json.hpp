#pragma once

#include <nlohmann/json_fwd.hpp>

namespace adore::bearing {

/// resources/materials.json, parsed once a process: it takes longer than to solve a bearing.
[[nodiscard]] const nlohmann::json& material_json();

}  // namespace adore::bearing
