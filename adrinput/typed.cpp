#include "adrinput/typed.hpp"

#include "deck/lookup.hpp"
#include "deck/quantity.hpp"
#include "deck/unit_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <regex>
#include <span>

namespace adore::adrinput {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at))
    text.replace(at, from.size(), to);
}

/// Without surrounding blanks, with a plain minus sign and a decimal point.
std::string plain_number(std::string_view typed) {
  std::string text(typed);
  replace_all(text, "\u2212", "-");
  replace_all(text, "\u00a0", " ");
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  text = text.substr(first, text.find_last_not_of(" \t") - first + 1);
  const auto commas = std::count(text.begin(), text.end(), ',');
  if (commas == 1 && text.find('.') == std::string::npos) text[text.find(',')] = '.';
  return text;
}

/// "10,000": ten with three decimals, or ten thousand. 0,125 and 1234,567 are not groups.
deck::NumberProblem thousands_or_decimals(std::string_view typed) {
  static const std::regex kGroup("(^|[^0-9.,])([1-9][0-9]{0,2}),([0-9]{3})(?![0-9.,eEdD])");
  std::cmatch found;
  if (!std::regex_search(typed.begin(), typed.end(), found, kGroup)) return {};
  return {"is ambiguous: the comma could be a decimal comma or a thousands separator",
          fmt::format("write {0}{1} or {0}.{1}", found.str(2), found.str(3))};
}

/// Values of records X, of which an empty field is "not given".
bool may_be_left_out(const deck::VariableSpec& variable) {
  const auto refs = deck::find_variable(variable.name);
  return !refs.empty() && deck::is_extension(refs.front().record->id);
}

TypedValue parse_string(std::string_view text) {
  const bool control = std::any_of(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f;
  });
  if (control)
    return {{}, {"contains a line break or another control character", "enter one line"}};
  return {std::string(text), {}};
}

/// Digits, a sign, digits: an exponent without its letter, or a difference.
bool could_be_difference(std::string_view number) {
  const std::size_t sign = number.find_first_of("+-", 1);
  return sign != std::string_view::npos && number.find_first_of("eEdD*/() ") == std::string::npos;
}

/// "1e-": a number that is not finished.
bool ends_in_exponent(std::string_view number) {
  const std::size_t e = number.find_last_of("eEdD");
  if (e == std::string_view::npos || e == 0) return false;
  const bool digits = number.find_first_not_of("+-.0123456789") == e;
  const std::string_view rest = number.substr(e + 1);
  return digits && (rest.empty() || rest == "+" || rest == "-");
}

std::string ending_of(const deck::VariableSpec& variable) {
  const std::string codes = deck::describe_codes(variable);
  return codes.empty() ? "" : "valid codes are " + codes;
}

}  // namespace

TypedValue parse_typed_text(const deck::VariableSpec& variable, std::string_view text) {
  const std::string number = plain_number(text);
  if (number.empty() && may_be_left_out(variable)) return {};
  if (variable.type == deck::VarType::String) return parse_string(text);
  const bool integer = variable.type == deck::VarType::Integer;
  if (deck::NumberProblem problem = thousands_or_decimals(text)) return {{}, problem};
  if (number.empty())
    return {{}, {"is missing", integer ? "enter an integer" : "enter a number such as 0.05"}};
  if (!integer) {
    double value = 0.0;
    deck::NumberProblem problem = deck::parse_real(number, value);
    return {value, std::move(problem)};
  }
  long long value = 0;
  if (deck::NumberProblem problem = deck::parse_integer(number, value)) return {{}, problem};
  if (!deck::is_valid_code(variable, value))
    return {{}, {"is an invalid code", ending_of(variable)}};
  if (!deck::is_in_range(variable.range, static_cast<double>(value)))
    return {{},
            {"is out of range",
             "enter " + deck::describe_value_in_range("a value", variable.range, {})}};
  return {value, {}};
}

