#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace adore::command_line {

/// Describes an error of the option library: the problem and its remedy. `arguments`: those of the
/// program, in order.
[[nodiscard]] std::string explain(const CLI::App& program, const CLI::ParseError& error,
                                  const std::vector<std::string>& arguments);

}  // namespace adore::command_line
