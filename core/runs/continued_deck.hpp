#pragma once

#include "base/errors.hpp"
#include "deck/deck.hpp"
#include "setup/run_control.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// A run that starts from the files of another one, under a deck that may have changed since.
namespace adore::runs {

/// The deck that FINAL or MASTER holds.
/// @param file named in the message
/// @throws InputError when it has errors, with each of them
[[nodiscard]] deck::Deck read_stored_deck(const std::string& stored,
                                          const std::filesystem::path& file);

/// Compares the deck stored in `file` (FINAL or MASTER) with the one to be run now. Loads, speeds,
/// temperatures, friction, steps and output may change; a continued run (StartState::Continue)
/// keeps the bearing itself, because state, files and sums belong to it. Variables that every
/// continuation changes (kIcOpt, maxStps, fTime) and file names are not mentioned.
/// @return notes on changes, and on changes without effect; one note when the file has
/// no deck.
/// @throws InputError with every change that is not allowed, or for a stored deck with errors.
[[nodiscard]] std::vector<Issue> compare_with_stored(const std::string& stored,
                                                     const deck::Deck& now,
                                                     const std::filesystem::path& file,
                                                     setup::StartState start);

/// A change of the deck may give the bearing another equilibrium or another mode of motion.
/// @param stored a deck that compare_with_stored accepted
[[nodiscard]] bool may_change_equilibrium(const std::string& stored, const deck::Deck& now,
                                          setup::StartState start);

}  // namespace adore::runs
