#include "calculators/calculator_inputs.hpp"

#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "base/resources.hpp"
#include "base/spelling.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace adore::calculators {
namespace {

using Json = nlohmann::json;
using Ordered = nlohmann::ordered_json;

const Ordered& all_families() {
  static const Ordered kTable = Ordered::parse(resources::get("calculators.json"));
  return kTable;
}

const Ordered* find_family(std::string_view family) {
  const auto found = all_families().find(std::string(family));
  return found == all_families().end() ? nullptr : &*found;
}

std::vector<CalculatorField> fields(const Ordered& rows) {
  std::vector<CalculatorField> out;
  for (const Ordered& row : rows) {
    if (row.size() < 4)  // a result, which may have no meaning beside its name
      out.push_back({row[0].get<std::string>(),
                     {},
                     row[1].get<std::string>(),
                     row.size() == 3 ? row[2].get<std::string>() : std::string()});
    else
      out.push_back({row[0].get<std::string>(), row[1].get<std::string>(),
                     row[2].get<std::string>(), row[3].get<std::string>()});
  }
  return out;
}

/// The names nearest to a wrong one, or all when none is near.
std::string suggestion(std::string_view wrong, const std::set<std::string>& names) {
  std::vector<std::string> near;
  for (const std::string& name : names)
    if (edit_distance(wrong, name) <= std::max<std::size_t>(1, name.size() / 3))
      near.push_back(name);
  if (!near.empty()) {
    std::sort(near.begin(), near.end(), [&](const auto& a, const auto& b) {
      return edit_distance(wrong, a) < edit_distance(wrong, b);
    });
    near.resize(std::min<std::size_t>(near.size(), 3));
    return fmt::format("did you mean {}?", fmt::join(near, ", "));
  }
  return fmt::format("the inputs are {}", fmt::join(names, ", "));
}

std::string type_words(const CalculatorField& field) {
  std::string out;
  std::string_view rest = field.type;
  while (!rest.empty()) {
    const std::size_t bar = rest.find('|');
    const std::string_view one = rest.substr(0, bar);
    out += fmt::format("{}{}{}", out.empty() ? "" : " or ", one == "null" ? "" : "a ", one);
    rest.remove_prefix(bar == std::string_view::npos ? rest.size() : bar + 1);
  }
  const bool plain = field.unit.empty() || field.unit == "1";
  return plain ? out : fmt::format("{} [{}]", out, field.unit);
}

bool has_type(const CalculatorField& field, std::string_view type) {
  std::string_view rest = field.type;
  while (!rest.empty()) {
    const std::size_t bar = rest.find('|');
    if (rest.substr(0, bar) == type) return true;
    rest.remove_prefix(bar == std::string_view::npos ? rest.size() : bar + 1);
  }
  return false;
}

bool accepts(const CalculatorField& field, const Json& value) {
  if (value.is_string()) return has_type(field, "text");
  if (value.is_boolean()) return has_type(field, "true or false");
  if (value.is_null()) return has_type(field, "null");
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  const bool whole = number == std::round(number);
  return has_type(field, "number") || (number > 0.0 && has_type(field, "positive number")) ||
         (whole && has_type(field, "whole number")) ||
         (whole && number > 0.0 && has_type(field, "positive whole number"));
}

/// Walks the inputs along the table.
class InputCheck {
 public:
  explicit InputCheck(const Ordered& family) : fields_(fields(family.at("inputs"))) {}

  void object(const Json& value, const std::string& path) {
    const std::string prefix = path.empty() ? "" : path + ".";
    const std::set<std::string> names = names_below(prefix);
    for (const auto& [key, item] : value.items()) {
      if (names.count(key) > 0)
        check(item, prefix + key);
      else if (!(path.empty() && key == "kind"))
        report(prefix + key, "there is no such input", suggestion(key, names));
    }
  }

  void finish() {
    if (!issues_.empty()) throw InputError(std::move(issues_));
  }

 private:
  void check(const Json& value, const std::string& path) {
    if (value.is_object() && !names_below(path + ".").empty()) return object(value, path);
    if (value.is_array() && known(path + "[]")) {
      for (const Json& item : value) check(item, path + "[]");
      return;
    }
    const auto field = std::find_if(fields_.begin(), fields_.end(),
                                    [&](const CalculatorField& f) { return f.path == path; });
    if (field != fields_.end() && accepts(*field, value)) return;
    const bool number = value.is_number() && field != fields_.end();
    report(path,
           fmt::format("{} is {}", dump_json(value), number ? "out of range" : "of the wrong type"),
           "give " + (field != fields_.end() ? type_words(*field)
                      : known(path + "[]")   ? "a list"
                      : names_below(path + ".").empty()
                          ? "another value"
                          : "an object with " +
                                fmt::format("{}", fmt::join(names_below(path + "."), ", "))));
  }

  [[nodiscard]] bool known(const std::string& path) const {
    return std::any_of(fields_.begin(), fields_.end(),
                       [&](const CalculatorField& f) { return f.path.rfind(path, 0) == 0; });
  }

