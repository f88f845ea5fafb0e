#include "calculators/calculator_description.hpp"

#include "base/counted.hpp"
#include "base/json_text.hpp"
#include "calculators/calculator_schema.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace adore::calculators {
namespace {

using Json = nlohmann::json;
using Ordered = nlohmann::ordered_json;

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

bool is_in(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

const std::vector<std::string>* group_of(const SchemaKind& kind, const std::string& name) {
  for (const auto& group : kind.one_of)
    if (is_in(group, name)) return &group;
  return nullptr;
}

Ordered condition_json(const Condition& condition) {
  Ordered out = Ordered::object();
  for (const auto& [path, values] : condition) out[path] = values;
  return out;
}

Ordered input_json(const SchemaKind& kind, const SchemaInput& input) {
  Ordered out{{"name", input.name}, {"type", input.type}, {"unit", input.unit}};
  out["required"] = is_in(kind.required, input.name);
  if (const auto* group = group_of(kind, input.name)) out["one_of"] = *group;
  if (input.values.empty() && !input.range.text().empty()) out["range"] = input.range.text();
  if (!input.values.empty()) out["values"] = input.values;
  if (!input.codes.empty()) out["codes"] = input.codes;
  if (!input.default_value.is_null()) out["default"] = input.default_value;
  if (input.null_meaning) out["null"] = *input.null_meaning;
  if (!input.length.is_null()) out["length"] = input.length;
  if (!input.needs.empty()) out["needs"] = input.needs;
  if (!input.only_if.empty()) out["if"] = condition_json(input.only_if);
  if (!input.meaning.empty()) out["meaning"] = input.meaning;
  return out;
}

std::string short_condition_text(const Condition& condition) {
  std::string out;
  for (const auto& [path, values] : condition) {
    std::string list;
    for (const Json& value : values)
      list += (list.empty() ? "" : " or ") +
              (value.is_string() ? value.get<std::string>() : dump_json(value));
    out += fmt::format("{}{} = {}", out.empty() ? "" : " and ", path, list);
  }
  return out;
}

/// "required", "default 0.52", "optional", with the condition under which the input acts.
std::string presence_text(const SchemaKind& kind, const SchemaInput& input) {
  std::string out;
  if (const auto* group = group_of(kind, input.name))
    out = fmt::format("one of {}", fmt::join(*group, ", "));
  else if (is_in(kind.required, input.name))
    out = "required";
  else if (!input.default_value.is_null())
    out = "default " + dump_json(input.default_value);
  else
    out = "optional";
  if (!input.only_if.empty()) out += " if " + short_condition_text(input.only_if);
  if (!input.needs.empty()) out += fmt::format(", together with {}", fmt::join(input.needs, ", "));
  return out;
}

std::string allowed_text(const SchemaInput& input) {
  if (input.type == "label") return "label";
  std::string out = input.value_text();
  if (out.starts_with("a ")) out.erase(0, 2);
  if (!input.length.is_null())
    out += ", " + counted(input.length.is_string() ? input.length.get<std::string>()
                                                   : dump_json(input.length),
                          "value");
  return out;
}

const SchemaResult* find_result(const SchemaFamily& family, const std::string& name) {
  const auto found = std::find_if(family.results.begin(), family.results.end(),
                                  [&](const SchemaResult& r) { return r.name == name; });
  return found == family.results.end() ? nullptr : &*found;
}

Ordered example_of(const CalculatorInfo& info, const SchemaKind& kind) {
  if (!info.kind.empty()) return kind.example;
  return Ordered{{"kind", kind.name}, {"inputs", kind.example}};
}

/// `|` ends a cell in Markdown.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.insert(at, "\\");
  return text;
}

std::string kind_markdown(const CalculatorInfo& info, const SchemaFamily& family,
                          const SchemaKind& kind, bool titled) {
  std::string out;
  if (titled) out += fmt::format("### {}: {}\n\n", info.name, kind.name);
  out += "| input | value | required | meaning |\n|---|---|---|---|\n";
  for (const SchemaInput& input : kind.inputs)
    out += fmt::format("| `{}` | {} | {} | {} |\n", input.name, cell(allowed_text(input)),
                       cell(presence_text(kind, input)), cell(input.meaning));
  std::string results;
  for (const std::string& name : kind.results) {
    const SchemaResult* result = find_result(family, name);
    results += fmt::format("{}`{}`", results.empty() ? "" : ", ", name);
    if (result != nullptr && !result->unit.empty() && result->unit != "1")
      results += fmt::format(" [{}]", result->unit);
  }
  return out + fmt::format("\nResults: {}\n\n```json\n{}\n```\n\n", results,
                           dump_json(example_of(info, kind)));
}

}  // namespace

