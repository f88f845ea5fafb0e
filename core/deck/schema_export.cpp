#include "deck/lookup.hpp"
#include "deck/schema.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>
#include <string>

/// The schema as text for people and programs.
namespace adore::deck {
namespace {

std::string_view type_name(VarType type) {
  switch (type) {
    case VarType::Integer:
      return "int";
    case VarType::Real:
      return "real";
    case VarType::String:
      return "string";
  }
  return "";
}

std::string options_text(const VariableSpec& variable) {
  std::string out;
  for (const OptionSpec& option : variable.options) {
    if (!out.empty()) out += "; ";
    out += fmt::format("{}={}", option.code, option.meaning);
  }
  if (!variable.option_table.empty()) {
    if (!out.empty()) out += "; ";
    out += variable.option_table;
  }
  return out;
}

std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + "\"";
}

/// Infinity is not a JSON number: a missing bound is null.
std::string json_bound(double bound) {
  return bound == std::numeric_limits<double>::infinity() ||
                 bound == -std::numeric_limits<double>::infinity()
             ? "null"
             : fmt::format("{}", bound);
}

std::string json_options(std::span<const OptionSpec> options) {
  std::string out = "[";
  for (const OptionSpec& option : options) {
    if (out.size() > 1) out += ", ";
    out += fmt::format("{{\"code\": {}, \"meaning\": {}}}", json_string(option.code),
                       json_string(option.meaning));
  }
  return out + "]";
}

std::string json_variable(const VariableSpec& v) {
  return fmt::format(
      "      {{\"name\": {}, \"type\": {}, \"length\": {}, \"unit_si\": {}, \"unit_en\": {}, "
      "\"si_factor\": {}, "
      "\"en_factor\": {}, \"unitless_when\": {}, \"options\": {}, \"option_table\": {}, "
      "\"default\": {}, \"min\": {}, "
      "\"max\": {}, \"min_exclusive\": {}, \"max_exclusive\": {}, \"max_length\": {}, \"help\": "
      "{}}}",
      json_string(v.name), json_string(type_name(v.type)), json_string(v.length),
      json_string(v.unit.si), json_string(v.unit.en), v.unit.si_factor, v.unit.en_factor,
      json_string(v.unitless_when), json_options(v.options), json_string(v.option_table),
      v.default_value.empty() ? "null" : json_string(v.default_value), json_bound(v.range.min),
      json_bound(v.range.max), v.range.min_exclusive, v.range.max_exclusive, v.max_length,
      json_string(v.help));
}

std::string markdown_cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}

constexpr std::string_view kTables[] = {"@materials", "@lubricants", "@coolants", "@churning"};

}  // namespace

std::string schema_tsv() {
  std::string out =
      "record\ttitle\trequired_when\trepeat\torder\tvariable\ttype\tlength\tunit_si\tunit_"
      "en\toptions\tdefault\tmeaning\n";
  for (const RecordSpec& record : schema())
    for (std::size_t i = 0; i < record.variables.size(); ++i) {
      const VariableSpec& v = record.variables[i];
      fmt::format_to(std::back_inserter(out),
                     "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", record.id,
                     record.title, record.condition, record.repeat, i, v.name, type_name(v.type),
                     v.length, v.unit.si, v.unit.en, options_text(v), v.default_value, v.help);
    }
  return out;
}

std::string schema_json() {
  std::string out = "{\n  \"records\": [\n";
  bool first_record = true;
  for (const RecordSpec& record : schema()) {
    if (!first_record) out += ",\n";
    first_record = false;
    out += fmt::format(
        "    {{\"id\": {}, \"title\": {}, \"required_when\": {}, \"repeat\": {}, \"variables\": "
        "[\n",
        json_string(record.id), json_string(record.title), json_string(record.condition),
        json_string(record.repeat));
    for (std::size_t i = 0; i < record.variables.size(); ++i)
      out += json_variable(record.variables[i]) + (i + 1 < record.variables.size() ? ",\n" : "\n");
    out += "    ]}";
  }
  out += "\n  ],\n  \"option_tables\": {\n";
  for (std::size_t i = 0; i < std::size(kTables); ++i)
    out +=
        fmt::format("    {}: {}{}\n", json_string(kTables[i]),
                    json_options(option_table(kTables[i])), i + 1 < std::size(kTables) ? "," : "");
  return out + "  }\n}\n";
}

std::string schema_markdown() {
  std::string out =
      "# Records of the data deck\n\nThis page is the output of `adore schema --format md`.\n";
  for (const RecordSpec& record : schema()) {
    out += fmt::format("\n## {} {}\n\n", record.id, record.title);
    out +=
        is_extension(record.id)
            ? std::string("Optional. The record is in ADORE.json in the folder of the deck.\n\n")
            : fmt::format("Required when `{}`{}.\n\n", record.condition,
                          record.repeat.empty() ? "" : fmt::format(", `{}` times", record.repeat));
    out +=
        "| Variable | Type | Unit (SI, English) | Options | Default | Meaning "
        "|\n|---|---|---|---|---|---|\n";
    for (const VariableSpec& v : record.variables) {
      const std::string name =
          v.length == "1" ? fmt::format("`{}`", v.name) : fmt::format("`{}({})`", v.name, v.length);
      const std::string unit = v.unit.si == v.unit.en ? std::string(v.unit.si)
                                                      : fmt::format("{}, {}", v.unit.si, v.unit.en);
      out += fmt::format("| {} | {} | {} | {} | {} | {} |\n", name, type_name(v.type), unit,
                         markdown_cell(options_text(v)), v.default_value, markdown_cell(v.help));
    }
  }
  out += "\n# Code tables\n";
  for (const std::string_view table : kTables) {
    out += fmt::format("\n## {}\n\n| Code | Meaning |\n|---|---|\n", table);
    for (const OptionSpec& option : option_table(table))
      out += fmt::format("| {} | {} |\n", option.code, option.meaning);
  }
  return out;
}

}  // namespace adore::deck
