#include "deck/unit_change.hpp"

#include "deck/lookup.hpp"
#include "deck/number.hpp"

#include <algorithm>
#include <cmath>

namespace adore::deck {
namespace {

constexpr int kTypedDigits = 9;       // digits of numbers that people type
constexpr int kConvertedDigits = 12;  // digits of what comes of them
constexpr int kMaxDigits = 15;        // that a double keeps

bool is_pure_number(const Deck& deck, const VariableSpec& variable) {
  return !variable.unitless_when.empty() && evaluate(variable.unitless_when, condition_scope(deck));
}

double factor(const UnitPair& unit, UnitSystem system) {
  return system == UnitSystem::English ? unit.en_factor : unit.si_factor;
}

bool has_digits(double value, int digits) { return rounded_to_digits(value, digits) == value; }

}  // namespace

bool depends_on_units(const Deck& deck, const VariableSpec& variable) {
  return variable.type == VarType::Real && variable.unit.si_factor != variable.unit.en_factor &&
         !is_pure_number(deck, variable);
}

std::string_view unit_name(const Deck& deck, const VariableSpec& variable) {
  return unit_name(deck, variable, deck.units());
}

std::string_view unit_name(const Deck& deck, const VariableSpec& variable, UnitSystem units) {
  const std::string_view unit = units == UnitSystem::English ? variable.unit.en : variable.unit.si;
  return unit == "-" || is_pure_number(deck, variable) ? std::string_view() : unit;
}

double convert_value(double value, const UnitPair& unit, UnitSystem from, UnitSystem to) {
  const double a = factor(unit, from), b = factor(unit, to);
  const double exact = value * a / b;
  if (a == b || value == 0.0 || !std::isfinite(exact) || exact == 0.0) return value;
  // A short number whose conversion is `value`: what was typed in the other system.
  for (int digits = 1; digits <= kTypedDigits; ++digits) {
    const double candidate = rounded_to_digits(exact, digits);
    if (rounded_to_digits(candidate * b / a, kConvertedDigits) == value) return candidate;
  }
  if (has_digits(value, kTypedDigits)) return rounded_to_digits(exact, kConvertedDigits);
  for (int digits = kTypedDigits + 1; digits <= kMaxDigits; ++digits) {
    const double candidate = rounded_to_digits(exact, digits);
    if (candidate * b / a == value) return candidate;
  }
  return exact;
}

void convert_values(RecordData& record, const Deck& context, UnitSystem from, UnitSystem to) {
  const RecordSpec* spec = find_record(record.id);
  if (spec == nullptr) return;
  for (std::size_t v = 0; v < std::min(record.values.size(), spec->variables.size()); ++v) {
    const VariableSpec& variable = spec->variables[v];
    if (!depends_on_units(context, variable)) continue;
    for (Value& value : record.values[v])
      if (double* real = std::get_if<double>(&value))
        *real = convert_value(*real, variable.unit, from, to);
  }
}

Deck in_units(const Deck& deck, UnitSystem to) {
  const UnitSystem from = deck.units();
  if (from == to) return deck;
  Deck out = deck;
  for (RecordData& record : out.records) convert_values(record, deck, from, to);
  // Values of unused options are returned in the units of the deck.
  Deck all = deck;
  all.records.insert(all.records.end(), deck.shelf.begin(), deck.shelf.end());
  for (RecordData& record : out.shelf) convert_values(record, all, from, to);
  out.set("kUnit", to == UnitSystem::English ? "2" : "1");
  return out;
}

}  // namespace adore::deck
