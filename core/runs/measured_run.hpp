#pragma once

#include "runs/run.hpp"

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

/// A run for the sake of its figures and its cost; its files are thrown away.
namespace adore::runs {

struct MeasuredRun {
  RunOutcome outcome;    ///< files: none
  double seconds = 0.0;  ///< processor time of everything: deck, start state, motion, output [s]
  bool cut = false;      ///< given up because it took longer than it was worth
};

/// Runs the deck as run() does, including every output file, in a separate folder that is removed
/// at the end. The time is the processor time of this thread: other programs on the machine
/// have little influence.
/// @param most_seconds a longer run is cut [s]
/// @throws as run(); Interrupted when `stop` requests it
[[nodiscard]] MeasuredRun measured_run(RunRequest request, double most_seconds,
                                       std::stop_token stop);

/// The loads of the deck that are not zero, changed by a share, in its units.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> nearby_loads(const deck::Deck& deck,
                                                                            double change);

}  // namespace adore::runs
