#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

/// Runs reference cases (JSON files of inputs and expected results) against the library and reports
/// error against tolerance. The tolerance conventions of the families are those of
/// tests/reference/*README.md.
namespace adore::validation {

/// One expected quantity. `error` and `tolerance` are relative when the relative tolerance governs,
/// absolute otherwise.
struct QuantityResult {
  std::string key;  ///< "steady_state.Q_o"
  double error = 0.0, tolerance = 0.0;
  bool pass = true;
  std::string message;  ///< reason of failure if no number shows it
};

struct CaseResult {
  std::string id;
  std::string status;     ///< "pass", "fail" or "not_covered"
  std::string worst_key;  ///< quantity with the largest error/tolerance
  double error = 0.0, tolerance = 0.0;
  std::string message;
  std::vector<QuantityResult> quantities;
  /// "entry": function of the library that the case evaluated; of motions also "stepper",
  /// "system_evaluations" (calls of System::rhs by the stepper) and its steps.
  nlohmann::json evaluation;
};

struct FileResult {
  std::string file, family;
  std::vector<CaseResult> cases;
  double seconds = 0.0;
};

struct ValidateReport {
  std::vector<FileResult> files;
  int pass = 0, fail = 0, not_covered = 0;
  [[nodiscard]] bool failed() const { return fail > 0; }
};

/// Compares one result with one case: every key of `expected` must be there and within tolerance.
/// A case of provenance "recalled" never fails: beyond its tolerance it is "not_covered" with a
/// message.
[[nodiscard]] CaseResult compare_case(const std::string& family, const nlohmann::json& the_case,
                                      const nlohmann::json& result);

/// @param progress called after each file
/// @param standard_input content of the file named "-"
/// @throws InputError when a file cannot be read or holds no reference cases
[[nodiscard]] ValidateReport validate_files(
    std::span<const std::filesystem::path> files,
    const std::function<void(const FileResult&)>& progress = {},
    const std::string& standard_input = {});

/// {"files": [{"file", "cases": [{"id", "status", "evaluation": {"entry", ...}, "worst": {"key",
/// "error", "tolerance"}}]}],
/// "totals": {...}}
[[nodiscard]] nlohmann::json report_json(const ValidateReport& report);

/// One line per file and one per failed case, with error/tolerance of the quantities that fail;
/// `verbose`: one line per case, with all its quantities.
[[nodiscard]] std::string file_result_text(const FileResult& file, bool verbose);
[[nodiscard]] std::string totals_text(const ValidateReport& report);

}  // namespace adore::validation
