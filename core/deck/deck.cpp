#include "deck/deck.hpp"

#include "deck/lookup.hpp"

#include <fmt/format.h>

namespace adore::deck {
namespace {

/// find_value, entered in the deck's log.
const Value* read_value(const Deck& deck, std::string_view name, int instance, int index) {
  const Value* value = find_value(deck, name, instance, index);
  if (value != nullptr && deck.reads) {
    const VariableRef ref = find_present_variable(deck, name, instance);
    deck.reads->add(*find_record_data(deck, ref.record->id, instance), ref.position,
                    static_cast<std::size_t>(index) - 1);
  }
  return value;
}

}  // namespace

bool Deck::has_record(std::string_view id, int instance) const {
  return find_record_data(*this, id, instance) != nullptr;
}

bool Deck::has(std::string_view name) const {
  const Value* value = find_value(*this, name);
  return value != nullptr && !std::holds_alternative<std::monostate>(*value);
}

long long Deck::integer(std::string_view name, int index) const {
  const Value* value = read_value(*this, name, 1, index);
  const long long* integer = value == nullptr ? nullptr : std::get_if<long long>(value);
  return integer == nullptr ? 0 : *integer;
}

double Deck::real(std::string_view name, int instance, int index) const {
  if (const Value* value = read_value(*this, name, instance, index)) {
    if (const double* real = std::get_if<double>(value)) return *real;
    if (const long long* integer = std::get_if<long long>(value))
      return static_cast<double>(*integer);
  }
  throw InternalError(fmt::format("the deck does not contain a number for {}[{}] (instance {})",
                                  name, index, instance));
}

double Deck::si(std::string_view name, int instance, int index) const {
  const double value = real(name, instance, index);
  const VariableSpec& spec = find_present_variable(*this, name, instance).spec();
  if (!spec.unitless_when.empty() && evaluate(spec.unitless_when, condition_scope(*this)))
    return value;
  return value * (units() == UnitSystem::English ? spec.unit.en_factor : spec.unit.si_factor);
}

std::string Deck::text(std::string_view name) const {
  const Value* value = read_value(*this, name, 1, 1);
  const std::string* text = value == nullptr ? nullptr : std::get_if<std::string>(value);
  return text == nullptr ? std::string() : *text;
}

UnitSystem Deck::units() const {
  const Value* value = read_value(*this, "kUnit", 1, 1);
  return value != nullptr && *value == Value(2LL) ? UnitSystem::English : UnitSystem::SI;
}

Issue Deck::issue(Severity severity, std::string_view name, std::string message, std::string remedy,
                  int instance) const {
  Issue issue;
  issue.severity = severity;
  issue.file = file;
  issue.message = std::move(message);
  issue.remedy = std::move(remedy);
  issue.variable = name;
  const VariableRef ref = find_present_variable(*this, name, instance);
  if (ref.record == nullptr) return issue;
  const RecordData& data = *find_record_data(*this, ref.record->id, instance);
  issue.record = ref.record->id;
  issue.line = data.line;
  if (!ref.record->repeat.empty()) issue.variable += fmt::format("[{}]", instance);
  if (ref.position < data.values.size())
    for (const Value& value : data.values[ref.position])
      issue.value += (issue.value.empty() ? "" : ", ") + value_text(value);
  return issue;
}

bool ReadResult::ok() const {
  for (const Issue& issue : issues)
    if (issue.severity == Severity::Error) return false;
  return true;
}

}  // namespace adore::deck
