#include "base/find_report.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/spelling.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <tuple>

namespace adore {
namespace {

using Json = nlohmann::ordered_json;

/// NaN: not a finite number.
double number_of(std::string_view text) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double out = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(out) ? out : kNone;
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() || unit == "-" ? fmt::format("{:.10g}", value)
                                     : fmt::format("{:.10g} {}", value, unit);
}

std::string short_with_unit(double value, const std::string& unit) {
  return unit.empty() || unit == "-" ? fmt::format("{:.2g}", value)
                                     : fmt::format("{:.2g} {}", value, unit);
}

std::string target_text(const FindTarget& target) {
  switch (target.relation) {
    case Relation::Least:
      return "least " + target.name;
    case Relation::Largest:
      return "largest " + target.name;
    case Relation::Equal:
    case Relation::AtLeast:
    case Relation::AtMost:
      break;
  }
  const char* const sign = target.relation == Relation::Equal     ? "="
                           : target.relation == Relation::AtLeast ? ">="
                                                                  : "<=";
  return fmt::format("{} {} {}", target.name, sign, with_unit(target.value, target.unit));
}

std::string bound_word(const FindReport& report, double x) {
  const auto& samples = report.outcome.samples;
  if (x == samples.front().x) return ", the lower bound";
  if (x == samples.back().x) return ", the upper bound";
  return "";
}

std::string end_word(bool bound, bool failure, const char* name) {
  return bound     ? fmt::format(" (the {} bound)", name)
         : failure ? std::string(" (end of the computed part)")
                   : std::string();
}

std::string solution_line(const FindReport& report, const FindSolution& one) {
  const FindUnknown& x = report.unknown;
  const FindTarget& y = report.target;
  const std::string at = fmt::format("{} = {}", x.name, with_unit(one.x, x.unit));
  const std::string value = fmt::format("{} = {}", y.name, with_unit(one.value, y.unit));
  const std::string width =
      one.width > 0.0 ? fmt::format(" (tolerance {})", short_with_unit(one.width, x.unit)) : "";
  switch (one.kind) {
    case FindSolutionKind::Crossing:
      return fmt::format("{}{}: {}", at, width, value);
    case FindSolutionKind::Touch:
      return fmt::format("{}{}: {}. The result touches the target without crossing it", at, width,
                         value);
    case FindSolutionKind::Extremum:
      return fmt::format(
          "{}{}: {}{}", at, width, value,
          one.from_bound || one.to_bound
              ? fmt::format(
                    ". The best value is at the {} bound; a better value may be beyond this bound",
                    one.from_bound ? "lower" : "upper")
          : one.from_failure || one.to_failure
              ? std::string(". The result could not be computed at a point next to this value")
              : std::string());
    case FindSolutionKind::Range:
      break;
  }
  return fmt::format("{}{}: {}. The target is met from {}{} to {}{}", at, width, value,
                     with_unit(one.from, x.unit),
                     end_word(one.from_bound, one.from_failure, "lower"), with_unit(one.to, x.unit),
                     end_word(one.to_bound, one.to_failure, "upper"));
}

Json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? Json() : Json(value > 0.0 ? "inf" : "-inf");
}

const char* kind_word(FindSolutionKind kind) {
  constexpr std::array<const char*, 4> words{"crossing", "touch", "range", "extremum"};
  return words.at(static_cast<std::size_t>(kind));
}

Json solution_json(const FindSolution& one) {
  Json out{{"value", one.x},
           {"kind", kind_word(one.kind)},
           {"tolerance", one.width},
           {"target", number(one.value)}};
  const auto end = [](bool bound, bool failure) {
    return bound ? "bound" : failure ? "not computed" : "solution";
  };
  if (one.kind == FindSolutionKind::Range) {
    out["from"] = one.from;
    out["to"] = one.to;
    out["from_end"] = end(one.from_bound, one.from_failure);
    out["to_end"] = end(one.to_bound, one.to_failure);
  } else if (one.kind == FindSolutionKind::Extremum) {
    out["at_bound"] = one.from_bound || one.to_bound;
  }
  return out;
}

const char* relation_word(Relation relation) {
  constexpr std::array<const char*, 5> words{"=", ">=", "<=", "least", "largest"};
  return words.at(static_cast<std::size_t>(relation));
}

}  // namespace