Json result_units(std::string_view family, const Json& results) {
  Json out = Json::object();
  const SchemaFamily* schema = family_schema(family);
  if (schema == nullptr) return out;
  std::set<std::string> present;
  collect_paths(results, "", present);
  for (const SchemaResult& row : schema->results)
    if (!row.unit.empty() && present.contains(row.name)) out[row.name] = row.unit;
  return out;
}

Ordered describe_calculator(const CalculatorInfo& info) {
  Ordered out{{"name", info.name}, {"help", info.help}, {"calculations", Ordered::array()}};
  const SchemaFamily* schema = family_schema(info.family);
  if (schema == nullptr) return out;
  for (const SchemaKind* kind : calculation_kinds(*schema, info.kind)) {
    Ordered inputs = Ordered::array(), results = Ordered::array();
    for (const SchemaInput& input : kind->inputs) inputs.push_back(input_json(*kind, input));
    for (const std::string& name : kind->results)
      if (const SchemaResult* row = find_result(*schema, name)) {
        Ordered result{{"name", row->name}, {"unit", row->unit}};
        if (!row->meaning.empty()) result["meaning"] = row->meaning;
        results.push_back(std::move(result));
      }
    out["calculations"].push_back({{"kind", kind->name},
                                   {"aliases", kind->aliases},
                                   {"inputs", std::move(inputs)},
                                   {"results", std::move(results)},
                                   {"example", example_of(info, *kind)}});
  }
  return out;
}

std::string describe_calculator_text(const CalculatorInfo& info) {
  std::string out = fmt::format("{}: {}\n", info.name, info.help);
  const SchemaFamily* schema = family_schema(info.family);
  if (schema == nullptr) return out;
  const std::vector<const SchemaKind*> kinds = calculation_kinds(*schema, info.kind);
  for (const SchemaKind* kind : kinds) {
    if (info.kind.empty() || kinds.size() > 1) out += fmt::format("\n{}\n", kind->name);
    out += "\ninputs\n";
    for (const SchemaInput& input : kind->inputs)
      out += fmt::format("  {:<28} {:<44} {:<12} {}\n", input.name, allowed_text(input),
                         presence_text(*kind, input), input.meaning);
    out += "\nresults\n";
    for (const std::string& name : kind->results)
      if (const SchemaResult* row = find_result(*schema, name))
        out += fmt::format(
            "  {:<40} {}\n", row->name,
            row->meaning.empty() ? row->unit : fmt::format("{:<10} {}", row->unit, row->meaning));
    out += fmt::format("\nexample\n  {}\n", dump_json(example_of(info, *kind)));
  }
  return out;
}

std::string calculators_markdown() {
  std::string out =
      "# Calculators\n\n"
      "`adore calc NAME FILE` reads one JSON object of inputs and prints the results with their "
      "units. Some calculators have several kinds of calculation; the inputs determine the kind. "
      "To select a kind explicitly, write `{\"kind\": ..., \"inputs\": {...}}`. Text inputs such "
      "as material codes are not case-sensitive. Unknown, unused and missing inputs are errors. "
      "Values outside their range are also errors. Inputs of the type `label` are comments "
      "without effect.\n\n"
      "This page is the output of `adore calc --list --markdown`.\n\n";
  for (const CalculatorInfo& info : calculator_list()) {
    out += fmt::format("## {}\n\n{}\n\n", info.name, info.help);
    const SchemaFamily* schema = family_schema(info.family);
    if (schema == nullptr) continue;
    const std::vector<const SchemaKind*> kinds = calculation_kinds(*schema, info.kind);
    for (const SchemaKind* kind : kinds)
      out += kind_markdown(info, *schema, *kind, info.kind.empty() || kinds.size() > 1);
  }
  while (out.ends_with("\n\n")) out.pop_back();
  return out;
}

}  // namespace adore::calculators
