#include "calculators/find.hpp"

#include "base/errors.hpp"
#include "calculators/calculator_schema.hpp"
#include "calculators/calculators.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

namespace adore::calculators {
namespace {

using Json = nlohmann::json;

/// "a.b[2]" as a pointer, "/a/b/1". @throws InputError for an index that is not a number from 1
Json::json_pointer pointer_of(std::string_view path) {
  Json::json_pointer out;
  std::size_t at = 0;
  while (at < path.size()) {
    const std::size_t end = std::min(path.find_first_of(".[", at), path.size());
    if (end > at) out /= std::string(path.substr(at, end - at));
    if (end < path.size() && path[end] == '[') {
      const std::size_t close = path.find(']', end);
      const std::string_view digits = path.substr(end + 1, std::min(close, path.size()) - end - 1);
      std::size_t index = 0;
      const auto [stop, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), index);
      if (error != std::errc() || stop != digits.data() + digits.size() || index < 1 ||
          close == std::string_view::npos)
        throw InputError(fmt::format(
            "{}: \"{}\" is not an index. Enter a whole number of 1 or more.", path, digits));
      out /= index - 1;
      at = close + 1;
    } else {
      at = end + 1;
    }
  }
  return out;
}

double number_in(const Json& value) {
  if (value.is_number()) return value.get<double>();
  return std::numeric_limits<double>::quiet_NaN();
}

/// Names of all numbers and lists of numbers of the results.
void list_numbers(const Json& value, const std::string& path, std::vector<std::string>& out) {
  if (value.is_object()) {
    for (const auto& [name, one] : value.items())
      if (path.empty() && name == "units")
        continue;
      else
        list_numbers(one, path.empty() ? name : path + "." + name, out);
  } else if (value.is_number()) {
    out.push_back(path);
  } else if (value.is_array() && !value.empty() && value.front().is_number()) {
    out.push_back("least(" + path + ")");
  }
}

/// Value of a target; nothing: the results do not have it.
std::optional<double> value_of(const Json& results, const std::string& path) {
  for (const bool largest : {false, true}) {
    const std::string begin = largest ? "largest(" : "least(";
    if (!path.starts_with(begin) || !path.ends_with(")")) continue;
    const auto at =
        pointer_of(std::string_view(path).substr(begin.size(), path.size() - begin.size() - 1));
    if (!results.contains(at) || !results.at(at).is_array()) return {};
    std::optional<double> out;
    for (const Json& one : results.at(at)) {
      const double value = number_in(one);
      if (!out || (largest ? value > *out : value < *out)) out = value;
    }
    return out;
  }
  const auto at = pointer_of(path);
  if (!results.contains(at) || results.at(at).is_structured()) return {};
  return number_in(results.at(at));
}

std::string unit_of_result(const Json& results, const std::string& path) {
  if (!results.contains("units")) return {};
  const std::size_t open = path.find('('), close = path.rfind(')');
  std::string name = open == std::string::npos ? path : path.substr(open + 1, close - open - 1);
  name = name.substr(0, name.find('['));
  for (const std::string& key : {name, name + "[]"})
    if (const Json& units = results.at("units"); units.contains(key) && units.at(key).is_string()) {
      const auto unit = units.at(key).get<std::string>();
      return unit == "-" ? std::string() : unit;
    }
  return {};
}

const SchemaInput* schema_input(std::string_view calculator, const std::string& path) {
  for (const CalculatorInfo& info : calculator_list()) {
    if (info.name != calculator) continue;
    const SchemaFamily* family = family_schema(info.family);
    if (family == nullptr) return nullptr;
    for (const SchemaKind* kind : calculation_kinds(*family, info.kind))
      if (const SchemaInput* input = kind->find(path)) return input;
  }
  return nullptr;
}

}  // namespace

FindReport find_in_calculator(std::string_view calculator, const Json& input, FindUnknown unknown,
                              FindTarget target, int points) {
  FindReport out;
  out.source = fmt::format("calculator {}", calculator);
  FindSettings settings;
  settings.first = unknown.first;
  settings.last = unknown.last;
  settings.relation = target.relation;
  settings.target = target.value;
  settings.points = points;
  if (const SchemaInput* given = schema_input(calculator, unknown.name)) {
    unknown.unit = given->unit == "-" ? std::string() : given->unit;
    settings.whole = given->type == "whole number" || given->type == "code";
  }
  const auto place = pointer_of(unknown.name);
  std::optional<std::string> lack;
  Json inputs = input;
  if (!inputs.is_object())
    throw InputError(fmt::format("calculator {}: the input must be one JSON object", calculator));
  Json& values = inputs.contains("inputs") ? inputs["inputs"] : inputs;
  const auto value_at = [&](double x) {
    try {
      if (settings.whole)
        values[place] = static_cast<long long>(x);
      else
        values[place] = x;
    } catch (const Json::exception&) {
      throw InputError(
          fmt::format("the unknown \"{}\" is not a path in the inputs.", unknown.name));
    }
    const Json results = calculate(calculator, inputs);
    const auto value = value_of(results, target.name);
    if (!value) {
      std::vector<std::string> names;
      list_numbers(results, "", names);
      lack = unknown_name_message("result", target.name, names);
      throw InputError(*lack);
    }
    if (target.unit.empty()) target.unit = unit_of_result(results, target.name);
    return *value;
  };
  try {
    out.outcome = find_values(settings, value_at);
  } catch (const InputError&) {
    if (lack) throw InputError(*lack);
    throw;
  }
  out.unknown = unknown;
  out.target = target;
  return out;
}

}  // namespace adore::calculators