TypedValue parse_typed_text(const deck::Deck& deck, const deck::VariableSpec& variable,
                            std::string_view text) {
  if (variable.type != deck::VarType::Real) return parse_typed_text(variable, text);
  const std::string number = plain_number(text);
  if (deck::NumberProblem problem = thousands_or_decimals(text)) return {{}, problem};
  double value = 0.0;
  const bool plain = !deck::parse_real(number, value);
  const bool words = number.find_first_of("0123456789") == std::string::npos;
  if (words || (plain && !could_be_difference(number))) return parse_typed_text(variable, text);
  if (plain) {
    const std::size_t sign = number.find_first_of("+-", 1);
    return {{},
            {"is ambiguous: it could be a power of ten or a sum",
             fmt::format("write {}e{} or {} {} {}", number.substr(0, sign), number.substr(sign),
                         number.substr(0, sign), number[sign], number.substr(sign + 1))}};
  }
  if (ends_in_exponent(number))
    return {{},
            {"has an incomplete exponent",
             fmt::format("write {}e-6 or {}", number.substr(0, number.find_last_of("eEdD")),
                         number.substr(0, number.find_last_of("eEdD")))}};
  const bool pure = unit_of(deck, variable).empty();  // by the deck's codes, or always
  const deck::UnitPair unit = pure ? deck::UnitPair{"-", "-"} : variable.unit;
  deck::NumberProblem problem = deck::parse_quantity(number, unit, deck.units(), value);
  return {value, std::move(problem)};
}

deck::NumberProblem check_product_ambiguity(std::string_view typed, std::size_t values) {
  static const std::regex kRepeat("([1-9][0-9]{0,3})[*]([-+]?[0-9.]+([eEdD][-+]?[0-9]+)?)");
  const std::string number = plain_number(typed);
  std::smatch found;
  if (!std::regex_match(number, found, kRepeat)) return {};
  const auto count = static_cast<std::size_t>(std::stoi(found.str(1)));
  if (count < 2 || count > values) return {};
  return {fmt::format("is ambiguous: it could be a product or, as in a deck, {} values", count),
          fmt::format("write {0}*{1} for the product, or {0} in each of the {1} fields",
                      found.str(2), found.str(1))};
}

bool is_run_time(const deck::VariableSpec& variable) {
  return variable.name == "fTime" || variable.name == "stpInit" || variable.name == "stpMin" ||
         variable.name == "stpMax";
}

std::string normalized_text(std::string_view typed) {
  const std::size_t first = typed.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  const std::string text(typed.substr(first, typed.find_last_not_of(" \t") - first + 1));
  std::string number = plain_number(typed);
  double value = 0.0;
  return deck::parse_real(number, value) ? text : number;
}

std::string shown_text(const deck::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return deck::value_text(value);
}

std::string unit_of(const deck::Deck& deck, const deck::VariableSpec& variable) {
  return std::string(deck::unit_name(deck, variable));
}

std::string limits_of(const deck::Deck& deck, const deck::VariableSpec& variable) {
  std::string out;
  if (variable.type == deck::VarType::String) {
    if (variable.max_length > 0) out = fmt::format("at most {} characters", variable.max_length);
  } else {
    deck::Range range = deck::range_in_deck_units(deck, variable);
    constexpr double kAnyInteger = 2147483647.0, kAnyReal = 1e6;  // never displayed
    const double far = variable.type == deck::VarType::Integer ? kAnyInteger : kAnyReal;
    if (range.min <= -far) range.min = -std::numeric_limits<double>::infinity();
    if (range.max >= far) range.max = std::numeric_limits<double>::infinity();
    out = deck::describe_range(range, {});
  }
  if (!variable.default_value.empty())
    out += fmt::format("{}default {}", out.empty() ? "" : " · ", variable.default_value);
  return out;
}

std::string meaning_of(const deck::VariableSpec& variable, std::string_view code) {
  const auto search = [&](std::span<const deck::OptionSpec> options) -> std::string {
    for (const deck::OptionSpec& option : options)
      if (option.code == code) return std::string(option.meaning);
    return {};
  };
  std::string meaning = search(variable.options);
  if (meaning.empty() && !variable.option_table.empty())
    meaning = search(deck::option_table(variable.option_table));
  return meaning;
}

}  // namespace adore::adrinput
