#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace adore::command_line {

/// What is wrong with a command line and what would be right: the option library's error in our
/// words. `arguments` are those of the program, in order.
[[nodiscard]] std::string explain(const CLI::App& program, const CLI::ParseError& error,
                                  const std::vector<std::string>& arguments);

}  // namespace adore::command_line
