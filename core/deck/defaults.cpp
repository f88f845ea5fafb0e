#include "deck/defaults.hpp"

#include "deck/lookup.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::deck {
namespace {

/// Meaning of the chosen code; empty for a variable without codes.
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

bool contains(const RecordData& record, const RecordData::Element& at) {
  return std::find(record.defaulted.begin(), record.defaulted.end(), at) != record.defaulted.end();
}

std::string record_name(const RecordSpec& spec, const RecordData& record) {
  return spec.repeat.empty() ? record.id : fmt::format("{} ({})", record.id, record.instance);
}

std::string variable_name(const VariableSpec& variable, std::size_t elements, std::size_t element) {
  return elements == 1 && variable.length == "1"
             ? std::string(variable.name)
             : fmt::format("{}[{}]", variable.name, element + 1);
}

std::string_view unit_of(const VariableSpec& variable, UnitSystem units) {
  const std::string_view unit = units == UnitSystem::SI ? variable.unit.si : variable.unit.en;
  return unit == "-" ? std::string_view() : unit;
}

/// The record among those that the deck uses or keeps aside; nullptr when it never had it.
const RecordData* ever_given(const Deck& deck, const RecordData& record) {
  if (const RecordData* used = find_record_data(deck, record.id, record.instance)) return used;
  const auto kept = std::find_if(deck.shelf.begin(), deck.shelf.end(), [&](const RecordData& data) {
    return data.id == record.id && data.instance == record.instance;
  });
  return kept == deck.shelf.end() ? nullptr : &*kept;
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
        const bool left_out = contains(record, RecordData::Element{v, k});
        if (std::holds_alternative<std::monostate>(value) ||
            !(left_out || stands_for_default(variable, value, meaning)))
          continue;
        DefaultUsed used;
        used.record = record_name(*spec, record);
        used.variable = variable_name(variable, record.values[v].size(), k);
        used.value = meaning.empty() ? text : fmt::format("{} ({})", text, meaning);
        used.unit = unit_of(variable, units);
        list.push_back(std::move(used));
      }
    }
  }
  return list;
}

std::vector<Issue> added_defaults(const Deck& before, const Deck& after) {
  constexpr std::size_t kMaxNames = 12;
  std::vector<Issue> list;
  for (const RecordData& record : after.records) {
    const RecordSpec* spec = find_record(record.id);
    const RecordData* given = ever_given(before, record);
    if (spec == nullptr) continue;
    std::string values;
    std::size_t count = 0;
    for (const RecordData::Element& at : record.defaulted) {
      if (at.variable == 0 || (given != nullptr && contains(*given, at))) continue;
      if (++count > kMaxNames) continue;
      const VariableSpec& variable = spec->variables[at.variable];
      const std::vector<Value>& elements = record.values[at.variable];
      const std::string_view unit = unit_of(variable, after.units());
      values += fmt::format("{}{} = {}{}{}", values.empty() ? "" : ", ",
                            variable_name(variable, elements.size(), at.element),
                            value_text(elements[at.element]), unit.empty() ? "" : " ", unit);
    }
    if (count == 0) continue;
    if (count > kMaxNames) values += fmt::format(" and {} more", count - kMaxNames);
    Issue issue;
    issue.severity = Severity::Warning;
    issue.file = after.file;
    issue.line = record.line;
    issue.record = record_name(*spec, record);
    issue.message = fmt::format(
        "{}: {}",
        given == nullptr
            ? "was added with default values, because the changed options require this record"
            : "was completed with default values for missing variables",
        values);
    issue.remedy = "set the listed variables too, or write them into the deck";
    list.push_back(std::move(issue));
  }
  return list;
}

}  // namespace adore::deck
