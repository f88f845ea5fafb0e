#pragma once

#include "adrinput/document.hpp"

#include <QString>

#include <string_view>
#include <vector>

/// Which unit a person wants to read each kind of quantity in. The deck keeps its own.
namespace adore::adrinput {

/// A kind of quantity that has more than one usual unit.
struct Quantity {
  std::string_view si;  ///< the deck's unit in SI, which names the kind
  QString name;         ///< "Lengths"
};
[[nodiscard]] const std::vector<Quantity>& quantities_with_a_choice();

/// The unit chosen for a kind; empty for the deck's own.
[[nodiscard]] QString chosen_unit(std::string_view si);
void choose_unit(std::string_view si, const QString& unit);

/// The unit that values of a variable are shown in, chosen or the deck's own; "" for pure numbers.
[[nodiscard]] QString shown_unit(const Document& document, const deck::VariableSpec& variable);

/// Content of a field: "12.7 mm" if millimeters are selected, else the number of the deck, or the
/// text that is not a number.
[[nodiscard]] QString shown_value(const Document& document, const Cell& cell);

/// "appLoadX = 3 kN" where a unit of view is chosen for the variable; else empty.
[[nodiscard]] QString named_value(const Document& document, const Cell& cell);

/// Meaning of a text typed in the field of shown_value(): a number without a unit is in the unit of
/// the field, "3" is "3 kN".
[[nodiscard]] std::string as_meant(const Document& document, const Cell& cell,
                                   const std::string& typed);

/// Of a time of a run what it is in seconds and turns: "0.0256 s = 4.27 revolutions"; empty while
/// nobody knows.
[[nodiscard]] QString run_time(const Document& document, const Cell& cell);
/// Of the end of a run that no step comes near, why: "maxStps is 0: no step is made".
[[nodiscard]] QString no_run_time(const Document& document, const Cell& cell);

/// For a typed text that is not a number in the unit of the deck: its value in the deck, "0.0127
/// m". Empty while it is incomplete.
[[nodiscard]] QString typed_value(const Document& document, const Cell& cell);

}  // namespace adore::adrinput
