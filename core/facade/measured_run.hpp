#pragma once

#include "facade/run.hpp"

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

/// A run for the sake of its figures and its cost; its files are thrown away.
namespace adore::facade {

struct MeasuredRun {
  RunOutcome outcome;    ///< files: none
  double seconds = 0.0;  ///< processor time of everything: deck, start state, motion, output [s]
  bool cut = false;      ///< given up because it took longer than it was worth
};

/// Runs the deck as run() does, every output file included, in a folder of its own that is removed
/// at the end. The time is the processor's for this thread: what other programs do on the machine
/// plays a small part.
/// @param most_seconds a run that takes longer is cut [s]
/// @throws what run() throws; Interrupted when `stop` asks for it
[[nodiscard]] MeasuredRun measured_run(RunRequest request, double most_seconds,
                                       std::stop_token stop);

/// Value of a key result [SI]; not a number when the run has none.
[[nodiscard]] double value_of(const results::KeyResults& results, std::string_view id);

/// The loads of the deck that are not zero, changed by a share, in its units.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> nearby_loads(const deck::Deck& deck,
                                                                            double change);

}  // namespace adore::facade
