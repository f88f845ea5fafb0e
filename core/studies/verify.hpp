#pragma once

#include "studies/accuracy.hpp"

#include <nlohmann/json_fwd.hpp>

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace adore::runs {
struct Prepared;
}

/// A run compared with tighter settings: its remaining numerical errors.
namespace adore::studies {

struct Verification {
  results::AccuracyErrors errors;  ///< of the run, against the tighter one (accuracy.hpp)
  double seconds = 0.0;            ///< processor time of the tighter run
  std::string tighter;             ///< "tol 1e-07, steps at most half as long"
  results::KeyResults results;
  results::MeanSeries means;
  std::string failure;  ///< why the tighter run gave no results; empty when it did
};

/// Repeats a run that came to its end with a tenth of its tolerance, half of the longest step that
/// it was allowed and twice the nodes of the contact ellipses in both directions or twice the
/// slices of the rollers, from the start to the same end, and compares. A run that was continued is
/// repeated as a whole. @throws InputError, Interrupted
[[nodiscard]] Verification verify(const runs::RunRequest& request, const runs::RunOutcome& outcome,
                                  std::stop_token stop);

/// The same run again from the start to the end that it reached, its files only as long as needed.
[[nodiscard]] runs::RunRequest repeated(const runs::RunRequest& request,
                                        const runs::Prepared& prepared,
                                        const runs::RunOutcome& outcome);

/// Twice the nodes or slices of the run, as run options. Empty: neither acts.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> doubled_resolution(
    const runs::Prepared& prepared);

[[nodiscard]] nlohmann::ordered_json verification_json(const Verification& verification,
                                                       const runs::RunOutcome& outcome);
[[nodiscard]] std::string verification_text(const Verification& verification,
                                            const runs::RunOutcome& outcome);

/// "speeds 0.1 %, loads 0.02 %, heat 0.3 %, life not computed" of what could be compared.
[[nodiscard]] std::string errors_text(const results::AccuracyErrors& errors);

}  // namespace adore::studies
