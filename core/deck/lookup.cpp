#include "deck/lookup.hpp"

#include "deck/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace adore::deck {
namespace {

constexpr long long kMaxElements =
    12000;  // of an array or a repeated record: more than any range of the schema allows

/// A count of the schema: a number, or the integer variable that holds it.
long long count_of(const Deck& deck, std::string_view count) {
  long long number = 0;
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), number);
  if (error == std::errc() && end == count.data() + count.size()) return number;
  return deck.integer(count);
}

bool matches(const OptionSpec& option, std::span<const OptionSpec> all, long long code) {
  long long number = 0;
  if (option.code != "n" && option.code != "-n")
    return std::from_chars(option.code.data(), option.code.data() + option.code.size(), number)
                   .ec == std::errc() &&
           number == code;
  long long smallest = 0;
  long long largest = 0;
  for (const OptionSpec& other : all)
    if (std::from_chars(other.code.data(), other.code.data() + other.code.size(), number).ec ==
        std::errc()) {
      smallest = std::min(smallest, number);
      largest = std::max(largest, number);
    }
  return option.code == "n" ? code > largest : code < smallest;
}

}  // namespace

bool has_values(const RecordData& record) {
  for (std::size_t v = 1; v < record.values.size(); ++v)
    for (const Value& value : record.values[v])
      if (!std::holds_alternative<std::monostate>(value)) return true;
  return false;
}

const RecordData* find_record_data(const Deck& deck, std::string_view id, int instance) {
  const auto found = std::find_if(
      deck.records.begin(), deck.records.end(),
      [&](const RecordData& record) { return record.instance == instance && record.id == id; });
  return found == deck.records.end() ? nullptr : &*found;
}

VariableRef find_present_variable(const Deck& deck, std::string_view name, int instance) {
  for (const VariableRef& ref : find_variable(name))
    if (find_record_data(deck, ref.record->id, instance) != nullptr) return ref;
  return {};
}

const Value* find_value(const Deck& deck, std::string_view name, int instance, int index) {
  const VariableRef ref = find_present_variable(deck, name, instance);
  if (ref.record == nullptr) return nullptr;
  const RecordData& data = *find_record_data(deck, ref.record->id, instance);
  if (ref.position >= data.values.size()) return nullptr;
  const std::vector<Value>& elements = data.values[ref.position];
  const auto position = static_cast<std::size_t>(index) - 1;
  return position < elements.size() ? &elements[position] : nullptr;
}

ConditionScope condition_scope(const Deck& deck) {
  ConditionScope scope;
  scope.integer = [&deck](std::string_view name) {
    const Value* value = find_value(deck, name);
    const long long* integer = value == nullptr ? nullptr : std::get_if<long long>(value);
    return integer == nullptr ? 0 : *integer;
  };
  scope.array = [&deck](std::string_view name) {
    std::vector<long long> items;
    const VariableRef ref = find_present_variable(deck, name);
    if (ref.record == nullptr) return items;
    const RecordData& data = *find_record_data(deck, ref.record->id);
    if (ref.position >= data.values.size()) return items;
    for (const Value& value : data.values[ref.position])
      if (const long long* item = std::get_if<long long>(&value)) items.push_back(*item);
    return items;
  };
  return scope;  // user() stays 0: the deck does not know the user routines
}

int array_length(const Deck& deck, const VariableSpec& variable) {
  return static_cast<int>(std::clamp(count_of(deck, variable.length), 0LL, kMaxElements));
}

int repeat_count(const Deck& deck, const RecordSpec& record) {
  if (record.repeat.empty()) return 1;
  return static_cast<int>(std::clamp(count_of(deck, record.repeat), 0LL, kMaxElements));
}

std::string value_text(const Value& value) {
  if (const long long* integer = std::get_if<long long>(&value)) return fmt::format("{}", *integer);
  if (const double* real = std::get_if<double>(&value)) return format_real(*real);
  if (const std::string* text = std::get_if<std::string>(&value)) {
    std::string out = "'";
    for (const char c : *text) {
      out += c;
      if (c == '\'') out += c;
    }
    return out + "'";
  }
  return {};
}

bool is_valid_code(const VariableSpec& variable, long long code) {
  if (variable.options.empty() && variable.option_table.empty()) return true;
  const auto any = [code](std::span<const OptionSpec> options) {
    return std::any_of(options.begin(), options.end(),
                       [&](const OptionSpec& option) { return matches(option, options, code); });
  };
  return any(variable.options) ||
         (!variable.option_table.empty() && any(option_table(variable.option_table)));
}

