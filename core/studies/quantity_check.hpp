#pragma once

#include "deck/deck.hpp"
#include "studies/study.hpp"

#include <string>
#include <vector>

/// Which quantities the runs of a deck cannot have, known before anything is computed.
namespace adore::studies {

/// Reason why runs of this deck do not have the quantity, "the scene has no cage (nCseg = 0)";
/// empty: they have it, as far as the deck shows. `until`: the study gives the length of the runs.
[[nodiscard]] std::string missing_quantity_reason(const Quantity& quantity, const deck::Deck& deck,
                                                  const std::string& until);

/// A sentence on all that are missing, with the key results that runs of the deck do have; empty:
/// none is.
[[nodiscard]] std::string missing_quantities_message(const std::vector<Quantity>& quantities,
                                                     const deck::Deck& deck,
                                                     const std::string& until);

}  // namespace adore::studies
