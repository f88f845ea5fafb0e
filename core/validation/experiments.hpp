#pragma once

#include "validation/experiment_data.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Published experiments compared with results of this program. The data are in
/// resources/experiments (experiment_data.hpp), every deck in a separate file. A row is printed
/// with its result; nothing here judges it.
///
/// Three checks act on every row:
/// - Energy: with a flowing coolant, the outlet temperature T_out = T_in + Q/(ρ c W) is a row, Q
///   the source's heat, or ours where the source's is kept aside. Above the hottest measured ring:
///   "inputs doubtful"; more than kImpossible above it: "inputs impossible".
/// - Definition: what the source subtracts (a computed rib torque) is subtracted from ours.
/// - Parameters: one at its bound is reported.
namespace adore::validation {

struct ExperimentRow {
  std::string condition;  ///< "28000 rpm"
  std::string what;       ///< "power loss"
  std::string unit;       ///< of both figures: "W"
  std::optional<double> ours;
  std::string
      failed;  ///< why there is no figure of ours: the run's sentence, or "not computed: .."
  /// Theirs: one figure, or from the first to the second; none where the source is kept aside.
  std::optional<double> theirs, theirs_to;
  std::string their_text;  ///< in place of a figure
  RowType type = RowType::Value;
  std::string their_sign;
  /// "calibration", "prediction", or "part" of the row above.
  std::string kind;
  std::string certainty;  ///< of theirs: "printed", "digitised, 3 %", ...
  bool model = false;     ///< theirs is an engineering model, no measurement

  /// Ours over theirs less 1, of a range its nearer end (0 inside it); of bounds and signs nothing.
  [[nodiscard]] std::optional<double> deviation() const;
  /// Whether a bound or a sign agrees; nothing for other rows and without a figure of ours.
  [[nodiscard]] std::optional<bool> agrees() const;
  [[nodiscard]] bool kept_aside() const { return certainty.starts_with("kept aside"); }
  [[nodiscard]] bool not_computed() const { return failed.starts_with("not computed"); }
};

struct Experiment {
  std::string id, source, about;
  std::vector<std::string> assumed;       ///< value not given in the source
  std::vector<ParameterData> parameters;  ///< fitted, or taken over from another's fit
  std::vector<std::string> decks;         ///< resources that `adore new` does not list
  std::vector<ExperimentRow> rows;
  std::vector<std::string> inputs;  ///< "12,000 rpm: inputs doubtful: ..."
  std::string open;  ///< parts of the source that a deck cannot express, with reasons
};

/// Verdict of the energy check; empty: the outlet is not hotter than the ring. @param ring nothing:
/// not judged
[[nodiscard]] std::string energy_verdict(double outlet, const std::optional<double>& ring);
/// Above the hottest ring by more than this [K].
inline constexpr double kImpossible = 30.0;

/// @param only one of the ids; empty: all
/// @param progress called with each id before it is computed
/// @throws InputError for an id that is not there
[[nodiscard]] std::vector<Experiment> run_experiments(
    std::string_view only = {}, const std::function<void(const std::string&)>& progress = {});
/// The same of other data.
[[nodiscard]] Experiment run_experiment(const ExperimentData& data);
/// The embedded data.
[[nodiscard]] std::vector<ExperimentData> embedded_experiments();

/// Deviations of a group of rows.
struct ExperimentGroup {
  std::string name;
  int rows = 0;
  double median = 0.0, ninth = 0.0;  ///< of |deviation|: median and 90th percentile
};
struct ExperimentSummary {
  std::vector<ExperimentGroup> groups;  ///< calibration, prediction, prediction of the model
  int bounds = 0, bounds_held = 0, signs = 0, signs_agree = 0;
  int kept_aside = 0, not_computed = 0, failed = 0, parts = 0;
  std::vector<std::string> remarks;  ///< parameters at a bound, doubtful inputs
};
[[nodiscard]] ExperimentSummary summarize(const std::vector<Experiment>& experiments);

[[nodiscard]] std::string experiments_text(const std::vector<Experiment>& experiments);
/// The page resources/docs/experiments.md.
[[nodiscard]] std::string experiments_markdown(const std::vector<Experiment>& experiments);
[[nodiscard]] nlohmann::ordered_json experiments_json(const std::vector<Experiment>& experiments);

}  // namespace adore::validation