Range range_in_deck_units(const Deck& deck, const VariableSpec& variable) {
  Range range = variable.range;
  if (deck.units() == UnitSystem::English) {
    const double factor = variable.unit.si_factor / variable.unit.en_factor;
    range.min *= factor;
    range.max *= factor;
  }
  return range;
}

bool is_in_range(const Range& range, double value) {
  return std::isfinite(value) && (range.max_exclusive ? value < range.max : value <= range.max) &&
         (range.min_exclusive ? value > range.min : value >= range.min);
}

bool is_reliable_integer(const VariableSpec& variable, const Value& value) {
  const long long* integer = std::get_if<long long>(&value);
  return integer != nullptr && is_valid_code(variable, *integer) &&
         is_in_range(variable.range, static_cast<double>(*integer));
}

std::string describe_codes(const VariableSpec& variable) {
  std::string out;
  const auto add = [&out](const OptionSpec& option, bool with_meaning) {
    if (!out.empty()) out += ", ";
    out += option.code == "n"    ? "a larger number"
           : option.code == "-n" ? "any negative number"
                                 : std::string(option.code);
    if (with_meaning) out += fmt::format(" ({})", option.meaning);
  };
  for (const OptionSpec& option : variable.options) add(option, variable.options.size() <= 8);
  if (!variable.option_table.empty())
    for (const OptionSpec& option : option_table(variable.option_table)) add(option, false);
  return out;
}

std::string describe_range(const Range& range, std::string_view unit) {
  const std::string suffix = unit.empty() || unit == "-" ? "" : fmt::format(" {}", unit);
  if (std::isfinite(range.min) && std::isfinite(range.max) && !range.min_exclusive &&
      !range.max_exclusive)
    return fmt::format("{:.10g} to {:.10g}{}", range.min, range.max, suffix);
  std::string out;
  if (std::isfinite(range.min))
    out =
        fmt::format("{} {:.10g}{}", range.min_exclusive ? "above" : "at least", range.min, suffix);
  if (std::isfinite(range.max))
    out += fmt::format("{}{} {:.10g}{}", out.empty() ? "" : " and ",
                       range.max_exclusive ? "below" : "at most", range.max, suffix);
  return out;
}

std::string describe_value_in_range(std::string_view what, const Range& range,
                                    std::string_view unit) {
  const std::string text = describe_range(range, unit);
  if (text.empty()) return std::string(what);
  const bool exclusive = text.starts_with("above") || text.starts_with("below");
  const std::string_view link = exclusive ? "" : text.starts_with("at ") ? "of " : "from ";
  return fmt::format("{} {}{}", what, link, text);
}

Value default_value(const VariableSpec& variable) {
  if (variable.type == VarType::String) return std::string(variable.default_value);
  if (variable.type == VarType::Real) {
    double value = 0.0;
    if (!variable.default_value.empty() && parse_real(variable.default_value, value))
      throw InternalError(fmt::format("the default of {} is not a number", variable.name));
    return value;
  }
  long long value = 0;
  if (!variable.default_value.empty() && parse_integer(variable.default_value, value))
    throw InternalError(fmt::format("the default of {} is not an integer", variable.name));
  if (variable.default_value.empty() && !is_valid_code(variable, 0))
    parse_integer(variable.options.front().code, value);
  return value;
}

std::string default_label(const RecordSpec& spec, int instance) {
  if (spec.repeat.empty()) return fmt::format("Rec {}", spec.id);
  return fmt::format("Rec {}.{}", spec.id.substr(0, spec.id.rfind('.')), instance);
}

void fill_with_defaults(Deck& deck, std::size_t position) {
  RecordData& data = deck.records[position];
  const RecordSpec& spec = *find_record(data.id);
  data.values.resize(spec.variables.size());
  if (data.values[0].empty()) data.values[0].emplace_back(default_label(spec, data.instance));
  for (std::size_t i = 0; i < spec.variables.size(); ++i) {  // a count stands before its array
    const auto length = static_cast<std::size_t>(array_length(deck, spec.variables[i]));
    if (is_extension(spec.id) && i > 0) {
      data.values[i].resize(length);
      continue;
    }
    for (std::size_t k = data.values[i].size(); k < length; ++k) data.defaulted.push_back({i, k});
    data.values[i].resize(length, default_value(spec.variables[i]));
  }
  std::erase_if(data.defaulted, [&](const RecordData::Element& at) {
    return at.variable >= data.values.size() || at.element >= data.values[at.variable].size();
  });
}

}  // namespace adore::deck
