#include "validation/experiments.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::validation {
namespace {

std::string figure(const std::optional<double>& value) {
  return value ? fmt::format("{:.5g}", *value) : "-";
}

std::string ours_text(const ExperimentRow& row) {
  return row.failed.empty() ? figure(row.ours) : row.failed;
}

std::string theirs_text(const ExperimentRow& row) {
  if (!row.their_text.empty()) return row.their_text;
  if (row.type == RowType::Sign && !row.their_sign.empty())
    return row.their_sign == "0" ? "no effect" : row.their_sign == "+" ? "> 0" : "< 0";
  if (!row.theirs) return row.kept_aside() ? "kept aside" : "-";
  if (row.theirs_to) return fmt::format("{:.5g} to {:.5g}", *row.theirs, *row.theirs_to);
  return (row.type == RowType::Bound ? "<= " : "") + fmt::format("{:.5g}", *row.theirs);
}

std::string deviation_text(const ExperimentRow& row) {
  if (const std::optional<double> d = row.deviation()) return fmt::format("{:+.1f} %", 100.0 * *d);
  if (const std::optional<bool> agrees = row.agrees())
    return row.type == RowType::Bound ? (*agrees ? "within" : "beyond")
                                      : (*agrees ? "same sign" : "other sign");
  return "-";
}

/// Of sorted values, linear between them.
double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0.0;
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

template <class Counts>
ExperimentGroup group_of(const std::vector<Experiment>& experiments, std::string name,
                         Counts counts) {
  std::vector<double> deviations;
  for (const Experiment& one : experiments)
    for (const ExperimentRow& row : one.rows)
      if (const std::optional<double> d = row.deviation(); d && counts(row))
        deviations.push_back(std::abs(*d));
  std::sort(deviations.begin(), deviations.end());
  return {std::move(name), static_cast<int>(deviations.size()), quantile(deviations, 0.5),
          quantile(deviations, 0.9)};
}

void count_row(const ExperimentRow& row, ExperimentSummary& out) {
  if (row.not_computed()) {
    ++out.not_computed;
  } else if (!row.failed.empty()) {
    ++out.failed;
  } else if (row.kind == "part") {
    ++out.parts;
  } else if (row.kept_aside()) {
    ++out.kept_aside;
  } else if (const std::optional<bool> agrees = row.agrees()) {
    ++(row.type == RowType::Bound ? out.bounds : out.signs);
    if (*agrees) ++(row.type == RowType::Bound ? out.bounds_held : out.signs_agree);
  }
}

/// Lines of the summary behind the table of groups.
std::vector<std::string> summary_lines(const ExperimentSummary& s) {
  std::vector<std::string> out{
      fmt::format(
          "{} of {} bounds are satisfied, and {} of {} trends have the same sign as in the source.",
          s.bounds_held, s.bounds, s.signs_agree, s.signs),
      fmt::format("Blind rows (the measured value is withheld): {}. Rows not computed: {}. Failed "
                  "rows: {}. Rows that are parts of other rows: {}.",
                  s.kept_aside, s.not_computed, s.failed, s.parts)};
  out.insert(out.end(), s.remarks.begin(), s.remarks.end());
  return out;
}

}  // namespace

ExperimentSummary summarize(const std::vector<Experiment>& experiments) {
  ExperimentSummary out;
  out.groups = {
      group_of(experiments, "calibration",
               [](const ExperimentRow& row) { return row.kind == "calibration"; }),
      group_of(experiments, "prediction",
               [](const ExperimentRow& row) { return row.kind == "prediction" && !row.model; }),
      group_of(experiments, "prediction of an engineering model",
               [](const ExperimentRow& row) { return row.kind == "prediction" && row.model; })};
  for (const Experiment& one : experiments) {
    for (const ExperimentRow& row : one.rows) count_row(row, out);
    for (const ParameterData& p : one.parameters)
      if (p.at_bound())
        out.remarks.push_back(
            fmt::format("{}: parameter {} = {:.4g} is at its bound ({:g} to {:g}). This indicates "
                        "missing physics, not a good fit.",
                        one.id, p.name, p.value, p.low, p.high));
    for (const std::string& text : one.inputs)
      out.remarks.push_back(fmt::format("{}, {}.", one.id, text));
  }
  return out;
}

std::string experiments_text(const std::vector<Experiment>& experiments) {
  const ExperimentSummary summary = summarize(experiments);
  std::string out =
      fmt::format("{:<36} {:>6} {:>9} {:>9}\n", "rows with a deviation", "rows", "median", "90 %");
  for (const ExperimentGroup& one : summary.groups)
    out += fmt::format("{:<36} {:>6} {:>7.1f} % {:>7.1f} %\n", one.name, one.rows,
                       100.0 * one.median, 100.0 * one.ninth);
  for (const std::string& line : summary_lines(summary)) out += line + "\n";
  for (const Experiment& one : experiments) {
    out += fmt::format("\n{}: {}\n  {}\n", one.id, one.source, one.about);
    for (const std::string& text : one.assumed) out += fmt::format("  assumed: {}\n", text);
    for (const ParameterData& p : one.parameters)
      out += fmt::format("  parameter {} = {:.4g} (bounds {:g} to {:g}{}): {}\n", p.name, p.value,
                         p.low, p.high, p.at_bound() ? ", at its bound" : "", p.meaning);
    for (const std::string& text : one.inputs) out += fmt::format("  {}\n", text);
    if (!one.rows.empty())
      out +=
          fmt::format("  {:<24} {:<30} {:>11} {:>20} {:<5} {:>10}  {:<12} {}\n", "condition",
                      "quantity", "computed", "source", "unit", "deviation", "kind", "certainty");
    for (const ExperimentRow& row : one.rows) {
      out += fmt::format("  {:<24} {:<30} {:>11} {:>20} {:<5} {:>10}  {:<12} {}\n", row.condition,
                         row.what, figure(row.ours), theirs_text(row), row.unit,
                         deviation_text(row), row.kind, row.certainty);
      if (!row.failed.empty()) out += fmt::format("    {}\n", row.failed);
    }
    if (!one.open.empty()) out += fmt::format("  open: {}\n", one.open);
  }
  return out;
}

