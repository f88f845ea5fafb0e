#include "base/validity.hpp"

#include "base/resources.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace adore::validity {
namespace {

using Json = nlohmann::json;

ValidityGrade grade_of(const std::string& word) {
  if (word == "note") return ValidityGrade::Note;
  if (word == "warning") return ValidityGrade::Warning;
  if (word == "untrusted") return ValidityGrade::Untrusted;
  demand(word == "refused", "validity.json has an unknown severity");
  return ValidityGrade::Refused;
}

std::vector<Range> read() {
  std::vector<Range> out;
  const Json json = Json::parse(resources::get("validity.json"));
  for (const Json& entry : json.at("ranges")) {
    Range one;
    one.id = entry.at("id").get<std::string>();
    one.law = entry.at("law").get<std::string>();
    one.quantity = entry.at("quantity").get<std::string>();
    one.unit = entry.at("unit").get<std::string>();
    one.per = entry.at("per").get<double>();
    const auto bound = [&](const char* key) {
      return entry.at(key).is_null() ? kNoBound : one.per * entry.at(key).get<double>();
    };
    one.bounds = {bound("least"), bound("most")};
    one.bound = entry.value("bound", std::string());
    one.source = entry.at("source").get<std::string>();
    one.consequence = entry.at("consequence").get<std::string>();
    one.grade = grade_of(entry.at("severity").get<std::string>());
    one.motion_only = entry.at("where") == "motion";
    out.push_back(std::move(one));
  }
  return out;
}

std::string bounds_text(const Range& range, const Bounds& bounds) {
  const std::string unit = range.unit.empty() ? "" : " " + range.unit;
  const auto shown = [&](double si) { return fmt::format("{:.4g}", si / range.per); };
  if (std::isnan(bounds.least)) return fmt::format("up to {}{}", shown(bounds.most), unit);
  if (std::isnan(bounds.most)) return fmt::format("from {}{}", shown(bounds.least), unit);
  return fmt::format("{} to {}{}", shown(bounds.least), shown(bounds.most), unit);
}

std::string place_text(const Finding& found) {
  return fmt::format("{}, {}", found.body,
                     std::isnan(found.time) ? std::string("quasi-static solution")
                                            : fmt::format("t = {:.6g} s", found.time));
}

std::string value_text(const Finding& found) {
  const Range& range = *found.range;
  return fmt::format("{} {:.4g}{} at {} (range {}{}{})", range.quantity, found.value / range.per,
                     range.unit.empty() ? "" : " " + range.unit, place_text(found),
                     bounds_text(range, found.bounds), found.detail.empty() ? "" : ", ",
                     found.detail);
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace

std::span<const Range> ranges() {
  static const std::vector<Range> kRanges = read();
  return kRanges;
}

const Range& range(std::string_view id) {
  const auto all = ranges();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Range& r) { return r.id == id; });
  demand(found != all.end(), "validity.json does not have a range with the requested id");
  return *found;
}

std::string Finding::text() const {
  return fmt::format("{}: {}. {}", capitalised(range->law), value_text(*this), range->consequence);
}

Finding& RangeMonitor::find_or_add_finding(const Range& range) {
  const auto found = std::find_if(findings_.begin(), findings_.end(),
                                  [&](const Finding& f) { return f.range == &range; });
  if (found != findings_.end()) return *found;
  findings_.emplace_back().range = &range;
  return findings_.back();
}

double Finding::excess() const noexcept { return RangeMonitor::excess(value, bounds); }

double RangeMonitor::excess(double value, const Bounds& bounds) noexcept {
  return value > bounds.most ? value - bounds.most : bounds.least - value;
}

std::vector<std::pair<Severity, std::string>> remarks(std::span<const Finding> findings) {
  std::vector<std::pair<Severity, std::string>> out;
  std::string notes;
  for (const Finding& found : findings) {
    if (found.range->grade != ValidityGrade::Note)
      out.emplace_back(Severity::Warning, found.text());
    else
      notes +=
          fmt::format("{}{}: {}", notes.empty() ? "" : "; ", found.range->law, value_text(found));
  }
  if (!notes.empty())
    out.emplace_back(Severity::Note, "Laws outside their range of validity: " + notes + ".");
  return out;
}

}  // namespace adore::validity
