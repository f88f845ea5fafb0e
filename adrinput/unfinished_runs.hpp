#pragma once

#include "deck/deck.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Interrupted or cancelled runs and sweeps of a deck that can be continued.
namespace adore::adrinput {

struct UnfinishedRun {
  std::filesystem::path folder;
  std::string state;  ///< "cancelled", "cut off", ...
};

/// Incomplete runs with a stored state, in the folder of the deck and in "run-001" and so on, in
/// the order of their names. Those of another deck in the same folder are not included.
[[nodiscard]] std::vector<UnfinishedRun> unfinished_runs(const std::filesystem::path& deck_file,
                                                         const deck::Deck& deck);

/// Sweeps in the folder of the deck and in "sweep-001" and so on, of any origin, that are
/// incomplete or have runs without a result, in the order of their names.
struct UnfinishedSweep {
  std::filesystem::path folder;
  std::string state;  ///< "sweep of appLoadZ=500:1500:5, cancelled"
};
[[nodiscard]] std::vector<UnfinishedSweep> unfinished_sweeps(
    const std::filesystem::path& deck_file);

/// Does the folder contain a state from which a run of the deck can continue?
[[nodiscard]] bool can_continue(const std::filesystem::path& folder, const deck::Deck& deck);

}  // namespace adore::adrinput
