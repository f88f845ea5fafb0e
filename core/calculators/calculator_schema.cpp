#include "calculators/calculator_schema.hpp"

#include "base/errors.hpp"
#include "base/resources.hpp"
#include "base/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace adore::calculators {
namespace {

using Ordered = nlohmann::ordered_json;
using Json = nlohmann::json;

std::vector<std::string> texts(const Ordered& row, const char* key) {
  return row.value(key, std::vector<std::string>());
}

Condition condition(const Ordered& row, const char* key) {
  Condition out;
  const Ordered all = row.value(key, Ordered::object());
  for (const auto& [path, values] : all.items())
    for (const Ordered& value : values) out[path].push_back(Json(value));
  return out;
}

SchemaInput read_input(const Ordered& row) {
  SchemaInput out;
  out.name = row.at("name");
  out.type = row.at("type");
  out.unit = row.value("unit", "");
  out.meaning = row.value("meaning", "");
  if (row.contains("range")) out.range = parse_range(row.at("range").get<std::string>());
  out.range.nonzero = row.value("nonzero", false);
  out.values = row.value("values", std::vector<double>());
  out.codes = texts(row, "codes");
  if (row.contains("null")) out.null_meaning = row.at("null").get<std::string>();
  if (row.contains("length")) out.length = Json(row.at("length"));
  if (row.contains("default")) out.default_value = Json(row.at("default"));
  out.needs = texts(row, "needs");
  out.only_if = condition(row, "if");
  return out;
}

SchemaKind read_kind(const std::string& name, const Ordered& row,
                     const std::vector<SchemaInput>& inputs) {
  SchemaKind out;
  out.name = name;
  out.runs = row.value("runs", name);
  out.aliases = texts(row, "aliases");
  out.when = condition(row, "when");
  out.required = texts(row, "required");
  out.optional = texts(row, "optional");
  out.one_of = row.value("one_of", std::vector<std::vector<std::string>>());
  out.results = texts(row, "results");
  out.example = row.at("example");
  std::set<std::string> taken(out.required.begin(), out.required.end());
  taken.insert(out.optional.begin(), out.optional.end());
  for (const auto& group : out.one_of) taken.insert(group.begin(), group.end());
  std::map<std::string, SchemaInput> own;
  const Ordered own_inputs = row.value("inputs", Ordered::array());
  for (const Ordered& input : own_inputs) {
    SchemaInput one = read_input(input);
    own.emplace(one.name, one);
  }
  for (const SchemaInput& input : inputs)
    if (taken.erase(input.name) > 0) {
      const auto found = own.find(input.name);
      out.inputs.push_back(found == own.end() ? input : found->second);
    }
  demand(taken.empty(),
         fmt::format("calculators.json: kind {} uses the input {}, which has no description", name,
                     taken.empty() ? "" : *taken.begin()));
  return out;
}

std::map<std::string, SchemaFamily, std::less<>> read_schema() {
  std::map<std::string, SchemaFamily, std::less<>> out;
  const Ordered all = Ordered::parse(resources::get("calculators.json"));
  for (const auto& [name, family] : all.items()) {
    SchemaFamily& one = out[name];
    for (const Ordered& row : family.at("inputs")) one.inputs.push_back(read_input(row));
    for (const Ordered& row : family.at("results"))
      one.results.push_back(
          {row.at("name"), row.value("unit", ""), row.value("meaning", ""),
           row.contains("range") ? parse_range(row.at("range").get<std::string>()) : ValueRange{}});
    for (const auto& [kind, row] : family.at("kinds").items())
      one.kinds.push_back(read_kind(kind, row, one.inputs));
  }
  return out;
}

/// "1e+11" as "1e11".
std::string short_number(double value) {
  std::string out = fmt::format("{:g}", value);
  if (const std::size_t plus = out.find("e+"); plus != std::string::npos) out.erase(plus + 1, 1);
  return out;
}

}  // namespace

