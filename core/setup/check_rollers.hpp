#pragma once

#include "bearing/rollers.hpp"
#include "deck/deck.hpp"

#include <vector>

/// Can rollers of this shape exist? In the deck's words, with the limit of each value that cannot
/// be.
namespace adore::setup {

/// The nominal roller: length under its taper, crown, end radii, corners.
/// @throws InputError with every value that does not fit, and what would.
void check_roller_shape(const deck::Deck& deck, const bearing::RollerGeometry& rollers);

/// The rollers with their own deviations (records 5G.1).
/// @throws InputError naming roller and variable.
void check_roller_deviations(const deck::Deck& deck, const bearing::RollerGeometry& rollers);

/// Flanges that no roller end meets, or that leave rollers no play or no guidance: warnings.
[[nodiscard]] std::vector<Issue> check_flanges(const deck::Deck& deck);

}  // namespace adore::setup
