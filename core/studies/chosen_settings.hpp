#pragma once

#include "studies/accuracy.hpp"

#include <limits>
#include <string>
#include <utility>
#include <vector>

/// The cheapest settings that keep a run within an error: integrator, tolerance and longest step by
/// a short accuracy study, then the nodes of the contact ellipses or the slices of the rollers.
namespace adore::studies {

/// A resolution of the contacts against the finest one.
struct ResolutionRow {
  std::vector<std::pair<std::string, std::string>> options;
  std::string name;                     ///< "ellipse nodes 15 x 2", "roller slices 31"
  results::AccuracyErrors significant;  ///< errors above `noise`; others are 0
  bool below_noise = false;             ///< some error is within the noise
  double seconds = 0.0;
  bool is_default = false;  ///< settings of the run without a choice
  std::string failure;      ///< empty, or why there is no result
};

struct ChosenSettings {
  std::string integrator;
  double tolerance = 0.0;
  std::vector<std::pair<std::string, std::string>> sets, options;
  std::string text;  ///< chosen settings and measured error, a sentence or two

  // How.
  results::AccuracyErrors steps;  ///< of integrator and steps (study.finals)
  double turns = 0.0;             ///< span of the runs behind `rows`
  results::AccuracyErrors
      noise;           ///< of runs under loads that differ by a millionth, over that span
  std::string finest;  ///< reference of the rows
  std::vector<ResolutionRow> rows;  ///< from the cheapest on, as far as was needed
  int resolution = -1;              ///< the chosen row; negative: the deck's own stays
};

/// Three quarters of `target` go to the steps, what they leave to the resolution: of runs over the
/// same short span (one revolution of the shaft, less if it takes seconds) with the chosen steps,
/// the one with the fewest nodes or slices whose key results, and those of the next finer one, keep
/// within it of the finest (60 x 4 nodes, 60 x 8 with films, 121 slices). Differences below
/// 1.5 times the noise do not count as errors. Resolutions of the request are kept. Limits: over
/// a longer span irregular motions (the whirl of a cage) diverge after any change: the
/// statement on a run is that of make_accuracy_statement(). If no steps of the study meet the
/// target, the most accurate ones are taken.
/// @param most_turns longest run of the study: the span of the run
/// @throws SolverError when no run completes; InputError and Interrupted as study_accuracy()
[[nodiscard]] ChosenSettings choose_settings(
    const runs::DeckRequest& request, double target, std::stop_token stop,
    double most_turns = std::numeric_limits<double>::infinity());

/// Span of the run as far as it is known before its first step: its end by time [revolutions].
[[nodiscard]] double requested_revolutions(const runs::RunRequest& request);

/// A tenth of the tolerance, half of the longest step and twice the nodes or slices.
void tighten_settings(ChosenSettings& chosen, const runs::RunRequest& request,
                      const runs::RunOutcome& outcome);

/// Adds what was chosen to the request, in the place of what it says of the same variables.
void apply_chosen_settings(runs::RunRequest& request, const ChosenSettings& chosen);

/// run() with settings chosen for the request, which PRINT.txt and RUN.json tell in a note.
[[nodiscard]] runs::RunOutcome run_with_chosen_settings(runs::RunRequest request,
                                                        const ChosenSettings& chosen,
                                                        const runs::ProgressSink& progress = {},
                                                        std::stop_token stop = {});

}  // namespace adore::studies
