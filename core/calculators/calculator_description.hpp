#pragma once

#include "calculators/calculators.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

/// The schema of the calculators as text, as data and as a page of the documentation.
namespace adore::calculators {

/// {"a": "m", "table[].Q": "N"} for the values in `results` that have a unit.
[[nodiscard]] nlohmann::json result_units(std::string_view family, const nlohmann::json& results);

/// {"name", "help", "calculations": [{"kind", "aliases", "inputs", "results", "example"}]}. An
/// input has name, type, unit, required, and where they apply range, values, codes, default, null,
/// length, needs, if, one_of and meaning.
[[nodiscard]] nlohmann::ordered_json describe_calculator(const CalculatorInfo& info);

/// The same as text for a terminal.
[[nodiscard]] std::string describe_calculator_text(const CalculatorInfo& info);

/// All calculators as a page in Markdown.
[[nodiscard]] std::string calculators_markdown();

}  // namespace adore::calculators
