#pragma once

#include "deck/deck.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Runs and sweeps of a deck that were cut off or cancelled and can go on.
namespace adore::adrinput {

struct UnfinishedRun {
  std::filesystem::path folder;
  std::string state;  ///< "cancelled", "cut off", ...
};

/// The run beside the deck and those in "run-001" and on that have stored a state to go on from and
/// did not come to their end; in the order of their names. Another deck's in the same folder is
/// none of them.
[[nodiscard]] std::vector<UnfinishedRun> unfinished_runs(const std::filesystem::path& deck_file,
                                                         const deck::Deck& deck);

/// The sweep beside the deck and those in "sweep-001" and on, whoever made them, that did not come
/// to their end, or have runs without a result; in the order of their names.
struct UnfinishedSweep {
  std::filesystem::path folder;
  std::string state;  ///< "sweep of appLoadZ=500:1500:5, cancelled"
};
[[nodiscard]] std::vector<UnfinishedSweep> unfinished_sweeps(
    const std::filesystem::path& deck_file);

/// Does the folder hold a state that a run of the deck goes on from?
[[nodiscard]] bool can_go_on(const std::filesystem::path& folder, const deck::Deck& deck);

}  // namespace adore::adrinput
