#pragma once

#include "base/finding.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Findings of a finished run: list `findings` of RUN.json. RESULTS.h5 has those known before the
/// first step (origins check, statics and plan) as text in the attributes "findings" and "findings
/// checksum": it has the same bytes however often the run was continued, and the watches of a
/// motion begin anew in each process (decision 809).
namespace adore::results {

struct FindingsText {
  static constexpr const char *kList = "findings", *kSum = "findings checksum";  ///< attributes
  std::string list, sum;
};
/// Text of the findings that RESULTS.h5 stores, with file names instead of paths. Notes of the
/// check are left out, because a value without effect changes no byte of the results. The text is
/// at most 60 kB long; notes are dropped first.
[[nodiscard]] FindingsText findings_text(std::span<const Finding> findings);

/// Of the attributes. @throws InputError when the file or its list is damaged
[[nodiscard]] std::vector<Finding> stored_findings(const std::filesystem::path& results_h5);

/// Findings of the run in a folder, or of the run that a file of it belongs to: those of RUN.json,
/// else of RESULTS.h5. Sentences of `notes`, when an earlier release wrote RUN.json. Nothing where
/// nothing can be read.
[[nodiscard]] std::vector<Finding> run_findings(const std::filesystem::path& run);

}  // namespace adore::results
