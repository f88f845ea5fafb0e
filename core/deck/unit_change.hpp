#pragma once

#include "deck/deck.hpp"

/// Values of a deck in the other system of units.
namespace adore::deck {

[[nodiscard]] constexpr UnitSystem other_system(UnitSystem units) {
  return units == UnitSystem::SI ? UnitSystem::English : UnitSystem::SI;
}

/// Does the number of this variable depend on kUnit? False for integers, texts, pure numbers and
/// units that both systems share, and where codes of `deck` make it a pure number.
[[nodiscard]] bool depends_on_units(const Deck& deck, const VariableSpec& variable);

/// "m", "lbf.in" in the units of this deck; empty for pure numbers, codes and texts.
[[nodiscard]] std::string_view unit_name(const Deck& deck, const VariableSpec& variable);
[[nodiscard]] std::string_view unit_name(const Deck& deck, const VariableSpec& variable,
                                         UnitSystem units);

/// The value of a quantity in another system. Twelve digits, or fewer where those convert back to
/// `value`; a value that was typed with at most 15 digits comes back from the other system as it
/// was.
[[nodiscard]] double convert_value(double value, const UnitPair& unit, UnitSystem from,
                                   UnitSystem to);

/// Converts the values of one record. Codes that make a value a pure number are those of `context`.
void convert_values(RecordData& record, const Deck& context, UnitSystem from, UnitSystem to);

/// The same bearing in the other system of units: kUnit and every value that depends on it. Lines
/// of user routines stay as they are, since nobody but the routine knows what they mean.
[[nodiscard]] Deck in_units(const Deck& deck, UnitSystem to);

}  // namespace adore::deck
