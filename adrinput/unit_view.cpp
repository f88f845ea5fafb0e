#include "adrinput/unit_view.hpp"

#include "adrinput/typed.hpp"
#include "deck/unit_change.hpp"

#include <fmt/format.h>

namespace adore::adrinput {

QString value_in_other_units(const Document& document, const Cell& cell) {
  const deck::VariableSpec* variable = variable_of(cell);
  const deck::Deck& deck = document.deck();
  if (variable == nullptr || !deck::depends_on_units(deck, *variable)) return {};
  const TypedValue typed = parse_typed_text(deck, *variable, document.text(cell));
  const double* value = std::get_if<double>(&typed.value);
  if (typed.problem || value == nullptr) return {};
  const deck::UnitSystem other = deck::other_system(deck.units());
  const double converted = deck::convert_value(*value, variable->unit, deck.units(), other);
  return QString::fromStdString(
      fmt::format("{:.6g} {}", converted, deck::unit_name(deck, *variable, other)));
}

QString other_unit_system_name(const deck::Deck& deck) {
  return deck.units() == deck::UnitSystem::SI ? "English units" : "SI units";
}

}  // namespace adore::adrinput
