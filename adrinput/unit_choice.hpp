#pragma once

#include "adrinput/document.hpp"

#include <QString>

#include <string_view>
#include <vector>

/// Display unit of each kind of quantity. The deck keeps its units.
namespace adore::adrinput {

/// A kind of quantity that has more than one usual unit.
struct Quantity {
  std::string_view si;  ///< the deck's unit in SI, which names the kind
  QString name;         ///< "Lengths"
};
[[nodiscard]] const std::vector<Quantity>& quantities_with_unit_choice();

/// The unit chosen for a kind; empty: that of the deck.
[[nodiscard]] QString chosen_unit(std::string_view si);
void choose_unit(std::string_view si, const QString& unit);

/// The display unit of a variable, chosen or that of the deck; "" for pure numbers.
[[nodiscard]] QString display_unit(const Document& document, const deck::VariableSpec& variable);

/// Content of a field: "12.7 mm" if millimeters are selected, else the number of the deck, or the
/// text that is not a number.
[[nodiscard]] QString shown_value(const Document& document, const Cell& cell);

/// "appLoadX = 3 kN" if a display unit is chosen for the variable; else empty.
[[nodiscard]] QString name_and_value(const Document& document, const Cell& cell);

/// Meaning of a text typed in the field of shown_value(): a number without a unit is in the unit of
/// the field, "3" is "3 kN".
[[nodiscard]] std::string add_display_unit(const Document& document, const Cell& cell,
                                           const std::string& typed);

/// A time of a run in seconds and revolutions: "0.0256 s = 4.27 revolutions"; empty if unknown.
[[nodiscard]] QString run_time_text(const Document& document, const Cell& cell);
/// Reason why a run makes no steps: "maxStps is 0: no motion".
[[nodiscard]] QString no_steps_reason(const Document& document, const Cell& cell);

/// For a typed text that is not a number in the unit of the deck: its value in the deck, "0.0127
/// m". Empty while it is incomplete.
[[nodiscard]] QString typed_value_text(const Document& document, const Cell& cell);

}  // namespace adore::adrinput
