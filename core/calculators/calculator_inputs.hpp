#pragma once

#include "calculators/calculators.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

/// What calculators take and give, in words: resources/calculators.json. By family: inputs and
/// results with units, and per kind of calculation the inputs it takes and an example.
namespace adore::calculators {

/// One value of a calculator. Paths: "body1.E", "lands[].race".
struct CalculatorField {
  std::string path;
  std::string type;  ///< "positive number|text"; empty for a result
  std::string unit;  ///< "1" for a pure number, "" where there is none
  std::string meaning;
};

/// Are these inputs of the family, each of its type? Values that a calculation needs but that are
/// not there are its own to miss. A family that is not described passes.
/// @throws InputError naming every key that is unknown, with the nearest known ones, or of the
/// wrong type.
void check_calculator_inputs(std::string_view family, const nlohmann::json& inputs);

/// Where the family has a key: "body1.E"; the key itself when it has none.
[[nodiscard]] std::string paths_of_key(std::string_view family, std::string_view key);

/// {"a": "m", "table[].Q": "N"} for the values in `results` that have a unit.
[[nodiscard]] nlohmann::json result_units(std::string_view family, const nlohmann::json& results);

/// {"name", "help", "calculations": [{"kind", "inputs", "results", "example"}]}; one calculation
/// where the calculator fixes the kind.
[[nodiscard]] nlohmann::ordered_json describe_calculator(const CalculatorInfo& info);

/// The same for people.
[[nodiscard]] std::string describe_calculator_text(const CalculatorInfo& info);

}  // namespace adore::calculators
