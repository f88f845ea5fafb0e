#pragma once

#include "adrinput/study_fields.hpp"
#include "deck/deck.hpp"

namespace adore::adrinput {

/// An example of a study (studies::example_study(), written for the ball deck in SI units), adapted
/// to another deck: variables that it does not have are removed, loads are in its load direction,
/// numbers are in its units.
[[nodiscard]] StudyJson adapt_example_to_deck(StudyJson example, const deck::Deck& deck);

}  // namespace adore::adrinput
