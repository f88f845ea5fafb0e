#pragma once

#include "bearing/grade_oil.hpp"
#include "deck/deck.hpp"

#include <optional>

namespace adore::setup {

/// kTrac of films and traction with the oil of record X2.
inline constexpr int kGradeOil = 21;

/// The oil of record X2; empty without this record. @throws InputError
[[nodiscard]] std::optional<bearing::OilByGrade> grade_oil_of(const deck::Deck& deck);

}  // namespace adore::setup