std::string experiments_markdown(const std::vector<Experiment>& experiments) {
  std::string out =
      "# Published experiments\n\nWritten by `adore validate --experiments --markdown`; the decks "
      "and the data of the sources are in `resources/experiments`. A\n*calibration* row was used "
      "to fit the parameters of its experiment. A *prediction* row was not used. The column "
      "\"certainty of source\"\nshows whether the source value is second-hand. All deviations are "
      "printed as computed.\n\n| "
      "rows with a deviation | rows | median | 90th percentile |\n|---|---|---|---|\n";
  const ExperimentSummary summary = summarize(experiments);
  for (const ExperimentGroup& one : summary.groups)
    out += fmt::format("| {} | {} | {:.1f} % | {:.1f} % |\n", one.name, one.rows,
                       100.0 * one.median, 100.0 * one.ninth);
  out += "\n";
  for (const std::string& line : summary_lines(summary)) out += fmt::format("- {}\n", line);
  for (const Experiment& one : experiments) {
    out += fmt::format("\n## {}\n\n{}. {}\n", one.id, one.source, one.about);
    if (!one.decks.empty()) {
      out += "\nDecks:";
      for (const std::string& deck : one.decks) {
        const bool example = deck.find('/') != std::string::npos;
        out += fmt::format(" [`{0}.txt`](../{1}{0}.txt)", deck, example ? "" : "experiments/");
      }
      out += "\n";
    }
    if (!one.parameters.empty()) {
      out += "\n| parameter | value | bounds | meaning |\n|---|---|---|---|\n";
      for (const ParameterData& p : one.parameters)
        out += fmt::format("| {} | {:.4g}{} | {:g} to {:g} | {} |\n", p.name, p.value,
                           p.at_bound() ? ", **at its bound**" : "", p.low, p.high, p.meaning);
    }
    if (!one.assumed.empty()) out += "\nAssumptions where the source gives no value:\n\n";
    for (const std::string& text : one.assumed) out += fmt::format("- {}\n", text);
    for (const std::string& text : one.inputs) out += fmt::format("\n**{}**\n", text);
    if (!one.rows.empty())
      out +=
          "\n| condition | quantity | computed | source | unit | deviation | kind | certainty of "
          "source |\n|---|---|---|---|---|---|---|---|\n";
    for (const ExperimentRow& row : one.rows)
      out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.condition, row.what,
                         ours_text(row), theirs_text(row), row.unit, deviation_text(row), row.kind,
                         row.certainty);
    if (!one.open.empty()) out += fmt::format("\nOpen: {}\n", one.open);
  }
  return out;
}

nlohmann::ordered_json experiments_json(const std::vector<Experiment>& experiments) {
  using Json = nlohmann::ordered_json;
  Json out = Json::array();
  const auto number = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  for (const Experiment& one : experiments) {
    Json entry{{"id", one.id},           {"source", one.source},        {"about", one.about},
               {"assumed", one.assumed}, {"parameters", Json::array()}, {"decks", one.decks},
               {"inputs", one.inputs},   {"rows", Json::array()},       {"open", one.open}};
    for (const ParameterData& p : one.parameters)
      entry["parameters"].push_back({{"name", p.name},
                                     {"value", p.value},
                                     {"low", p.low},
                                     {"high", p.high},
                                     {"at bound", p.at_bound()},
                                     {"meaning", p.meaning}});
    for (const ExperimentRow& row : one.rows) {
      constexpr const char* kTypes[] = {"value", "bound", "sign"};
      const std::optional<bool> agrees = row.agrees();
      entry["rows"].push_back({{"condition", row.condition},
                               {"what", row.what},
                               {"unit", row.unit},
                               {"type", kTypes[static_cast<std::size_t>(row.type)]},
                               {"ours", number(row.ours)},
                               {"theirs", row.type == RowType::Sign ? Json(row.their_sign)
                                          : row.their_text.empty()  ? number(row.theirs)
                                                                    : Json(row.their_text)},
                               {"theirs_to", number(row.theirs_to)},
                               {"deviation", number(row.deviation())},
                               {"agrees", agrees ? Json(*agrees) : Json(nullptr)},
                               {"kind", row.kind},
                               {"certainty", row.certainty},
                               {"failed", row.failed}});
    }
    out.push_back(std::move(entry));
  }
  return out;
}

}  // namespace adore::validation
