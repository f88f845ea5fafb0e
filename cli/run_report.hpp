#pragma once

#include "runs/run.hpp"
#include "studies/sweep.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

/// Final report of `adore run`.
namespace adore::cli {

/// A word quoted for the shell.
[[nodiscard]] std::string quoted(const std::string& word);
/// Of a file, which is not to look like an option.
[[nodiscard]] std::string quoted_path(const std::filesystem::path& path);

/// Summary, files, and commands for pictures and continuation.
/// @param continuation the command that continues the run; empty: none
[[nodiscard]] std::string summary_text(const runs::RunOutcome& outcome,
                                       const std::string& continuation);

/// An end for --until at twice the length of the run.
[[nodiscard]] std::string doubled_length(const runs::RunOutcome& outcome);

/// @param again the command that repeats failed runs; empty: reported elsewhere
[[nodiscard]] std::string sweep_text(const studies::SweepOutcome& outcome,
                                     const std::string& again);
/// The same as one JSON object.
[[nodiscard]] nlohmann::ordered_json summary_json(const runs::RunOutcome& outcome);
[[nodiscard]] nlohmann::ordered_json summary_json(const studies::SweepOutcome& outcome);

[[nodiscard]] int exit_code(const runs::RunOutcome& outcome);

}  // namespace adore::cli
