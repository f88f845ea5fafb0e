#pragma once

#include "bearing/life_inputs.hpp"
#include "deck/deck.hpp"

namespace adore::setup {

/// Data of a deck on fatigue life: records 8.6.0 to 8.6.3 (kLifeCons 1), 8.6.4 to 8.6.6
/// (materials given in the deck), residual stresses and fatigue limit of record 9.0.
/// @throws InputError with all values that no model can use.
[[nodiscard]] bearing::LifeInputs build_life_inputs(const deck::Deck& deck,
                                                    const bearing::LifeChoices& choices = {});

}  // namespace adore::setup
