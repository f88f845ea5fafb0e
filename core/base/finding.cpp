#include "base/finding.hpp"

#include "base/counted.hpp"
#include "base/json_text.hpp"
#include "base/resources.hpp"
#include "base/validity.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace adore {
namespace {

using Json = nlohmann::json;

Severity severity_of(std::string_view word) {
  return word == "error" ? Severity::Error : word == "warning" ? Severity::Warning : Severity::Note;
}

std::vector<FindingKind> read_register() {
  std::vector<FindingKind> out;
  const Json json = parse_json(resources::get("findings.json"), "findings.json");
  for (const Json& entry : json.at("findings")) {
    FindingKind one;
    one.code = entry.at("code").get<std::string>();
    one.severity = severity_of(entry.at("severity").get<std::string>());
    one.origin = entry.at("origin").get<std::string>();
    one.meaning = entry.at("meaning").get<std::string>();
    one.quantity = entry.value("quantity", std::string());
    one.unit = entry.value("unit", std::string());
    one.range = entry.value("range", std::string());
    one.field = entry.value("field", std::string());
    one.topic = entry.value("topic", std::string());
    one.quiet = entry.value("quiet", false);
    if (!one.range.empty()) {
      const validity::Range& range = validity::range(one.range);
      one.quantity = range.quantity;
      one.unit = range.unit;
    }
    out.push_back(std::move(one));
  }
  for (const validity::Range& range : validity::ranges()) {
    FindingKind one;
    one.code = "validity." + range.id;
    one.severity =
        range.grade == validity::ValidityGrade::Note ? Severity::Note : Severity::Warning;
    one.origin = range.motion_only ? "end" : "statics";
    one.meaning = range.law + " outside its range of validity";
    one.quantity = range.quantity;
    one.unit = range.unit;
    one.range = range.id;
    const std::string family = range.id.substr(0, range.id.find('.'));
    one.topic = family == "hertz" || family == "traction" || family == "conformity" ? "contact"
                : family == "film"                                                  ? "film"
                : family == "cage" || family == "hydro"                             ? "cage"
                : family == "life"                                                  ? "life"
                : family == "materials"                                             ? "heat"
                                                                                    : family;
    out.push_back(std::move(one));
  }
  return out;
}

Finding named(const FindingKind& kind, Issue issue) {
  Finding out;
  static_cast<Issue&>(out) = std::move(issue);
  out.code = kind.code;
  out.quantity = kind.quantity;
  out.unit = kind.unit;
  return out;
}

const FindingKind& kind_of(std::string_view code) {
  const FindingKind* kind = find_finding_kind(code);
  if (kind == nullptr) throw InternalError(fmt::format("findings.json has no code \"{}\"", code));
  return *kind;
}

bool begins(std::string_view text, std::string_view start) { return text.starts_with(start); }

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\\');
  return text;
}

}  // namespace

std::span<const FindingKind> finding_kinds() {
  static const std::vector<FindingKind> kKinds = read_register();
  return kKinds;
}

const FindingKind* find_finding_kind(std::string_view code) {
  const auto kinds = finding_kinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const FindingKind& k) { return k.code == code; });
  return found == kinds.end() ? nullptr : &*found;
}

Finding::Finding(Issue issue) {
  const FindingKind& kind = kind_of(
      issue.code.empty() ? fmt::format("deck.{}", severity_word(issue.severity)) : issue.code);
  *this = named(kind, std::move(issue));
}

Finding& Finding::of(std::string which) {
  body = std::move(which);
  return *this;
}

Finding& Finding::measure(double number, std::optional<double> most) {
  measured = number;
  limit = most;
  return *this;
}

Finding& Finding::measure(std::string what, double number, std::string in_unit,
                          std::optional<double> most) {
  quantity = std::move(what);
  unit = std::move(in_unit);
  return measure(number, most);
}

Finding& Finding::at_least(double bound) {
  least = bound;
  return *this;
}

Finding& Finding::at(double seconds) {
  time = seconds;
  return *this;
}

Finding finding_of_range(const validity::Finding& left) {
  Finding out = make_finding("validity." + left.range->id, left.text());
  const auto bound = [&](double si) {
    return std::isnan(si) ? std::nullopt : std::optional<double>(si / left.range->per);
  };
  out.measure(left.value / left.range->per, bound(left.bounds.most)).of(left.body);
  out.least = bound(left.bounds.least);
  if (!std::isnan(left.time)) out.at(left.time);
  return out;
}

Finding make_finding(std::string_view code, std::string sentence) {
  const FindingKind& kind = kind_of(code);
  Issue issue;
  issue.severity = kind.severity;
  issue.message = std::move(sentence);
  return named(kind, std::move(issue));
}

Finding renamed(const Finding& finding, std::string_view code, std::string sentence) {
  const FindingKind& kind = kind_of(code);
  Finding out = finding;
  out.code = kind.code;
  out.severity = kind.severity;
  out.message = std::move(sentence);
  return out;
}

std::vector<Finding> findings_of(std::vector<Issue> issues) {
  std::vector<Finding> out;
  out.reserve(issues.size());
  for (Issue& issue : issues) out.emplace_back(std::move(issue));
  return out;
}

std::vector<std::string> sentences_of(std::span<const Finding> findings) {
  std::vector<std::string> out;
  out.reserve(findings.size());
  for (const Finding& one : findings) out.push_back(one.message);
  return out;
}

std::string_view severity_word(Severity severity) {
  return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "note";
}

