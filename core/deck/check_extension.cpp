#include "deck/check.hpp"

/// Records X: what contradicts the rest of the deck. The oil itself is checked where its law is
/// made (bearing/grade_oil.hpp).
namespace adore::deck {

void check_extension(Checker& checker) {
  const Deck& deck = checker.deck();
  const auto rating = [&](std::string_view name) { return checker.value_in_deck_units(name); };
  const auto C = rating("ratingC"), C0 = rating("ratingC0"), Cu = rating("ratingCu");
  if (Cu && ((C && *Cu >= *C) || (C0 && *Cu >= *C0)))
    checker.error("ratingCu", "is not below the load ratings C and C0",
                  "give the fatigue load limit (Pu or Cu in the bearing catalog)");
  constexpr long long kGradeOil = 21;
  const bool oil = deck.has("oilGrade") || deck.has("oilVisc1");
  const auto traction = checker.integer("kTrac");
  if (oil && traction && *traction != kGradeOil)
    checker.warning(
        deck.has("oilGrade") ? "oilGrade" : "oilVisc1",
        "is used only for the viscosity ratio of ISO 281, because kTrac does not select "
        "the oil of record X2",
        "set kTrac to 21 to compute films, traction and heat with this oil");
}

}  // namespace adore::deck
