#include "deck/schema_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <utility>

namespace adore::deck {
namespace {

constexpr double kLargestInteger = 2147483647.0;  // limit of the classic tool

}  // namespace

std::string_view intern_string(std::string text) {
  static std::deque<std::string>
      kept;  // a deque never moves its elements; filled once, under schema()'s static guard
  return kept.emplace_back(std::move(text));
}

VariableSpec text(std::string_view name, int max_length, std::string_view help,
                  std::string_view default_value) {
  VariableSpec variable;
  variable.name = name;
  variable.type = VarType::String;
  variable.unit = unit::kNone;
  variable.default_value = default_value;
  variable.max_length = max_length;
  variable.help = help;
  return variable;
}

VariableSpec record_label() {
  return text("recID", 12,
              "Label of the record, at most 12 characters in single quotes. It is printed in "
              "PRINT.txt and has no other effect. Use the record number, such as 'Rec 5A'.");
}

VariableSpec integer(std::string_view name, Range range, std::string_view help,
                     std::string_view default_value) {
  VariableSpec variable;
  variable.name = name;
  variable.type = VarType::Integer;
  variable.unit = unit::kNone;
  variable.default_value = default_value;
  variable.range = {std::max(range.min, -kLargestInteger), std::min(range.max, kLargestInteger),
                    range.min_exclusive, range.max_exclusive};
  variable.help = help;
  return variable;
}

VariableSpec counted(std::string_view name, Range range, std::vector<OptionSpec> options,
                     std::string_view help, std::string_view default_value) {
  VariableSpec variable = integer(name, range, help, default_value);
  variable.options = std::move(options);
  return variable;
}

VariableSpec choice(std::string_view name, std::vector<OptionSpec> options, std::string_view help,
                    std::string_view default_value) {
  VariableSpec variable = integer(name, range::kAny, help, default_value);
  variable.options = std::move(options);
  return variable;
}

VariableSpec real(std::string_view name, const UnitPair& unit, Range range, std::string_view help,
                  std::string_view default_value) {
  VariableSpec variable;
  variable.name = name;
  variable.type = VarType::Real;
  variable.unit = unit;
  variable.default_value = default_value;
  variable.range = range;
  variable.help = help;
  return variable;
}

VariableSpec array(VariableSpec variable, std::string_view length) {
  variable.length = length;
  return variable;
}

VariableSpec with_option_table(VariableSpec variable, std::string_view option_table) {
  variable.option_table = option_table;
  return variable;
}

RecordSpec repeated_record(std::string_view id, std::string_view title, std::string_view condition,
                           std::string_view repeat, std::vector<VariableSpec> variables) {
  variables.insert(variables.begin(), record_label());
  return {id, title, condition, repeat, std::move(variables)};
}

RecordSpec record(std::string_view id, std::string_view title, std::string_view condition,
                  std::vector<VariableSpec> variables) {
  return repeated_record(id, title, condition, {}, std::move(variables));
}

std::vector<VariableSpec> inertia_variables(std::string_view prefix, std::string_view suffix,
                                            std::string_view body, std::string_view frame) {
  const auto name = [&](std::string_view middle) {
    return intern_string(fmt::format("{}{}{}", prefix, middle, suffix));
  };
  std::vector<VariableSpec> variables;
  variables.push_back(real(name("Mass"), unit::kMass, range::kPositive,
                           intern_string(fmt::format("Mass of the {}.", body))));
  constexpr std::pair<std::string_view, std::string_view> kAxes[] = {
      {"x", "polar x axis"}, {"y", "transverse y axis"}, {"z", "transverse z axis"}};
  for (const auto& [axis, what] : kAxes)
    variables.push_back(
        real(name(fmt::format("MI{}", axis)), unit::kInertia, range::kPositive,
             intern_string(
                 fmt::format("Principal moment of inertia of the {} about its {}.", body, what))));
  for (const char axis : {'X', 'Y', 'Z'})
    variables.push_back(real(
        name(fmt::format("GeoCen{}", axis)), unit::kLength, range::kAny,
        intern_string(fmt::format("{} component of the vector from the mass center to the "
                                  "geometric center of the {}, in {}. Enter 0 for a balanced body.",
                                  axis, body, frame))));
  for (const char axis : {'X', 'Y', 'Z'})
    variables.push_back(real(
        name(fmt::format("Frame{}", axis)), unit::kAngle, range::kAny,
        intern_string(fmt::format("Rotation angle about {} from the principal axes of inertia to "
                                  "the geometric frame of the {}. Enter 0 if both coincide.",
                                  axis, body))));
  return variables;
}

}  // namespace adore::deck
