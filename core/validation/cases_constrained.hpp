#pragma once

#include "validation/adapter.hpp"

namespace adore::validation {

/// One case of the family motion_constraints: a ball, a roller or a ball bearing with eliminated
/// inertia.
[[nodiscard]] std::optional<Json> evaluate_constraint_case(const Json& the_case);

}  // namespace adore::validation