std::pair<double, double> parse_bounds(std::string_view what, std::string_view text) {
  const std::size_t colon = text.find(':');
  const double first = number_of(text.substr(0, std::min(colon, text.size())));
  const double last =
      number_of(colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1));
  if (!(first < last))
    throw InputError(fmt::format(
        "{}{}: the bounds must be two numbers, the lower one first. Write lower:upper, for "
        "example 10:2000.",
        what, text));
  return {first, last};
}

FindUnknown parse_unknown(std::string_view text) {
  const std::size_t equal = text.find('=');
  if (equal == std::string_view::npos || equal == 0)
    throw InputError(fmt::format(
        "the unknown \"{}\" has no name or no bounds. Write NAME=lower:upper, for example "
        "appLoadX=10:2000.",
        text));
  FindUnknown out;
  out.name = text.substr(0, equal);
  std::tie(out.first, out.last) =
      parse_bounds(fmt::format("unknown {} = ", out.name), text.substr(equal + 1));
  return out;
}

FindTarget parse_target(std::string_view text) {
  const std::size_t equal = text.find('=');
  if (equal == std::string_view::npos || equal == 0)
    throw InputError(fmt::format(
        "the target \"{}\" has no name or no value. Write NAME=value, NAME>=value, NAME<=value, "
        "NAME=least or NAME=largest.",
        text));
  FindTarget out;
  const char before = text[equal - 1];
  out.relation = before == '>'   ? Relation::AtLeast
                 : before == '<' ? Relation::AtMost
                                 : Relation::Equal;
  out.name = text.substr(0, out.relation == Relation::Equal ? equal : equal - 1);
  const std::string_view value = text.substr(equal + 1);
  if (out.relation == Relation::Equal && (value == "least" || value == "largest")) {
    out.relation = value == "least" ? Relation::Least : Relation::Largest;
    return out;
  }
  out.value = number_of(value);
  if (std::isnan(out.value) || out.name.empty())
    throw InputError(
        fmt::format("target {}: \"{}\" is not a number. Write NAME=value, NAME>=value, "
                    "NAME<=value, NAME=least or NAME=largest.",
                    text, value));
  return out;
}

std::string unknown_name_message(std::string_view kind, std::string_view name,
                                 const std::vector<std::string>& known) {
  constexpr std::size_t kSuggestions = 3;
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& one : known) {
    const std::size_t letters = edit_distance(name, one);
    if (letters <= std::max<std::size_t>(2, name.size() / 3) ||
        (name.size() > 3 && one.find(name) != std::string::npos))
      near.emplace_back(letters, one);
  }
  std::sort(near.begin(), near.end());
  if (near.size() > kSuggestions) near.resize(kSuggestions);
  std::string list;
  if (near.empty())
    for (const std::string& one : known) list += (list.empty() ? "" : ", ") + one;
  else
    for (const auto& [letters, one] : near) list += (list.empty() ? "" : ", ") + one;
  return fmt::format("there is no {} \"{}\". {} {}.", kind, name,
                     near.empty() ? "Choose one of" : "Did you mean", list);
}

std::string_view answer_keyword(FindAnswer answer) {
  constexpr std::array<std::string_view, 6> words{"one",        "not_monotonic", "many",
                                                  "everywhere", "none",          "not_computed"};
  return words.at(static_cast<std::size_t>(answer));
}

int answer_exit_code(FindAnswer answer) {
  switch (answer) {
    case FindAnswer::One:
      return 0;
    case FindAnswer::None:
      return 1;
    case FindAnswer::NotComputed:
      return 3;
    case FindAnswer::Many:
    case FindAnswer::Everywhere:
      return 4;
    case FindAnswer::NotMonotonic:
      break;
  }
  return 5;
}

std::string question_text(const FindReport& report) {
  const FindUnknown& x = report.unknown;
  return fmt::format("{} from {:.10g} to {}: {}", x.name, x.first, with_unit(x.last, x.unit),
                     target_text(report.target));
}

