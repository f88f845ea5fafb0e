#pragma once

#include "deck/deck.hpp"
#include "deck/number.hpp"

#include <string>
#include <string_view>

/// From what a person types to a value of the deck, and back. The user's locale plays no part. No
/// Qt.
namespace adore::adrinput {

struct Typed {
  deck::Value value;            ///< when there is no problem
  deck::NumberProblem problem;  ///< continues "the value ..."
};

/// Understands a decimal comma ("0,05") and a typographic minus sign. An integer that the variable
/// does not know (code, range) is a problem here, since other records depend on it; a real out of
/// range is a value, which the deck's checks judge.
[[nodiscard]] Typed parse_typed(const deck::VariableSpec& variable, std::string_view text);

/// The same for a field of a deck, which also accepts quantities with units and arithmetic
/// (deck/quantity.hpp): "12.7 mm", "3*0.005". "5-3", which Fortran reads as 5e-3, is rejected.
[[nodiscard]] Typed parse_typed(const deck::Deck& deck, const deck::VariableSpec& variable,
                                std::string_view text);

/// "3*0.0001" in a vector that has three values from there on: a product, or, as decks are written,
/// three values. No problem where there are fewer.
[[nodiscard]] deck::NumberProblem product_or_values(std::string_view typed, std::size_t values);

/// Is it a time of a run, in units of the time scale: fTime, stpInit, stpMin, stpMax?
[[nodiscard]] bool is_run_time(const deck::VariableSpec& variable);

/// A text without blanks around it; a number in it gets a plain minus sign and a decimal point.
[[nodiscard]] std::string plain_text(std::string_view typed);

/// A value as a field shows it: shortest text that reads back the same, decimal point; "" for a
/// missing one.
[[nodiscard]] std::string shown_text(const deck::Value& value);

/// "m", "lbf.in"; "" for pure numbers, codes, and where this deck's codes make it a pure number.
[[nodiscard]] std::string unit_of(const deck::Deck& deck, const deck::VariableSpec& variable);

/// Valid range and default in the deck's units: "above 0 m · default 0.5"; "" when there is
/// neither.
[[nodiscard]] std::string limits_of(const deck::Deck& deck, const deck::VariableSpec& variable);

/// Meaning of a code; "" for a variable without codes or an unknown one.
[[nodiscard]] std::string meaning_of(const deck::VariableSpec& variable, std::string_view code);

}  // namespace adore::adrinput