  /// Keys that may follow a path that ends with a point.
  [[nodiscard]] std::set<std::string> names_below(const std::string& prefix) const {
    std::set<std::string> out;
    for (const CalculatorField& f : fields_)
      if (f.path.rfind(prefix, 0) == 0)
        out.insert(f.path.substr(prefix.size(),
                                 f.path.find_first_of(".[", prefix.size()) - prefix.size()));
    return out;
  }

  void report(std::string path, std::string message, std::string remedy) {
    Issue issue;
    issue.variable = std::move(path);
    issue.message = std::move(message);
    issue.remedy = std::move(remedy);
    issues_.push_back(std::move(issue));
  }

  std::vector<CalculatorField> fields_;
  std::vector<Issue> issues_;
};

/// Paths of the values in a result.
void collect_paths(const Json& value, const std::string& path, std::set<std::string>& out) {
  if (value.is_object()) {
    for (const auto& [key, item] : value.items())
      collect_paths(item, path.empty() ? key : path + "." + key, out);
  } else if (value.is_array()) {
    for (const Json& item : value) collect_paths(item, path + "[]", out);
  } else {
    out.insert(path);
  }
}

Ordered described(const std::vector<CalculatorField>& all, const Ordered& paths) {
  Ordered out = Ordered::array();
  for (const CalculatorField& field : all) {
    if (std::find(paths.begin(), paths.end(), field.path) == paths.end()) continue;
    Ordered row{{"name", field.path}};
    if (!field.type.empty()) row["type"] = field.type;
    row["unit"] = field.unit;
    if (!field.meaning.empty()) row["meaning"] = field.meaning;
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace

void check_calculator_inputs(std::string_view family, const Json& inputs) {
  const Ordered* table = find_family(family);
  if (table == nullptr) return;
  InputCheck check(*table);
  check.object(inputs, "");
  check.finish();
}

std::string paths_of_key(std::string_view family, std::string_view key) {
  const Ordered* table = find_family(family);
  if (table == nullptr) return std::string(key);
  std::set<std::string> found;
  for (const CalculatorField& field : fields(table->at("inputs"))) {
    const std::string dotted = "." + field.path + ".";
    for (const char* end : {".", "["}) {
      const std::size_t at = dotted.find("." + std::string(key) + end);
      if (at != std::string::npos) found.insert(field.path.substr(0, at + key.size()));
    }
  }
  return found.empty() ? std::string(key) : fmt::format("{}", fmt::join(found, " or "));
}

Json result_units(std::string_view family, const Json& results) {
  Json out = Json::object();
  const Ordered* table = find_family(family);
  if (table == nullptr) return out;
  std::set<std::string> present;
  collect_paths(results, "", present);
  for (const CalculatorField& field : fields(table->at("results")))
    if (!field.unit.empty() && present.count(field.path) > 0) out[field.path] = field.unit;
  return out;
}

Ordered describe_calculator(const CalculatorInfo& info) {
  Ordered out{{"name", info.name}, {"help", info.help}, {"calculations", Ordered::array()}};
  const Ordered* table = find_family(info.family);
  if (table == nullptr) return out;
  const std::vector<CalculatorField> inputs = fields(table->at("inputs"));
  const std::vector<CalculatorField> results = fields(table->at("results"));
  for (const auto& [kind, one] : table->at("kinds").items()) {
    const bool exact = table->at("kinds").contains(info.kind);
    if (!info.kind.empty() && (exact ? kind != info.kind : kind.rfind(info.kind, 0) != 0)) continue;
    Ordered example = one.at("example");
    if (info.kind.empty()) example = Ordered{{"kind", kind}, {"inputs", one.at("example")}};
    out["calculations"].push_back({{"kind", kind},
                                   {"inputs", described(inputs, one.at("inputs"))},
                                   {"results", described(results, one.at("results"))},
                                   {"example", std::move(example)}});
  }
  return out;
}

std::string describe_calculator_text(const CalculatorInfo& info) {
  const Ordered all = describe_calculator(info);
  std::string out = fmt::format("{}: {}\n", info.name, info.help);
  for (const Ordered& one : all.at("calculations")) {
    if (info.kind.empty()) out += fmt::format("\n{}\n", one.at("kind").get<std::string>());
    out += "\ninputs\n";
    for (const Ordered& row : one.at("inputs"))
      out += fmt::format("  {:<30} {:<9} {:<24} {}\n", row.at("name").get<std::string>(),
                         row.at("unit").get<std::string>(), row.at("type").get<std::string>(),
                         row.value("meaning", std::string()));
    out += "\nresults\n";
    for (const Ordered& row : one.at("results"))
      out += fmt::format(
          "  {:<40} {}{}\n", row.at("name").get<std::string>(), row.at("unit").get<std::string>(),
          row.contains("meaning") ? "  " + row.at("meaning").get<std::string>() : "");
    out += fmt::format("\nexample\n  {}\n", dump_json(one.at("example")));
  }
  return out;
}

}  // namespace adore::calculators
