#include "adrinput/sweep_range.hpp"

#include "adrinput/typed.hpp"
#include "adrinput/unit_choice.hpp"
#include "deck/lookup.hpp"

#include <QRegularExpression>
#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace adore::adrinput {
namespace {

constexpr long long kMostRuns = 100'000;  // as studies::run_sweep() has it

std::string trimmed_text(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()))
      .trimmed()
      .toStdString();
}

/// A number or arithmetic of numbers, and the unit behind it.
struct Parts {
  std::string number, unit;
};

Parts parts_of(const std::string& text) {
  static const QRegularExpression form(QString::fromUtf8(
      R"(^([-+\x{2212}\d.,\s*/()]*?[\d.)](?:[eEdD][-+\x{2212}]?\d+)?)\s*([^\d\s.,*/()+\x{2212}-].*)$)"));
  const auto match = form.match(QString::fromStdString(text));
  if (!match.hasMatch()) return {text, {}};
  return {match.captured(1).trimmed().toStdString(), match.captured(2).trimmed().toStdString()};
}

/// A value without a unit is in the unit of its neighbor.
std::string value_with_unit(const std::string& value, const std::string& unit) {
  if (unit.empty() || !parts_of(value).unit.empty()) return value;
  const bool sum =
      value.find_first_of("+-*/(", value.find_first_of("0123456789.")) != std::string::npos;
  return (sum ? "(" + value + ")" : value) + " " + unit;
}

std::string name_in(std::string_view text) { return trimmed_text(text.substr(0, text.find('='))); }

/// The variable in a deck that has it; no value for other names.
std::optional<Cell> cell_named(const Document& document, const std::string& name) {
  const deck::VariableRef ref =
      deck::find_present_variable(document.deck(), name.substr(0, name.find('[')));
  if (ref.record == nullptr) return {};
  return Cell{std::string(ref.record->id), 1, ref.position, 0};
}

std::string told_value(const Document& document, const Cell& cell, const std::string& value) {
  const std::string unit = unit_of(document.deck(), *variable_of(cell));
  return value + (unit.empty() ? "" : " " + unit);
}

std::string value_in(const Document& document, const Cell& cell, const std::string& text,
                     const std::string& whole) {
  const TypedValue typed = document.parse(cell, add_display_unit(document, cell, text));
  if (!typed.problem) {
    std::string value = shown_text(typed.value);
    if (value.size() > 2 && value.ends_with(".0")) value.resize(value.size() - 2);
    return value;
  }
  throw InputError(
      fmt::format("{}: \"{}\" {}; {}", whole, text, typed.problem.message, typed.problem.remedy));
}

}  // namespace

SweepRange parse_sweep_range(const Document& document, std::string_view text) {
  const std::string whole = trimmed_text(text), name = name_in(text);
  const std::string form =
      "write variable=first:last:runs, e.g. appLoadZ=500:1500:5 or appLoadZ=0.5 kN:1.5 kN:5";
  const std::string range =
      trimmed_text(text.substr(std::min(text.find('='), text.size() - 1) + 1));
  const std::size_t a = range.find(':'), b = range.rfind(':');
  if (std::count(text.begin(), text.end(), '=') != 1 || a == b ||
      std::count(range.begin(), range.end(), ':') != 2)
    throw InputError(fmt::format("\"{}\" does not define a sweep; {}", whole, form));
  const std::optional<Cell> cell = cell_named(document, name);
  if (!cell)
    throw InputError(fmt::format(
        "{}: this deck has no variable \"{}\"; search for variables with Ctrl+F", whole, name));
  if (variable_of(*cell)->type == deck::VarType::String)
    throw InputError(fmt::format("{}: {} is a text variable; a sweep needs a variable with numbers",
                                 whole, name));

  std::string first = trimmed_text(range.substr(0, a)),
              last = trimmed_text(range.substr(a + 1, b - a - 1));
  const Parts runs = parts_of(trimmed_text(range.substr(b + 1)));
  long long count = 0;
  if (deck::parse_integer(runs.number, count) || count < 2 || count > kMostRuns)
    throw InputError(fmt::format(
        "{}: the number of runs (after the second colon) is \"{}\"; enter an integer from 2 to {}",
        whole, runs.number, kMostRuns));
  std::string unit = runs.unit;
  if (unit.empty()) unit = parts_of(last).unit;
  if (unit.empty()) unit = parts_of(first).unit;
  first = value_in(document, *cell, value_with_unit(first, unit), whole);
  last = value_in(document, *cell, value_with_unit(last, unit), whole);
  return {fmt::format("{}={}:{}:{}", name, first, last, count),
          fmt::format("{} from {} to {}, {} runs", name, told_value(document, *cell, first),
                      told_value(document, *cell, last), count)};
}

std::string sweep_unit(const Document& document, std::string_view text) {
  const std::optional<Cell> cell = cell_named(document, name_in(text));
  if (!cell) return {};
  const std::string meant = add_display_unit(document, *cell, "1");
  return meant == "1" ? unit_of(document.deck(), *variable_of(*cell)) : meant.substr(2);
}

}  // namespace adore::adrinput