bool ValueRange::contains(double value) const {
  return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high) &&
         !(nonzero && value == 0.0);
}

std::string ValueRange::text() const {
  const bool has_low = std::isfinite(low), has_high = std::isfinite(high);
  std::string out;
  if (has_low && has_high && !low_open && !high_open)
    out = fmt::format("{} to {}", short_number(low), short_number(high));
  else if (has_low && has_high)
    out = fmt::format("{}{}, {}{}", low_open ? "above " : "from ", short_number(low),
                      high_open ? "below " : "up to ", short_number(high));
  else if (has_low)
    out = fmt::format("{}{}", low_open ? "above " : "from ", short_number(low));
  else if (has_high)
    out = fmt::format("{}{}", high_open ? "below " : "up to ", short_number(high));
  if (nonzero) out += out.empty() ? "not 0" : ", not 0";
  return out;
}

ValueRange parse_range(std::string_view text) {
  const std::size_t comma = text.find(',');
  demand(text.size() > 4 && comma != std::string_view::npos &&
             (text.front() == '[' || text.front() == '(') &&
             (text.back() == ']' || text.back() == ')'),
         "a range is written as [a, b], (a, b], [a, b) or (a, b)");
  const auto number = [](std::string_view part) {
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    demand(error == std::errc() && end == part.data() + part.size(), "a bound is not a number");
    return value;
  };
  ValueRange out;
  out.low_open = text.front() == '(';
  out.high_open = text.back() == ')';
  out.low = number(text.substr(1, comma - 1));
  out.high = number(text.substr(comma + 1, text.size() - comma - 2));
  return out;
}

std::string SchemaInput::value_text() const {
  std::string out;
  if (type == "number" || type == "whole number") {
    if (!values.empty()) {
      out = fmt::format("{}", fmt::join(values, " or "));
    } else {
      out = fmt::format("a {}", type);
      if (const std::string bounds = range.text(); !bounds.empty()) out += " " + bounds;
    }
    if (!unit.empty() && unit != "1") out += fmt::format(" [{}]", unit);
  } else if (type == "true or false") {
    out = type;
  } else if (codes.empty()) {
    out = "a text";
  }
  for (const std::string& code : codes)
    out += fmt::format("{}\"{}\"", out.empty() ? "" : " or ", code);
  if (null_meaning) out += fmt::format(" or null ({})", *null_meaning);
  return out;
}

const SchemaInput* SchemaKind::find(std::string_view wanted) const {
  const auto found = std::find_if(inputs.begin(), inputs.end(),
                                  [&](const SchemaInput& i) { return i.name == wanted; });
  return found == inputs.end() ? nullptr : &*found;
}

const SchemaFamily* family_schema(std::string_view family) {
  static const std::map<std::string, SchemaFamily, std::less<>> kSchema = read_schema();
  const auto found = kSchema.find(family);
  return found == kSchema.end() ? nullptr : &found->second;
}

std::vector<const SchemaKind*> calculation_kinds(const SchemaFamily& family,
                                                 std::string_view adapter_kind) {
  std::vector<const SchemaKind*> out;
  for (const SchemaKind& kind : family.kinds)
    if (adapter_kind.empty() || kind.runs == adapter_kind) out.push_back(&kind);
  return out;
}

std::string spelling_suggestion(std::string_view wrong, const std::set<std::string>& names,
                                std::string_view plural) {
  std::vector<std::string> near;
  for (const std::string& name : names)
    if (edit_distance(wrong, name) <= std::max<std::size_t>(1, name.size() / 3))
      near.push_back(name);
  if (near.empty()) return fmt::format("the {} are {}", plural, fmt::join(names, ", "));
  std::stable_sort(near.begin(), near.end(), [&](const auto& a, const auto& b) {
    return edit_distance(wrong, a) < edit_distance(wrong, b);
  });
  near.resize(std::min<std::size_t>(near.size(), 3));
  return fmt::format("did you mean {}?", fmt::join(near, ", "));
}

}  // namespace adore::calculators
