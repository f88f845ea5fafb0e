#pragma once

#include <CLI/CLI.hpp>

/// Each adds one subcommand (or a few that belong together) to the program. A command's callback
/// sets the exit code: 0 done, 1 a bug or a failed reference case, 2 wrong input, 3 the numerics
/// gave up, 130 interrupted.
namespace adore::cli {

void add_run_command(CLI::App& app, int& exit_code);
void add_deck_commands(CLI::App& app, int& exit_code);  ///< check, plan, schema, new, examples
void add_calc_commands(CLI::App& app, int& exit_code);  ///< calc, validate
void add_find_command(CLI::App& app, int& exit_code);
void add_accuracy_command(CLI::App& app, int& exit_code);
void add_user_command(CLI::App& app, int& exit_code);  ///< user new
void add_study_command(CLI::App& app, int& exit_code);
void add_file_commands(CLI::App& app, int& exit_code);  ///< verify, show, convert

}  // namespace adore::cli
