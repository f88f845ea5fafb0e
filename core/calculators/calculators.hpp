#pragma once

#include "calculators/adapter.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Component calculators: JSON in, JSON out (`adore calc`). The names of the reference families
/// work too, so that any case of tests/reference can be fed to its calculator.
namespace adore::calculators {

struct CalculatorInfo {
  std::string name;    ///< "hertz"
  std::string family;  ///< reference family whose README explains inputs and results
  std::string kind;    ///< kind given to the family's calculator; may be empty
  std::string help;
};

[[nodiscard]] const std::vector<CalculatorInfo>& calculator_list();

/// @param input the object of inputs, or a whole reference case with "inputs" (and "kind").
/// @param more additional families that a name may mean
/// @return the results, and under "units" the unit of each.
/// @throws InputError with the calculators, the missing inputs, or the unknown
/// keys.
[[nodiscard]] nlohmann::json calculate(std::string_view name, const nlohmann::json& input,
                                       std::span<const Adapter> more = {});

}  // namespace adore::calculators
