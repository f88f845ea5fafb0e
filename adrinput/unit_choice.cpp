#include "adrinput/unit_choice.hpp"

#include "adrinput/typed.hpp"
#include "deck/quantity.hpp"
#include "deck/unit_change.hpp"

#include <QSettings>
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

const std::vector<Quantity>& quantities_with_a_choice() {
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
  const QString unit = QSettings("Adore", "adrinput").value(key_of(si)).toString();
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

QString shown_value(const Document& document, const Cell& cell) {
  const QString text = QString::fromStdString(document.text(cell));
  const deck::VariableSpec* variable = variable_of(cell);
  const deck::Value* value = value_at(document.deck(), cell);
  if (variable == nullptr || value == nullptr || document.is_draft(cell)) return text;
  const double* real = std::get_if<double>(value);
  if (real == nullptr || deck::unit_name(document.deck(), *variable).empty()) return text;
  const QString unit = chosen_unit(variable->unit.si);
  const auto usual = deck::usual_units(variable->unit);
  const std::string name = unit.toStdString();
  if (unit.isEmpty() || std::find(usual.begin(), usual.end(), name) == usual.end()) return text;
  return QString::fromStdString(
             deck::number_in(*real, variable->unit, document.deck().units(), name)) +
         " " + unit;
}

QString run_time(const Document& document, const Cell& cell) {
  const deck::VariableSpec* variable = variable_of(cell);
  if (variable == nullptr || !is_run_time(*variable)) return {};
  const std::optional<facade::RunScales> scales = document.scales();
  const Typed typed = document.parse(cell, document.text(cell));
  const double* value = std::get_if<double>(&typed.value);
  if (!scales || typed.problem || value == nullptr) return {};
  const double seconds = *value * scales->time;
  std::string text = fmt::format("{:.4g} s", seconds);
  if (variable->name == "fTime" && scales->turns_per_second > 0.0)
    text += fmt::format(" = {:.4g} revolutions", seconds * scales->turns_per_second);
  return QString::fromStdString(text);
}

QString typed_value(const Document& document, const Cell& cell) {
  const deck::VariableSpec* variable = variable_of(cell);
  if (variable == nullptr || variable->type != deck::VarType::Real || !document.is_draft(cell))
    return {};
  const std::string text = document.text(cell);
  if (!parse_typed(*variable, text).problem) return {};
  const Typed typed = document.parse(cell, text);
  if (typed.problem) return {};
  const std::string unit = unit_of(document.deck(), *variable);
  return QString::fromStdString(shown_text(typed.value) + (unit.empty() ? "" : " " + unit));
}

}  // namespace adore::adrinput
