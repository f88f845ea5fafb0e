#pragma once

#include "deck/deck.hpp"
#include "deck/number.hpp"

#include <string>
#include <string_view>

/// Conversion of typed texts to values of the deck, and back, independent of the locale. No Qt.
namespace adore::adrinput {

struct TypedValue {
  deck::Value value;            ///< without errors
  deck::NumberProblem problem;  ///< continues "the value ..."
};

/// Accepts a decimal comma ("0,05") and a typographic minus sign. An invalid integer (code, range)
/// is an error here, because other records depend on it; a real number out of range is a value,
/// which the checks of the deck judge.
[[nodiscard]] TypedValue parse_typed_text(const deck::VariableSpec& variable,
                                          std::string_view text);

/// The same for a field of a deck, which also accepts quantities with units and arithmetic
/// (deck/quantity.hpp): "12.7 mm", "3*0.005". "5-3", which Fortran reads as 5e-3, is rejected.
[[nodiscard]] TypedValue parse_typed_text(const deck::Deck& deck,
                                          const deck::VariableSpec& variable,
                                          std::string_view text);

/// "3*0.0001" in a vector with three values from there on: ambiguous between a product and, as in
/// decks, three values. No problem if there are fewer.
[[nodiscard]] deck::NumberProblem check_product_ambiguity(std::string_view typed,
                                                          std::size_t values);

/// Is it a time of a run, in units of the time scale: fTime, stpInit, stpMin, stpMax?
[[nodiscard]] bool is_run_time(const deck::VariableSpec& variable);

/// A text without surrounding blanks; numbers get a plain minus sign and a decimal point.
[[nodiscard]] std::string normalized_text(std::string_view typed);

/// A value as a field shows it: shortest text that reads back the same, decimal point; "" for a
/// missing one.
[[nodiscard]] std::string shown_text(const deck::Value& value);

/// "m", "lbf.in"; "" for pure numbers, codes, and where this deck's codes make it a pure number.
[[nodiscard]] std::string unit_of(const deck::Deck& deck, const deck::VariableSpec& variable);

/// Valid range and default in the deck's units: "above 0 m · default 0.5"; "" without both.
[[nodiscard]] std::string limits_of(const deck::Deck& deck, const deck::VariableSpec& variable);

/// Meaning of a code; "" for a variable without codes or an unknown one.
[[nodiscard]] std::string meaning_of(const deck::VariableSpec& variable, std::string_view code);

}  // namespace adore::adrinput