std::vector<std::string> answer_lines(const FindReport& report) {
  const FindOutcome& outcome = report.outcome;
  const FindUnknown& x = report.unknown;
  const FindTarget& y = report.target;
  std::vector<std::string> out;
  const auto best = [&] {
    out.push_back(fmt::format(
        "Best value: {} = {} at {} = {}{}.", y.name, with_unit(outcome.best.value, y.unit), x.name,
        with_unit(outcome.best.x, x.unit), bound_word(report, outcome.best.x)));
  };
  switch (outcome.answer) {
    case FindAnswer::One:
      out.push_back(solution_line(report, outcome.solutions.front()) + ".");
      break;
    case FindAnswer::NotMonotonic:
      out.push_back(solution_line(report, outcome.solutions.front()) + ".");
      out.push_back(
          fmt::format("One solution was found, but the result is not monotonic. There may be "
                      "more solutions between the {} computed points.",
                      outcome.samples.size()));
      break;
    case FindAnswer::Many:
      out.push_back(fmt::format("{} solutions:", outcome.solutions.size()));
      for (const FindSolution& one : outcome.solutions)
        out.push_back("  " + solution_line(report, one) + ".");
      break;
    case FindAnswer::Everywhere:
      out.push_back(fmt::format("Every value of {} between the bounds meets the target.", x.name));
      break;
    case FindAnswer::None:
      out.push_back(fmt::format("No solution for {} from {:.10g} to {}.", x.name, x.first,
                                with_unit(x.last, x.unit)));
      best();
      break;
    case FindAnswer::NotComputed:
      out.push_back(fmt::format(
          "No solution was found, but the result could not be computed for all values of {}.",
          x.name));
      best();
      break;
  }
  if (outcome.constant) {
    out.push_back(fmt::format("{} does not depend on {} between the bounds.", y.name, x.name));
  } else if (!outcome.turns.empty()) {
    std::string list;
    constexpr std::size_t kListed = 5;
    for (std::size_t k = 0; k < std::min(outcome.turns.size(), kListed); ++k)
      list += fmt::format("{}{:.6g}", k == 0 ? "" : ", ", outcome.turns[k]);
    out.push_back(fmt::format("{} is not monotonic: it has an extremum near {} = {}{}{}.", y.name,
                              x.name, list, outcome.turns.size() > kListed ? " ..." : "",
                              x.unit.empty() || x.unit == "-" ? "" : " " + x.unit));
  }
  for (const FindJump& jump : outcome.jumps)
    out.push_back(
        fmt::format("{} jumps at {} = {} from {} to {}; it does not take the values in "
                    "between.",
                    y.name, x.name, with_unit(jump.before, x.unit),
                    with_unit(jump.value_before, y.unit), with_unit(jump.value_after, y.unit)));
  for (const FindFailure& failure : outcome.failures)
    out.push_back(fmt::format("Not computed for {} from {:.6g} to {}: {}", x.name, failure.from,
                              with_unit(failure.to, x.unit), failure.reason));
  return out;
}

Json find_report_json(const FindReport& report) {
  const FindOutcome& outcome = report.outcome;
  Json out{{"source", report.source},
           {"unknown",
            {{"name", report.unknown.name},
             {"unit", report.unknown.unit},
             {"first", report.unknown.first},
             {"last", report.unknown.last}}},
           {"target",
            {{"name", report.target.name},
             {"unit", report.target.unit},
             {"relation", relation_word(report.target.relation)}}},
           {"answer", answer_keyword(outcome.answer)}};
  if (report.target.relation != Relation::Least && report.target.relation != Relation::Largest)
    out["target"]["value"] = report.target.value;
  if (outcome.solutions.size() == 1) {
    out["solution"] = solution_json(outcome.solutions.front());
  } else if (!outcome.solutions.empty()) {
    out["solutions"] = Json::array();
    for (const FindSolution& one : outcome.solutions)
      out["solutions"].push_back(solution_json(one));
  } else {
    out["best"] = {{"value", outcome.best.x},
                   {"target", number(outcome.best.value)},
                   {"at_bound", !bound_word(report, outcome.best.x).empty()}};
  }
  out["monotonic"] = outcome.monotonic;
  out["constant"] = outcome.constant;
  out["turns"] = outcome.turns;
  out["jumps"] = Json::array();
  for (const FindJump& jump : outcome.jumps)
    out["jumps"].push_back({{"before", jump.before},
                            {"after", jump.after},
                            {"target_before", number(jump.value_before)},
                            {"target_after", number(jump.value_after)}});
  out["not_computed"] = Json::array();
  for (const FindFailure& failure : outcome.failures)
    out["not_computed"].push_back(
        {{"from", failure.from}, {"to", failure.to}, {"reason", failure.reason}});
  out["scan"] = Json::array();
  for (const FindSample& sample : outcome.samples)
    out["scan"].push_back({{"value", sample.x}, {"target", number(sample.value)}});
  return out;
}

}  // namespace adore
