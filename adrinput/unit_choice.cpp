#include "adrinput/unit_choice.hpp"

#include "adrinput/settings.hpp"
#include "adrinput/typed.hpp"
#include "base/counted.hpp"
#include "deck/quantity.hpp"
#include "deck/unit_change.hpp"
#include "runs/unused_request.hpp"

#include <QRegularExpression>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>

namespace adore::adrinput {
namespace {

QString key_of(std::string_view si) {
  QString name = QString::fromUtf8(si.data(), static_cast<qsizetype>(si.size()));
  return "units/" + name.replace('/', " per ");  // a slash would make a group of settings
}

/// As the settings have them: every cell of every table asks.
std::map<std::string, QString, std::less<>>& choices() {
  static std::map<std::string, QString, std::less<>> known;
  return known;
}

}  // namespace

const std::vector<Quantity>& quantities_with_unit_choice() {
  static const std::vector<Quantity> list = {{"m", "&Lengths"},
                                             {"deg", "&Angles"},
                                             {"rpm", "&Rotation speeds"},
                                             {"m/s", "&Speeds"},
                                             {"N", "&Forces"},
                                             {"N.m", "&Moments"},
                                             {"N/m^2", "S&tresses and moduli"},
                                             {"K", "Tem&peratures"},
                                             {"kg", "Mass&es"},
                                             {"kg.m^2", "Moments of &inertia"},
                                             {"kg/m^3", "&Densities"},
                                             {"N.s/m^2", "&Viscosities"},
                                             {"m^3/s", "Flo&ws"}};
  return list;
}

QString chosen_unit(std::string_view si) {
  const auto known = choices().find(si);
  if (known != choices().end()) return known->second;
  const QString unit = settings().value(key_of(si)).toString();
  choices()[std::string(si)] = unit;
  return unit;
}

void choose_unit(std::string_view si, const QString& unit) {
  choices()[std::string(si)] = unit;
  QSettings store("Adore", "adrinput");
  if (unit.isEmpty())
    store.remove(key_of(si));
  else
    store.setValue(key_of(si), unit);
}

namespace {

/// The display unit of a variable; empty: that of the deck.
QString unit_in_view(const Document& document, const deck::VariableSpec& variable) {
  if (deck::unit_name(document.deck(), variable).empty()) return {};
  const QString unit = chosen_unit(variable.unit.si);
  const auto usual = deck::usual_units(variable.unit);
  const bool known = std::find(usual.begin(), usual.end(), unit.toStdString()) != usual.end();
  return known ? unit : QString();
}

}  // namespace

QString display_unit(const Document& document, const deck::VariableSpec& variable) {
  const QString chosen = unit_in_view(document, variable);
  return chosen.isEmpty() ? QString::fromStdString(unit_of(document.deck(), variable)) : chosen;
}

QString shown_value(const Document& document, const Cell& cell) {
  const QString text = QString::fromStdString(document.text(cell));
  const deck::VariableSpec* variable = variable_of(cell);
  const deck::Value* value = value_at(document.deck(), cell);
  if (variable == nullptr || value == nullptr || document.has_unparsed_text(cell)) return text;
  const double* real = std::get_if<double>(value);
  const QString unit = real == nullptr ? QString() : unit_in_view(document, *variable);
  if (unit.isEmpty()) return text;
  return QString::fromStdString(deck::number_in_unit(*real, variable->unit, document.deck().units(),
                                                     unit.toStdString())) +
         " " + unit;
}

QString name_and_value(const Document& document, const Cell& cell) {
  const deck::VariableSpec* variable = variable_of(cell);
  if (variable == nullptr || unit_in_view(document, *variable).isEmpty()) return {};
  // A drawing has no room for twelve digits; the field has them.
  QString value = shown_value(document, cell);
  const QString digits = value.section(' ', 0, 0);
  bool is_number = false;
  const QString few = QString::number(digits.toDouble(&is_number), 'g', 6);
  if (is_number && few.size() < digits.size()) value.replace(0, digits.size(), few);
  return QString::fromStdString(std::string(variable->name)) + " = " + value;
}

std::string add_display_unit(const Document& document, const Cell& cell, const std::string& typed) {
  const deck::VariableSpec* variable = variable_of(cell);
  if (variable == nullptr || variable->type != deck::VarType::Real) return typed;
  static const QRegularExpression number(QString::fromUtf8(
      R"(^[-+\x{2212}\d.,\s*/()]*\d[-+\x{2212}\d.,\s*/()]*([eEdD][-+\x{2212}]?\d+)?[-+\x{2212}\d.,\s*/()eEdD]*$)"));
  const QString unit = unit_in_view(document, *variable);
  if (unit.isEmpty() || !number.match(QString::fromStdString(typed)).hasMatch()) return typed;
  // A unit belongs to the whole of a sum.
  const std::size_t sum = typed.find_first_of("+-*/(", typed.find_first_of("0123456789."));
  return (sum == std::string::npos ? typed : "(" + typed + ")") + " " + unit.toStdString();
}

QString run_time_text(const Document& document, const Cell& cell) {
  const deck::VariableSpec* variable = variable_of(cell);
  if (variable == nullptr || !is_run_time(*variable)) return {};
  const std::optional<runs::RunScales> scales = document.scales();
  const TypedValue typed = document.parse(cell, document.text(cell));
  const double* value = std::get_if<double>(&typed.value);
  if (!scales || typed.problem || value == nullptr) return {};
  if (!no_steps_reason(document, cell).isEmpty()) return {};
  const double seconds = *value * scales->time;
  std::string text = fmt::format("{:.4g} s", seconds);
  if (variable->name == "fTime" && scales->turns_per_second > 0.0)
    text +=
        " = " + counted(fmt::format("{:.4g}", seconds * scales->turns_per_second), "revolution");
  return QString::fromStdString(text);
}

QString no_steps_reason(const Document& document, const Cell& cell) {
  const deck::VariableSpec* variable = variable_of(cell);
  if (variable == nullptr || variable->name != "fTime") return {};
  const std::string why = runs::why_no_step(document.deck());
  return why.empty() ? QString() : QString::fromStdString(why + ": no motion");
}

QString typed_value_text(const Document& document, const Cell& cell) {
  const deck::VariableSpec* variable = variable_of(cell);
  if (variable == nullptr || variable->type != deck::VarType::Real ||
      !document.has_unparsed_text(cell))
    return {};
  const std::string typed_text = document.text(cell);
  const std::string text = add_display_unit(document, cell, typed_text);
  if (text == typed_text && !parse_typed_text(*variable, text).problem) return {};
  const TypedValue typed = document.parse(cell, text);
  if (typed.problem) return {};
  const std::string unit = unit_of(document.deck(), *variable);
  return QString::fromStdString(shown_text(typed.value) + (unit.empty() ? "" : " " + unit));
}

}  // namespace adore::adrinput
