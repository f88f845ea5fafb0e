#include "base/counted.hpp"
#include "deck/check.hpp"
#include "deck/lookup.hpp"
#include "deck/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// Checks that need only the schema: which records, and the type of each value.
namespace adore::deck {
namespace {

Issue record_issue(const Deck& deck, std::string_view id, int line, std::string message,
                   std::string remedy) {
  Issue issue;
  issue.file = deck.file;
  issue.line = line;
  issue.record = id;
  issue.message = std::move(message);
  issue.remedy = std::move(remedy);
  return issue;
}

bool names_any(std::string_view condition, const std::set<std::string>& doubtful) {
  const std::vector<std::string_view> names = variable_names_in(condition);
  return std::any_of(names.begin(), names.end(),
                     [&](std::string_view name) { return doubtful.count(std::string(name)) > 0; });
}

/// Integer variables that conditions cannot rely on, because their value is missing or wrong.
std::set<std::string> doubtful_variables(const Deck& deck) {
  std::set<std::string> doubtful;
  for (const RecordData& data : deck.records) {
    const RecordSpec* spec = find_record(data.id);
    if (spec == nullptr || data.values.size() != spec->variables.size()) continue;
    for (std::size_t i = 0; i < spec->variables.size(); ++i)
      for (const Value& value : data.values[i])
        if (spec->variables[i].type == VarType::Integer &&
            !is_reliable_integer(spec->variables[i], value))
          doubtful.insert(std::string(spec->variables[i].name));
  }
  return doubtful;
}

class ValueCheck {
 public:
  ValueCheck(Checker& checker, const RecordData& data, const VariableSpec& variable)
      : checker_(checker), data_(data), variable_(variable) {}

  void check(const std::vector<Value>& elements) {
    const auto expected = static_cast<std::size_t>(array_length(checker_.deck(), variable_));
    if (elements.size() != expected) {
      report(Severity::Error, 0, {},
             fmt::format("has {}, but {} required", counted(elements.size(), "element"),
                         counted(expected, "is", "are")),
             "enter one value for each element");
      return;
    }
    for (std::size_t i = 0; i < elements.size(); ++i)
      check_element(elements[i], elements.size() > 1 ? static_cast<int>(i) + 1 : 0);
  }

 private:
  void report(Severity severity, int element, std::string value, std::string message,
              std::string remedy) {
    Issue issue =
        record_issue(checker_.deck(), data_.id, data_.line, std::move(message), std::move(remedy));
    issue.severity = severity;
    issue.variable = variable_.name;
    const RecordSpec* spec = find_record(data_.id);
    if (!spec->repeat.empty()) issue.variable += fmt::format("[{}]", data_.instance);
    if (element > 0) issue.variable += fmt::format("[{}]", element);
    issue.value = std::move(value);
    checker_.add(std::move(issue));
  }

  void check_element(const Value& value, int element) {
    if (checker_.is_reported(data_, variable_.name)) return;
    if (std::holds_alternative<std::monostate>(value)) {
      const bool label = variable_.name == "recID";
      if (is_extension(data_.id) && !label) return;  // not given
      report(label ? Severity::Warning : Severity::Error, element, {},
             "the value is missing and has no default",
             label ? fmt::format("write 'Rec {}'", data_.id) : suggestion());
      return;
    }
    const auto index = static_cast<std::size_t>(variable_.type == VarType::Integer ? 1
                                                : variable_.type == VarType::Real  ? 2
                                                                                   : 3);
    if (value.index() != index) {
      report(Severity::Error, element, value_text(value), "is of the wrong type", suggestion());
    } else if (const long long* integer = std::get_if<long long>(&value)) {
      check_integer(*integer, element);
    } else if (const double* real = std::get_if<double>(&value)) {
      check_real(*real, element);
    } else {
      check_text(std::get<std::string>(value), element);
    }
  }

  [[nodiscard]] std::string suggestion() const {
    const std::string codes = describe_codes(variable_);
    if (!codes.empty()) return "valid codes are " + codes;
    const std::string_view kind = variable_.type == VarType::Integer ? "an integer"
                                  : variable_.type == VarType::Real  ? "a number"
                                                                     : "a text in quotes";
    return "enter " +
           describe_value_in_range(kind, range_in_deck_units(checker_.deck(), variable_), unit());
  }

  [[nodiscard]] std::string_view unit() const {
    return checker_.deck().units() == UnitSystem::English ? variable_.unit.en : variable_.unit.si;
  }

