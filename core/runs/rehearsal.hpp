#pragma once

#include "runs/prepare.hpp"
#include "runs/run.hpp"

#include <vector>

namespace adore::runs {

/// Messages of `adore run` on a deck before its first step.
struct DryRunResult {
  std::vector<Issue> refusals;   ///< errors; empty: the run begins
  std::vector<Finding> remarks;  ///< warnings and notes, those of the reader among them
};

/// All findings that a run reports before its first step: first about deck, statics and scene, then
/// about request, method and start state. Writes nothing.
/// @param folder of the run's files; empty: no file is looked at
/// @throws InputError, SolverError as the run
[[nodiscard]] std::vector<Finding> findings_before_first_step(
    const RunRequest& request, Prepared& prepared, const std::filesystem::path& folder = {});

/// The checks of the model, the equilibrium, the method and its steps, the start state. Folders,
/// and files of earlier runs in them, are not looked at. Writes nothing. Takes as long as a run
/// takes until its first step.
/// @param input a deck without errors @throws Interrupted when input.stop ended it
[[nodiscard]] DryRunResult dry_run_without_files(LoadedDeck input);

/// Errors of `adore run` on a deck before its first step: checks of the
/// model, a folder without write permission, the equilibrium, the method and its steps, the
/// start state, and outputs that would replace foreign files. Earlier results are not checked: the
/// run asks about them. Writes nothing. Takes as long as a run until its first step.
/// @param input a deck without errors. Without a path it has no folder, and files are not checked
/// @return errors; empty: the run begins
/// @throws Interrupted when input.stop ended it
[[nodiscard]] std::vector<Issue> dry_run_errors(LoadedDeck input);
/// The same with the findings that `adore check` lists.
[[nodiscard]] DryRunResult dry_run_with_files(LoadedDeck input);

}  // namespace adore::runs
