#pragma once

#include "bearing/bearing.hpp"
#include "deck/deck.hpp"

/// Records 5B to 5F of a deck: roller and raceway geometry in SI, and what a roller weighs.
namespace adore::setup {

/// @throws InputError for reserved values and geometry that cannot close.
[[nodiscard]] bearing::RollerGeometry build_roller_geometry(const deck::Deck& deck);

struct RollerMassProperties {
  bearing::Inertia inertia;  ///< x along the roller axis, about the mass center
  double mass_offset = 0.0;  ///< s_G from mid length [m]
};
/// Of the nominal roller, crown, domes and corners included.
[[nodiscard]] RollerMassProperties roller_mass_properties(const bearing::RollerGeometry& rollers,
                                                          double density);

}  // namespace adore::setup
