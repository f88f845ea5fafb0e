#pragma once

#include "facade/verify.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// Stated interval of the results of a run, over its own span and for each quantity.
///
/// interval = numerical part + statistical part, both relative to the scale of the quantity.
/// Scales: of the mean load of the races its length or, if larger, kLoadFloor of the mean largest
/// contact load (results/mean_load.hpp); of the heat of a part the heat of the whole bearing; of
/// the whirl the larger of whirl and cage ratio; of all others their own value.
///
/// Numerical part: kNumerical times the difference to the same run with tighter settings
/// (verify()), kFloor at least: both share start state, tables of films and single precision of
/// films (3e-5), whose errors that difference does not show.
///
/// Regular motion (a relative change of the loads by kNearby changes the quantity by less than
/// kRegular): statistical part = kTwin times the change by these loads.
///
/// Irregular motion: two accurate runs over the same span differ, however small their numerical
/// error is. The statistical part is the larger of kTwin times the change by these loads and
/// sqrt(2) times the half-width of the mean's 95 % interval (results/batch_means.hpp; sqrt(2): both
/// runs scatter). Two runs part exponentially from each other, and batches of a start that settles
/// vary more than runs do: the half-width counts up to kSeen times the largest difference of the
/// three runs. A difference to the tighter run within the statistical part is scatter; only the
/// rest counts as numerical.
///
/// Largest loads are no means: their statistical part is that of the changed loads alone. Without
/// external loads there is no such second run, and all quantities count as irregular.
///
/// kNumerical, kTwin, kSeen, kFloor and kRegular are estimates, checked over decks of all types
/// (resources/docs/accuracy-promises.md).
namespace adore::facade {

constexpr double kNearby = 1e-6;
constexpr double kRegular = 1e-4;
constexpr double kNumerical = 1.5;
constexpr double kTwin = 2.0;
constexpr double kSeen = 10.0;
constexpr double kFloor = 1e-4;

struct StatedQuantity {
  std::string id;      ///< key result; "mean_load" of the races
  std::string label;   ///< "heat, outer race"
  double value = 0.0;  ///< SI
  std::string unit;    ///< of the value
  double scale = 0.0;  ///< of the relative parts [SI]
  double numerical = 0.0, statistical = 0.0;
  bool irregular = false;
  bool mean = true;  ///< a longer run knows it better
  [[nodiscard]] double half_width() const { return numerical + statistical; }
};

struct AccuracyStatement {
  double target = 0.0;  ///< 0: none asked for
  double time = 0.0, turns = 0.0;
  Verification tighter;
  std::string twin_failure;                      ///< why there is no run under changed loads
  double run_seconds = 0.0, twin_seconds = 0.0;  ///< processor time
  std::vector<StatedQuantity> quantities;        ///< empty: the tighter run failed

  /// Largest numerical part.
  [[nodiscard]] double numerical() const;
  /// Revolutions after which the statistical part of each mean is within `target`, by its fall with
  /// the square root of the span; 0: this run is long enough. @param target relative
  [[nodiscard]] double needed_turns(double target) const;
  [[nodiscard]] bool keeps() const;
};

/// @param request as it was run, with the settings chosen for it
/// @throws InputError, Interrupted
[[nodiscard]] AccuracyStatement state_accuracy(const RunRequest& request, const RunOutcome& outcome,
                                               double target, std::stop_token stop);

[[nodiscard]] std::string statement_text(const AccuracyStatement& statement);
[[nodiscard]] nlohmann::ordered_json statement_json(const AccuracyStatement& statement,
                                                    const results::MeanErrors& means);
/// Members "accuracy" and "verify" of RUN.json, and a last page of PRINT.txt.
void store_statement(const AccuracyStatement& statement, const RunOutcome& outcome);

}  // namespace adore::facade
