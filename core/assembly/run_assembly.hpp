#pragma once

#include "assembly/solve_assembly.hpp"
#include "runs/run.hpp"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// Runs and checks of an assembly: `adore run FOLDER`, `adore check FOLDER`.
namespace adore::assembly {

struct AssemblyRunRequest : AssemblyRequest {
  std::optional<std::filesystem::path> out;  ///< empty: the folder of the assembly
  bool overwrite = false;
};

struct AssemblyOutcome {
  AssemblyResult result;
  std::filesystem::path folder;              ///< PRINT.txt, RUN.json, row-1/, row-2/ ...
  std::vector<std::filesystem::path> files;  ///< all of them
  std::string untrusted;                     ///< reason; empty: the results can be trusted
};

/// Solves and writes: PRINT.txt and RUN.json of the set, and in row-N/ the files of a run of each
/// deck at the displacement of its row. Nothing is written before all rows are solved.
/// @throws InputError, runs::ResultsExist, SolverError, Interrupted
[[nodiscard]] AssemblyOutcome run_assembly(const AssemblyRunRequest& request,
                                           std::stop_token stop = {});

/// Errors and findings of the file, of each deck, and of the set; nothing is written.
struct AssemblyCheck {
  std::string file;
  std::size_t rows = 0;
  std::vector<Finding> issues;
  [[nodiscard]] bool ok() const;
};
[[nodiscard]] AssemblyCheck check_assembly(const AssemblyRequest& request,
                                           std::stop_token stop = {});

}  // namespace adore::assembly
