#include "deck/no_part.hpp"

#include "deck/lookup.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::deck {
namespace {

bool any_read(const Deck& deck, const RecordData& record) {
  for (std::size_t v = 1; v < record.values.size(); ++v)
    for (std::size_t k = 0; k < record.values[v].size(); ++k)
      if (deck.reads->has(record, v, k)) return true;
  return false;
}

/// An option also acts through the records that it brings in, or keeps out at its default code.
bool acts_on_records(const Deck& deck, const VariableSpec& option, bool at_default) {
  bool decides = false, brings = false;
  for (const RecordSpec& spec : schema()) {
    const std::vector<std::string_view> names = variable_names_in(spec.condition);
    if (spec.repeat != option.name &&
        std::find(names.begin(), names.end(), option.name) == names.end())
      continue;
    decides = true;
    for (const RecordData& record : deck.records) {
      if (record.id != spec.id) continue;
      if (any_read(deck, record)) return true;
      brings = true;
    }
  }
  return decides && !brings && at_default;
}

}  // namespace

std::vector<NoPart> values_not_read(const Deck& deck) {
  std::vector<NoPart> out;
  if (!deck.reads) return out;
  for (const RecordData& record : deck.records) {
    const RecordSpec& spec = *find_record(record.id);
    for (std::size_t v = 1; v < record.values.size(); ++v)  // after the label
      for (std::size_t k = 0; k < record.values[v].size(); ++k) {
        const Value& value = record.values[v][k];
        if (deck.reads->has(record, v, k) || std::holds_alternative<std::monostate>(value))
          continue;
        const VariableSpec& variable = spec.variables[v];
        std::string name(variable.name);
        if (!spec.repeat.empty()) name += fmt::format("[{}]", record.instance);
        if (variable.length != "1") name += fmt::format("[{}]", k + 1);
        const bool option = !variable.options.empty() || !variable.option_table.empty();
        const bool at_default = value == default_value(variable);
        if (option && acts_on_records(deck, variable, at_default)) continue;
        out.push_back(
            {std::string(spec.id), std::move(name), value_text(value), {}, option && !at_default});
      }
  }
  // Records that were given and that the options do not ask for.
  for (const RecordData& record : deck.shelf) {
    const RecordSpec& spec = *find_record(record.id);
    for (std::size_t v = 1; v < std::min(record.values.size(), spec.variables.size()); ++v)
      for (std::size_t k = 0; k < record.values[v].size(); ++k) {
        const Value& value = record.values[v][k];
        const VariableSpec& variable = spec.variables[v];
        if (std::holds_alternative<std::monostate>(value) || value == default_value(variable) ||
            deck.reads->has(record, v, k))
          continue;
        std::string name(variable.name);
        if (!spec.repeat.empty()) name += fmt::format("[{}]", record.instance);
        if (variable.length != "1") name += fmt::format("[{}]", k + 1);
        out.push_back(
            {std::string(spec.id), std::move(name), value_text(value),
             fmt::format("the record is not needed, because the condition `{}` is not met",
                         spec.condition),
             !variable.options.empty() || !variable.option_table.empty()});
      }
  }
  return out;
}

}  // namespace adore::deck
