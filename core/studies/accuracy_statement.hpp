#pragma once

#include "studies/verify.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// Stated interval of the results of a run, over its span and for each quantity.
///
/// interval = numerical part + statistical part, both relative to the scale of the quantity.
/// Scales: of the mean load of the races its length or, if larger, kLoadFloor of the mean largest
/// contact load (results/mean_load.hpp); of the heat of a part the heat of the whole bearing; of
/// the whirl the larger of whirl and cage ratio; of all others their own value.
///
/// Numerical part: kNumericalFactor times the difference to the same run with tighter settings
/// (verify()), kMinNumericalError at least: both share start state, tables of films and single
/// precision of films (3e-5), whose errors that difference does not show.
///
/// Statistical part: two accurate runs over the same span from the same start differ only by the
/// divergence of their motions. Transients and slow periods are the same in both and are not an
/// error of a mean over this span. It is measured by a second run with loads changed by
/// kLoadChange, as the larger of kDifferenceFactor times the difference of both means and the 95 %
/// interval of that difference from its batches (paired_scatter() in results/batch_means.hpp).
/// If the runs still diverge (late > kDivergingLimit), it is multiplied by sqrt(late): another
/// accurate run may diverge earlier. A deck without external loads has no such second run: the run
/// with tighter settings takes its place, and all quantities count as irregular. Largest loads and
/// the life have no batches: kDifferenceFactor times the difference alone, kNoBatchesFactor times
/// where it exceeds kRegularChange.
///
/// A quantity is irregular when its statistical part exceeds kDifferenceFactor kRegularChange. A
/// difference to the tighter run within the statistical part of an irregular quantity is scatter;
/// only the rest counts as numerical.
///
/// Revolutions that a target needs: the statistical part falls as measured (PairedScatter), from
/// the part e that this span would have if the runs had diverged from its beginning,
///   e(N) = e(T) (N / T)^-p,  N = kLengthMargin T (e(T) / target)^(1/p)
///   e(T) = statistical part, sqrt(late) times as large if the runs do not part any more; where
///   they part, at least sqrt(2) times the 95 % interval of the mean from the batches of this run
///   alone: runs that still diverge say little about their later distance, and these batches bound
///   it (transients count in them, so that N may be too large). N is then an order of magnitude
///   only.
/// kDivergingLimit: runs that diverged long ago exceed it with a probability of 3 %
/// (late / 2 of 8 equal normal blocks follows the beta distribution (2, 2)). kLengthMargin: e
/// from 8 blocks scatters by 1/4 itself (1/sqrt(2·8)), N by (5/4)². N is known within a factor of
/// kNeededFactor. A later change of the type of motion (a cage that begins to whirl) is not
/// foreseen. Largest loads are not means: no span makes them certain.
///
/// kNumericalFactor, kDifferenceFactor, kNoBatchesFactor, kMinNumericalError, kRegularChange,
/// kLengthMargin and kNeededFactor are estimates, checked over decks of all types
/// (resources/docs/accuracy-promises.md).
namespace adore::studies {

constexpr double kLoadChange = 1e-6;
constexpr double kRegularChange = 1e-4;
constexpr double kNumericalFactor = 1.5;
constexpr double kDifferenceFactor = 2.0;
constexpr double kNoBatchesFactor = 3.0;
constexpr double kMinNumericalError = 1e-4;
constexpr double kLengthMargin = 1.5;
constexpr double kDivergingLimit = 1.8;
constexpr double kNeededFactor = 2.0;

struct StatedQuantity {
  std::string id;      ///< key result; "mean_load" of the races
  std::string label;   ///< "heat, outer race"
  double value = 0.0;  ///< SI
  std::string unit;    ///< of the value
  double scale = 0.0;  ///< of the relative parts [SI]
  double numerical = 0.0, statistical = 0.0;
  double diverged_statistical = 0.0;  ///< statistical part of runs that diverge from the beginning
  double fall = 0.5;                  ///< of it with the span (PairedScatter)
  bool parting = false;  ///< the runs part mainly in the second half: the fall is not measured
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
  /// Revolutions after which the statistical part of each mean is within `target`; 0: this run is
  /// long enough. @param target relative
  [[nodiscard]] double required_revolutions(double target) const;
  /// The same of one quantity.
  [[nodiscard]] double required_revolutions(const StatedQuantity& q, double target) const;
  /// A quantity beyond `target` still parts: the needed revolutions are an order of magnitude.
  [[nodiscard]] bool has_diverging_quantity(double target) const;
  [[nodiscard]] bool keeps() const;
};

/// @param request as it was run, with the settings chosen for it
/// @throws InputError, Interrupted
[[nodiscard]] AccuracyStatement make_accuracy_statement(const runs::RunRequest& request,
                                                        const runs::RunOutcome& outcome,
                                                        double target, std::stop_token stop);

[[nodiscard]] std::string statement_text(const AccuracyStatement& statement);
[[nodiscard]] nlohmann::ordered_json statement_json(const AccuracyStatement& statement,
                                                    const results::MeanErrors& means);
/// Members "accuracy" and "verify" of RUN.json, and a last page of PRINT.txt.
void store_statement(const AccuracyStatement& statement, const runs::RunOutcome& outcome);

}  // namespace adore::studies
