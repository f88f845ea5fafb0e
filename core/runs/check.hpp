#pragma once

#include "deck/deck.hpp"
#include "deck/no_part.hpp"
#include "runs/deck_request.hpp"

#include <stop_token>
#include <string>
#include <vector>

namespace adore::runs {

/// Checks of `adore check` beyond the deck's own rules, for a deck without errors: features that
/// this version cannot run yet (notes), and everything that shows only when the model is built (of
/// a motion that cannot be run, the quasi-static one): geometry and traction laws that cannot
/// close, fits that lose the clearance or overstress a ring.
/// @throws SolverError when the operating state of the bearing cannot be found.
[[nodiscard]] std::vector<Issue> check_model(const deck::Deck& deck);

/// `adore check`: all checks of a deck and its run options.
struct CheckReport {
  std::string file;               ///< name of the deck in messages
  std::size_t records = 0;        ///< in it
  std::vector<Finding> issues;    ///< errors, warnings, notes
  [[nodiscard]] bool ok() const;  ///< no error among them
};

/// Features that cannot run yet are notes here and errors of run(). Any other deck
/// without errors is rehearsed (rehearsal.hpp): errors that would end a run before its first step
/// are errors here, including equilibrium, films and steps of the method. Files of the deck's
/// folder are not read. Takes as long as a run until its first step.
/// @throws InputError when the deck cannot be read, SolverError as check_model(), Interrupted
[[nodiscard]] CheckReport check(const DeckRequest& request, std::stop_token stop = {});

/// The same, with the values that a form shows next to its fields.
struct ModelCheck {
  std::vector<Finding> issues;
  std::vector<Issue> refusals;       ///< those of `issues` for which `adore run` rejects the deck
  std::vector<deck::NoPart> unused;  ///< values that a run of this deck does not use, and why;
                                     ///< empty when it cannot be run
  std::vector<std::string> effects;  ///< of a motion, by the names that run option effectsOff takes
};
[[nodiscard]] ModelCheck examine_model(const deck::Deck& deck);

}  // namespace adore::runs
