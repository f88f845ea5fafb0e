#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Published experiments beside what this program computes of them: resources/experiments, where
/// experiments.json says of each source what it measured, how sure that is, and what had to be
/// assumed, and every deck stands in a file of its own. A row is printed as it comes out; nothing
/// here decides whether it is good.
namespace adore::facade {

struct ExperimentRow {
  std::string condition;  ///< "28000 rpm"
  std::string what;       ///< "power loss"
  std::string unit;       ///< of both figures: "W"
  std::optional<double> ours;
  std::string failed;  ///< why there is no figure of ours: the run's own sentence
  /// Theirs: one figure, or from the first to the second; none where the source is kept aside.
  std::optional<double> theirs, theirs_to;
  /// "calibration", "prediction", "part" of the row above, or "bound": theirs is the most it may
  /// be.
  std::string kind;
  std::string certainty;  ///< of theirs: "printed", "digitised, 3 %", ...

  /// Ours over theirs less 1, of a range its nearer end (0 inside it); of a bound nothing.
  [[nodiscard]] std::optional<double> deviation() const;
};

struct ExperimentParameter {
  std::string name, meaning;
  double value = 0.0, low = 0.0, high = 0.0;  ///< physical bounds that the fit kept
};

struct Experiment {
  std::string id, source, about;
  std::vector<std::string> assumed;             ///< where the source is silent
  std::vector<ExperimentParameter> parameters;  ///< fitted, or taken over from another's fit
  std::vector<std::string> decks;               ///< resources that `adore new` does not list
  std::vector<ExperimentRow> rows;
  std::string open;  ///< what of the source no deck expresses, and why
};

/// @param only one of the ids; empty: all
/// @param progress called with each id before it is computed
/// @throws InputError for an id that is not there
[[nodiscard]] std::vector<Experiment> run_experiments(
    std::string_view only = {}, const std::function<void(const std::string&)>& progress = {});

[[nodiscard]] std::string experiments_text(const std::vector<Experiment>& experiments);
/// The page resources/docs/experiments.md.
[[nodiscard]] std::string experiments_markdown(const std::vector<Experiment>& experiments);
[[nodiscard]] nlohmann::ordered_json experiments_json(const std::vector<Experiment>& experiments);

}  // namespace adore::facade