nlohmann::ordered_json finding_json(const Finding& finding) {
  nlohmann::ordered_json out;
  out["code"] = finding.code;
  out["severity"] = severity_word(finding.severity);
  out["sentence"] = finding.message;
  const auto text = [&](const char* key, const std::string& value) {
    if (!value.empty()) out[key] = value;
  };
  const auto number = [&](const char* key, const std::optional<double>& value) {
    if (value && std::isfinite(*value)) out[key] = *value;
  };
  if (finding.measured) text("quantity", finding.quantity);
  number("value", finding.measured);
  number("least", finding.least);
  number("limit", finding.limit);
  if (finding.measured) text("unit", finding.unit);
  text("body", finding.body);
  number("time_s", finding.time);
  if (finding.step) out["step"] = *finding.step;
  text("file", finding.file);
  if (finding.line > 0) out["line"] = finding.line;
  text("record", finding.record);
  text("variable", finding.variable);
  text("given", finding.value);
  text("remedy", finding.remedy);
  return out;
}

nlohmann::ordered_json findings_json(std::span<const Finding> findings) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) out.push_back(finding_json(finding));
  return out;
}

std::vector<Finding> read_findings(const nlohmann::json& list) {
  std::vector<Finding> out;
  if (!list.is_array()) return out;
  for (const Json& entry : list) {
    if (out.size() == kMostFindings) break;
    if (!entry.is_object()) continue;
    const auto text = [&](const char* key) {
      const auto found = entry.find(key);
      return found != entry.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    const auto number = [&](const char* key) {
      const auto found = entry.find(key);
      return found != entry.end() && found->is_number()
                 ? std::optional<double>(found->get<double>())
                 : std::nullopt;
    };
    Finding one;
    one.code = text("code");
    one.message = text("sentence");
    if (one.code.empty() || one.message.empty()) continue;
    one.severity = severity_of(text("severity"));
    one.quantity = text("quantity");
    one.measured = number("value");
    one.least = number("least");
    one.limit = number("limit");
    one.unit = text("unit");
    one.body = text("body");
    one.time = number("time_s");
    if (const auto step = entry.find("step"); step != entry.end() && step->is_number_integer())
      one.step = step->get<long>();
    one.file = text("file");
    if (const auto line = entry.find("line"); line != entry.end() && line->is_number_integer())
      one.line = line->get<int>();
    one.record = text("record");
    one.variable = text("variable");
    one.value = text("given");
    one.remedy = text("remedy");
    out.push_back(std::move(one));
  }
  return out;
}

std::vector<Finding> shown_findings(std::span<const Finding> findings) {
  std::vector<Finding> out;
  Finding notes;
  for (const Finding& one : findings) {
    const FindingKind* kind = find_finding_kind(one.code);
    const bool quiet = kind != nullptr && kind->quiet && one.severity == Severity::Note;
    if (one.severity == Severity::Error || quiet) continue;
    if (one.severity != Severity::Note || !begins(one.code, "validity.")) {
      out.push_back(one);
      continue;
    }
    // "Film thickness: ratio 0.1 at ... (range up to 0.003). Consequence." without the consequence
    std::string words = one.message.substr(0, one.message.find("). ") + 1);
    if (!words.empty() && words[0] >= 'A' && words[0] <= 'Z')
      words[0] = static_cast<char>(words[0] - 'A' + 'a');
    if (notes.message.empty()) {
      notes = one;
      notes.message = "Laws outside their range of validity: " + words;
    } else {
      notes.message += "; " + words;
    }
  }
  if (notes.message.empty()) return out;
  notes.message += ".";
  out.push_back(std::move(notes));
  return out;
}

const Finding* worst_finding(std::span<const Finding> findings) {
  const Finding* worst = nullptr;
  for (const Finding& one : findings)
    if (worst == nullptr || one.severity > worst->severity) worst = &one;
  return worst;
}

std::string findings_line(std::span<const Finding> findings) {
  const Finding* const worst = worst_finding(findings);
  if (worst == nullptr) return "No findings.";
  std::array<long, 3> count{};
  for (const Finding& one : findings) ++count.at(static_cast<std::size_t>(one.severity));
  std::string out;
  for (const Severity severity : {Severity::Error, Severity::Warning, Severity::Note})
    if (const long n = count.at(static_cast<std::size_t>(severity)); n > 0)
      out += (out.empty() ? "" : ", ") + counted(n, std::string(severity_word(severity)));
  if (worst->severity == Severity::Note) return out + ".";
  return out + ". Worst: " + worst->message;
}

std::string finding_codes_page() {
  std::string out =
      "# Codes of findings\n\nCreated by `adore check --codes`. Every finding has one of these "
      "codes, in `findings` of RUN.json,\nRESULTS.h5, Python and JSON output. The column "
      "\"origin\" names the part of Adore that reports the finding:\ncheck, statics, plan, run, "
      "end (of a "
      "run) or study.\nA finding has `code`, `severity` and `sentence`. Where they apply, it also "
      "has `quantity`, `value`,\n`least`, `limit`, `unit`, `body`, `time_s`, "
      "`step`, `file`, `line`, `record`, `variable`,\n`given` (value in the deck) and "
      "`remedy`.\n\n| code | severity | origin | meaning | quantity | unit "
      "|\n|---|---|---|---|---|---|\n";
  for (const FindingKind& kind : finding_kinds())
    out +=
        fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", kind.code, severity_word(kind.severity),
                    kind.origin, cell(kind.meaning), cell(kind.quantity), kind.unit);
  return out;
}

}  // namespace adore
