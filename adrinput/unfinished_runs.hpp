#pragma once

#include "deck/deck.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Runs of a deck that were cut off or cancelled and can go on.
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

/// Does the folder hold a state that a run of the deck goes on from?
[[nodiscard]] bool can_go_on(const std::filesystem::path& folder, const deck::Deck& deck);

}  // namespace adore::adrinput
