#pragma once

#include "adrinput/study_fields.hpp"
#include "deck/deck.hpp"

namespace adore::adrinput {

/// An example of a study (studies::example_study(), written for the ball deck in SI units) with
/// what another deck can vary: variables that it does not have are left out, loads are along the
/// direction that it is loaded in, numbers are in its units.
[[nodiscard]] StudyJson fitted_to(StudyJson example, const deck::Deck& deck);

}  // namespace adore::adrinput
