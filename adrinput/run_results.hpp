#pragma once

#include "deck/deck.hpp"

#include <QStringList>

#include <filesystem>
#include <optional>

/// Files of a run on the disk.
namespace adore::adrinput {

struct RunResults {
  QStringList plots;   ///< SOL1 to SOL7, or the tables of a quasi-static solution or a sweep
  QString animation;   ///< SOL8
  QString listing;     ///< PRINT.txt
  QString values;      ///< RESULTS.h5 of a motion
  bool moved = false;  ///< `plots` are of a motion
};

/// Files in a folder under the names in the deck; with `since`, those written after that time.
/// Missing files are skipped.
[[nodiscard]] RunResults results_in(
    const std::filesystem::path& folder, const deck::Deck& deck,
    const std::optional<std::filesystem::file_time_type>& since = std::nullopt);

}  // namespace adore::adrinput