  void check_integer(long long value, int element) {
    if (!is_valid_code(variable_, value))
      report(Severity::Error, element, fmt::format("{}", value), "this code does not exist",
             suggestion());
    else if (!is_in_range(variable_.range, static_cast<double>(value)))
      report(Severity::Error, element, fmt::format("{}", value), "is out of range",
             "enter " + describe_value_in_range("a value", variable_.range, {}));
  }

  void check_real(double value, int element) {
    const Range range = range_in_deck_units(checker_.deck(), variable_);
    if (is_in_range(range, value)) return;
    report(Severity::Error, element, format_real(value), "is out of range",
           "enter " + describe_value_in_range(std::isfinite(value) ? "a value" : "a finite number",
                                              range, unit()));
  }

  void check_text(const std::string& text, int element) {
    const bool printable = std::none_of(text.begin(), text.end(), [](char c) {
      return static_cast<unsigned char>(c) < 0x20 && c != '\t';
    });
    if (!printable)
      report(Severity::Error, element, {}, "contains a line break or another control character",
             "keep the text on one line");
    const auto longest = static_cast<std::size_t>(variable_.max_length);
    if (longest == 0 || text.size() <= longest) return;
    report(variable_.name == "recID" ? Severity::Warning : Severity::Error, element,
           value_text(text),
           fmt::format("is {} characters long, but at most {} are allowed", text.size(), longest),
           "shorten the text");
  }

  Checker& checker_;
  const RecordData& data_;
  const VariableSpec& variable_;
};

}  // namespace

void check_record_layout(Checker& checker, const ReportedErrors& reported) {
  const Deck& deck = checker.deck();
  std::set<std::string> doubtful = doubtful_variables(deck);
  doubtful.insert(reported.doubtful.begin(), reported.doubtful.end());
  std::size_t in_order = 0;  // records of the deck that are where the schema wants them
  for (const RecordSpec& spec : schema()) {
    if (spec.id == "12") continue;
    const bool required = evaluate(spec.condition, condition_scope(deck));
    const bool known = !names_any(spec.condition, doubtful) && !names_any(spec.repeat, doubtful);
    const int count = is_extension(spec.id) ? (deck.has_record(spec.id) ? 1 : 0)
                      : required            ? repeat_count(deck, spec)
                                            : 0;
    bool missing = false;
    for (int instance = 1; known && instance <= count && !missing; ++instance) {
      if (deck.has_record(spec.id, instance)) continue;
      missing = true;
      if (reported.missing_records.count({std::string(spec.id), instance}) > 0) continue;
      checker.add(record_issue(
          deck, spec.id, 0, fmt::format("the record ({}) is required but missing", spec.title),
          fmt::format("add the record, because the condition `{}` is met", spec.condition)));
    }
    if (missing)
      for (const VariableSpec& variable : spec.variables)
        if (variable.type == VarType::Integer) doubtful.insert(std::string(variable.name));
    for (; in_order < deck.records.size() && deck.records[in_order].id == spec.id; ++in_order) {
      const RecordData& data = deck.records[in_order];
      if (known && data.instance > count)
        checker.add(record_issue(
            deck, spec.id, data.line,
            count > 0
                ? fmt::format("the deck has more of these records than `{}` specifies", spec.repeat)
                : fmt::format("the record is not needed, because the condition `{}` is not met",
                              spec.condition),
            "remove the record, or change the option that it depends on"));
    }
  }
  if (in_order < deck.records.size()) {
    const RecordData& data = deck.records[in_order];
    checker.add(record_issue(
        deck, data.id, data.line,
        find_record(data.id) == nullptr ? "there is no such record" : "the record is out of order",
        "put the records in the order that `adore schema` lists"));
  }
}

void check_values(Checker& checker) {
  for (const RecordData& data : checker.deck().records) {
    const RecordSpec* spec = find_record(data.id);
    if (spec == nullptr) continue;
    if (data.values.size() != spec->variables.size()) {
      checker.add(
          record_issue(checker.deck(), data.id, data.line,
                       fmt::format("has {}, but {} are required",
                                   counted(data.values.size(), "variable"), spec->variables.size()),
                       "give all variables of the record"));
      continue;
    }
    for (std::size_t i = 0; i < spec->variables.size(); ++i)
      ValueCheck(checker, data, spec->variables[i]).check(data.values[i]);
  }
}

}  // namespace adore::deck
