#include "deck/defaults.hpp"

#include "deck/lookup.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::deck {
namespace {

/// What the chosen code means; empty for a variable without codes.
std::string_view meaning_of(const VariableSpec& variable, const std::string& code) {
  for (const OptionSpec& option : variable.options)
    if (option.code == code) return option.meaning;
  return {};
}

/// Does the code stand for something that the deck could have given instead?
bool stands_for_default(const VariableSpec& variable, const Value& value,
                        std::string_view meaning) {
  const auto* code = std::get_if<long long>(&value);
  if (code == nullptr || *code != 0 || meaning.empty()) return false;
  return variable.option_table == "@materials" || meaning.starts_with("default") ||
         meaning.starts_with("built-in");
}

}  // namespace

std::vector<DefaultUsed> defaults_used(const Deck& deck) {
  std::vector<DefaultUsed> list;
  const UnitSystem units = deck.units();
  for (const RecordData& record : deck.records) {
    const RecordSpec* spec = find_record(record.id);
    if (spec == nullptr) continue;
    for (std::size_t v = 1; v < record.values.size() && v < spec->variables.size(); ++v) {
      const VariableSpec& variable = spec->variables[v];
      for (std::size_t k = 0; k < record.values[v].size(); ++k) {
        const Value& value = record.values[v][k];
        std::string text = value_text(value);
        const std::string_view meaning = meaning_of(variable, text);
        const bool left_out = std::find(record.defaulted.begin(), record.defaulted.end(),
                                        RecordData::Element{v, k}) != record.defaulted.end();
        if (std::holds_alternative<std::monostate>(value) ||
            !(left_out || stands_for_default(variable, value, meaning)))
          continue;
        DefaultUsed used;
        used.record =
            spec->repeat.empty() ? record.id : fmt::format("{} ({})", record.id, record.instance);
        used.variable = record.values[v].size() == 1 && variable.length == "1"
                            ? std::string(variable.name)
                            : fmt::format("{}[{}]", variable.name, k + 1);
        used.value = meaning.empty() ? text : fmt::format("{} ({})", text, meaning);
        const std::string_view unit = units == UnitSystem::SI ? variable.unit.si : variable.unit.en;
        if (unit != "-") used.unit = unit;
        list.push_back(std::move(used));
      }
    }
  }
  return list;
}

}  // namespace adore::deck
