#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>

/// How every program of the suite reads its command line.
namespace adore::command_line {

/// The program with --help, --version, --man and --completion.
/// @param help "AdrPlot: plots of result files." name: "adrplot"
[[nodiscard]] std::unique_ptr<CLI::App> make_program(const std::string& help,
                                                     const std::string& name);

/// Reads the command line and runs the callbacks of what was asked for; throws what they throw.
/// @return what the process shall end with, when there is nothing more to do: 0 after --help and
/// its like, 2 after a mistake, which is said on stderr with a remedy. Nothing: go on.
[[nodiscard]] std::optional<int> parse(CLI::App& program, int argc, char** argv);

}  // namespace adore::command_line
