#pragma once

#include "deck/deck.hpp"

#include <QStringList>

#include <filesystem>
#include <optional>

/// What a run left, as it is on the disk now.
namespace adore::adrinput {

struct RunResults {
  QStringList plots;   ///< SOL1 to SOL7, or the tables of a quasi-static solution or a sweep
  QString animation;   ///< SOL8
  QString listing;     ///< PRINT.txt
  bool moved = false;  ///< `plots` are of a motion
};

/// Files in a folder under the names that the deck gives them; with `since`, those written from
/// then on. Nothing of what a program has not written yet, or somebody has removed.
[[nodiscard]] RunResults results_in(
    const std::filesystem::path& folder, const deck::Deck& deck,
    const std::optional<std::filesystem::file_time_type>& since = std::nullopt);

}  // namespace adore::adrinput
