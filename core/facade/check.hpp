#pragma once

#include "deck/deck.hpp"

#include <vector>

namespace adore::facade {

/// What `adore check` says beyond the deck's own rules, of a deck without errors: what this version
/// cannot run yet (notes), and everything that shows only when the model is built (of a motion that
/// cannot be run, the quasi-static one): geometry and traction laws that cannot close, fits that
/// lose the clearance or overstress a ring.
/// @throws SolverError when the operating state of the bearing cannot be found.
[[nodiscard]] std::vector<Issue> check_model(const deck::Deck& deck);

}  // namespace adore::facade
