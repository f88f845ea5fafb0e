#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Formulas over channels, value by value (muParser): sqrt(Fy^2 + Fz^2).
namespace adore::signal {

/// Values by name, all of one length.
using NamedSeries = std::map<std::string, std::vector<double>>;

/// Can a formula use this name? A letter, then letters, digits and underscores; no name of
/// muParser.
[[nodiscard]] bool is_formula_name(std::string_view name);

/// Names that a formula uses, in alphabetical order. @throws InputError for an invalid formula
[[nodiscard]] std::vector<std::string> variable_names_in(const std::string& formula);

/// The formula at each value. A missing value (NaN) of a channel that is used gives none, as does a
/// result that is not a number, such as sqrt(-1). Known besides the names: pi.
/// @throws InputError for an invalid formula, unknown names or channels of different lengths
[[nodiscard]] std::vector<double> evaluate(const std::string& formula, const NamedSeries& series);

}  // namespace adore::signal
