#pragma once

#include "results/accuracy_errors.hpp"
#include "runs/measured_run.hpp"

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

/// Cost of accuracy for the user's deck: its own run (start state, steps, output
/// and all files) is repeated with other integrators, tolerances and longest steps, and its key
/// results are compared with those of a run that is far more accurate.
///
/// Errors of the results (results/accuracy_errors.hpp): all runs over the same span of whole
/// revolutions from the same start. The error of a row is the largest of them. A second reference
/// by another method, and runs of two methods with loads changed by 1e-6, limit the accuracy of
/// such means: for an irregular motion such runs differ too (accuracy_judgement.hpp:
/// estimate_noise()). This is judged for each quantity separately: an irregular whirl does not
/// excuse an error of heat or of the cage speed.
///
/// Two rounds: all settings over a short span, then the deck's own and the best candidates over as
/// many revolutions as the budget allows. The study ends within the budget: rows are cut or left
/// out at its end (and reported), and references that are slower than planned shorten the second
/// span. If the second span is shorter than specified, the growth measured between both spans is
/// reported with the recommendation.
namespace adore::studies {

struct AccuracyRequest : runs::DeckRequest {
  std::vector<std::string> methods;  ///< empty: every integrator
  std::vector<double> tolerances{1e-4, 1e-5, 1e-6, 1e-7};
  double turns = 50.0;    ///< of the shaft, inner against outer race, in the second round at most
  double budget = 120.0;  ///< processor time of the whole study [s]
  double target = 0.01;   ///< error that the recommendation keeps to
  bool models = true;     ///< study the effect of other resolutions of the model, too
};

/// One way to run the deck.
struct AccuracySetting {
  std::string method;
  double tolerance = 0.0;
  bool as_long_as_stable = false;  ///< stpMax does not bind: contact vibrations do (judge_steps)
  bool own = false;                ///< settings of the deck itself
  /// Other values of deck variables or run options than the deck's: resolutions of the model.
  std::vector<std::pair<std::string, std::string>> sets, options;
  bool dear = false;  ///< a model that takes thousands of times longer: over a separate short span
  /// "rkf5, tol 1e-06, stpMax 0.5", "hertzConstants frozen"
  std::string name;
};

struct AccuracyRow {
  AccuracySetting setting;
  double turns = 0.0;  ///< span of its run
  results::AccuracyErrors errors;
  double seconds = 0.0;  ///< processor time of the run, of three runs the median
  int runs = 1;
  long steps = 0, evaluations = 0;
  double at_longest = 0.0;    ///< mean step over the longest allowed
  double longest = 0.0;       ///< step allowed, in the unit of stpMax
  double energy_share = 0.0;  ///< |residual| over the energy moved
  double order = 0.0;         ///< observed against the next tolerance of the method; 0: none
  double growth = 0.0;  ///< of energy_share per revolution, from the first span to this; 0: none
  bool front = false;   ///< no other row of its round is cheaper and as good
  std::string failure;  ///< empty, or why there is no result
};

/// The more accurate run that others are compared with.
struct AccuracyReference {
  results::KeyResults results;    ///< empty: there is none yet
  results::AccuracyErrors noise;  ///< of a second accurate run by another method
  double seconds = 0.0;           ///< processor time of both
};

struct AccuracyStudy {
  std::string digest;                          ///< of deck, options and request
  double turn = 0.0;                           ///< [s]
  double asked = 0.0;                          ///< turns asked for
  double short_turns = 0.0, long_turns = 0.0;  ///< of the rounds
  std::string reference;                       ///< how the reference was made
  AccuracyReference short_reference, long_reference;
  /// Effect of a relative load change of 1e-6 over the second span; negative: not measured.
  results::AccuracyErrors irregular = results::AccuracyErrors::none();
  std::string irregular_by;        ///< the settings by which that was measured
  std::vector<std::string> twins;  ///< settings whose steps are those of another row, not listed
  double target = 0.0;
  std::vector<AccuracyRow> screening, finals, models;
  int recommended = -1;  ///< among finals; negative: none keeps to the target
  double seconds = 0.0;  ///< processor time of the study, of the rows taken over, too
  /// Part of it in runs without a row: short ones that measure the time of a revolution, references
  /// that were cut, runs with changed loads, repetitions.
  double unlisted_seconds = 0.0;
  int untried = 0;  ///< settings and models for which the budget left no time
  bool complete = false;

  /// How far means over the second span can be known: the larger of what two accurate runs differ
  /// by and of `irregular`.
  [[nodiscard]] results::AccuracyErrors noise() const {
    return results::larger(long_reference.noise, irregular);
  }
  /// Errors up to which a row may be recommended: each the target, or kBeyondNoise times its noise.
  [[nodiscard]] results::AccuracyErrors limits() const;
  [[nodiscard]] bool keeps(const results::AccuracyErrors& errors) const;
};

/// A row that is done, in its round.
using AccuracySink = std::function<void(const AccuracyRow&, const AccuracyStudy&)>;

/// @param earlier a study that was broken off: rows of the same request are taken from it; one of
/// the same request that is complete comes back as it is
/// @throws InputError (quasi-static deck, unknown method), SolverError when no reference can be
/// computed. An interrupted study comes back as far as it got, `complete` false.
AccuracyStudy study_accuracy(const AccuracyRequest& request, const AccuracySink& row_done = {},
                             std::stop_token stop = {}, const AccuracyStudy& earlier = {});

/// A study on its way, with what the earlier one had beyond it: what is written meanwhile loses
/// nothing of it, whenever the program ends.
[[nodiscard]] AccuracyStudy joined(AccuracyStudy study, const AccuracyStudy& earlier);

/// "1 %", "1 % (speeds within 5.2 %)" where the motion is irregular.
[[nodiscard]] std::string limits_text(const AccuracyStudy& study);
/// Why the limits are wider than the target; empty where they are not.
[[nodiscard]] std::string irregular_text(const AccuracyStudy& study);

/// One sentence: which settings this deck wants, and what they reach.
[[nodiscard]] std::string recommendation(const AccuracyStudy& study);
/// The deck variables of the recommended settings; empty without one.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> recommended_sets(
    const AccuracyStudy& study);

/// "first round, 0.48 turns": context of a row that is reported during the study.
[[nodiscard]] std::string round_text(const AccuracyRow& row, const AccuracyStudy& study);
[[nodiscard]] std::string accuracy_table(const AccuracyStudy& study);
[[nodiscard]] std::string accuracy_csv(const AccuracyStudy& study);
/// The whole study; read_accuracy() takes it back.
[[nodiscard]] std::string accuracy_json(const AccuracyStudy& study);
/// @throws InputError when the text is not a study.
[[nodiscard]] AccuracyStudy read_accuracy(const std::string& text, const std::string& name);

}  // namespace adore::studies
