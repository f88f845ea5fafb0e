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

/// Parses the command line and runs the callbacks of the given commands; propagates their
/// exceptions.
/// @return exit code if the process is to end: 0 after --help and similar options, 2 after an
/// error, which is printed to stderr with a remedy. No value: continue.
[[nodiscard]] std::optional<int> parse(CLI::App& program, int argc, char** argv);

}  // namespace adore::command_line
