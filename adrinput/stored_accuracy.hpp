#pragma once

#include "adrinput/evaluation.hpp"
#include "deck/deck.hpp"

#include <filesystem>
#include <string>

namespace adore::adrinput {

/// What earlier studies have stored beside a deck: the model errors of MODELS.json, where it is of
/// this deck as it is in the form, and the accuracy and the verification of the last run in
/// RUN.json. Empty: none, or files that nobody can read.
[[nodiscard]] std::string stored_accuracy(const std::filesystem::path& deck_file,
                                          const deck::Deck& deck, const RunOptionValues& options);

}  // namespace adore::adrinput
