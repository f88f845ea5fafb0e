#pragma once

#include "base/find_report.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string_view>

/// Inverse calculation on a component calculator: values of one input at which one of its results
/// meets a target (base/find_values.hpp).
namespace adore::calculators {

/// @param input of the calculator; the value of the unknown in it is replaced, and may be missing
/// @param unknown name is a path: "load", "body1.Rx", "applied_load.Fx"
/// @param target name is a path of the results: "delta", "displacement.ux"; "table[2]" counts from
/// 1, "least(Qi)" and "largest(Qi)" take an item of a list of numbers
/// @throws InputError naming the results of the calculator; SolverError
[[nodiscard]] FindReport find_in_calculator(std::string_view calculator,
                                            const nlohmann::json& input, FindUnknown unknown,
                                            FindTarget target, int points = 41);

}  // namespace adore::calculators
