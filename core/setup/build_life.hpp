#pragma once

#include "bearing/life_inputs.hpp"
#include "deck/deck.hpp"

namespace adore::setup {

/// What a deck says about fatigue life: records 8.6.0 to 8.6.3 (kLifeCons 1), 8.6.4 to 8.6.6
/// (materials given in the deck), residual stresses and fatigue limit of record 9.0.
/// @throws InputError for values that no model can work with, all of them at once.
[[nodiscard]] bearing::LifeInputs build_life(const deck::Deck& deck,
                                             const bearing::LifeChoices& choices = {});

}  // namespace adore::setup
