#include "studies/report.hpp"

#include "base/counted.hpp"
#include "base/finding.hpp"
#include "base/json_text.hpp"
#include "runs/prepare.hpp"
#include "studies/reporter.hpp"
#include "studies/study_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

/// The frame of a report, and what its parts share.
namespace adore::studies {
namespace {

constexpr std::size_t kShownFailures = 5;

}  // namespace

std::string file_name(std::string text) {
  for (char& c : text)
    if (c == '/' || c == ' ' || c == '[' || c == ']') c = '_';
  return text;
}

std::vector<double> sorted_unique_values(const std::vector<double>& values) {
  const std::set<double> once(values.begin(), values.end());
  return {once.begin(), once.end()};
}

std::string number(double value, int digits) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}g}", value, digits);
}

Reporter::Reporter(const Study& study, const Results& results, const StudyTable& table)
    : study_(study), results_(results), table_(table) {
  for (const Variable& variable : study.variables)
    (variable.law == Law::Values ? grids_ : random_variables_).push_back(&variable);
}

Report Reporter::make() {
  add_header();
  switch (study_.kind) {
    case Kind::Sweep:
    case Kind::Tolerance:
      statistics();
      if (!grids_.empty()) add_grid_curves();
      if (!random_variables_.empty()) influence();
      parallel(-1);
      break;
    case Kind::CageMap:
      add_cage_map();
      break;
    case Kind::Sensitivity:
      for (std::size_t deck = 0; deck < study_.decks.size(); ++deck) sensitivity(deck);
      break;
    case Kind::WorstCase:
      add_worst_case();
      break;
    case Kind::WhatIf:
      add_what_if();
      break;
  }
  add_unused_variables();
  add_failures();
  findings();
  return {text_, dump_json(charts_, 1) + "\n"};
}

void Reporter::add_header() {
  const auto count = [&](auto&& test) {
    return std::count_if(table_.exit.begin(), table_.exit.end(), test);
  };
  text_ += fmt::format("{}: {}, {}, {} done, {} failed, {} open\n\n",
                       study_.file.filename().string(), kind_name(study_.kind),
                       counted(table_.rows(), "run"), count([](long e) { return e == 0; }),
                       count([](long e) { return e > 0; }), count([](long e) { return e < 0; }));
}

void Reporter::add_unused_variables() {
  if (study_.kind == Kind::WhatIf) return;
  try {
    runs::DeckRequest request;
    request.deck = study_.decks.front();
    const Task& task = results_.tasks.at(results_.tasks.size() / 2);
    request.sets = study_.sets;
    request.sets.insert(request.sets.end(), task.point.sets.begin(), task.point.sets.end());
    for (const auto& none : runs::prepare(request).no_part)
      for (const TableColumn& column : table_.variables)
        if (none.variable == column.name)
          text_ += fmt::format("note: variable {} is varied, but it has no effect: {}\n",
                               none.variable, none.because);
  } catch (const std::exception&) {
    // The runs report the errors.
  }
}

void Reporter::add_failures() {
  std::size_t shown = 0;
  for (std::size_t i = 0; i < table_.rows(); ++i) {
    if (table_.exit[i] <= 0 || ++shown > kShownFailures) continue;
    text_ += fmt::format("run {} failed (exit {}): {}\n", table_.run[i], table_.exit[i],
                         table_.message[i]);
  }
  if (shown > kShownFailures)
    text_ += fmt::format("{} more of the runs failed; RUNS.csv lists the reasons\n",
                         shown - kShownFailures);
}

/// The most severe first, then by number. Quiet notes are left out.
void Reporter::findings() {
  std::map<std::string, long> runs;
  for (const std::optional<Record>& record : results_.records)
    if (record)
      for (const std::string& code : record->codes) ++runs[code];
  struct Line {
    const FindingKind* kind;
    long runs;
  };
  std::vector<Line> lines;
  for (const auto& [code, count] : runs)
    if (const FindingKind* kind = find_finding_kind(code);
        kind != nullptr && !(kind->quiet && kind->severity == Severity::Note))
      lines.push_back({kind, count});
  if (lines.empty()) return;
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) {
    return a.kind->severity != b.kind->severity ? a.kind->severity > b.kind->severity
                                                : a.runs > b.runs;
  });
  text_ += fmt::format("\n{:<8} {:<9} {:<28} {}\n", "runs", "severity", "finding", "meaning");
  for (const Line& line : lines)
    text_ += fmt::format("{:<8} {:<9} {:<28} {}\n", line.runs, severity_word(line.kind->severity),
                         line.kind->code, line.kind->meaning);
}

std::vector<std::size_t> Reporter::rows_with_values(
    const std::vector<std::pair<const TableColumn*, double>>& where) const {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < table_.rows(); ++i)
    if (std::all_of(where.begin(), where.end(),
                    [&](const auto& pair) { return pair.first->values[i] == pair.second; }))
      out.push_back(i);
  return out;
}

std::vector<long> Reporter::run_numbers(const std::vector<std::size_t>& rows) const {
  std::vector<long> out;
  for (const std::size_t i : rows) out.push_back(table_.run[i]);
  return out;
}

std::vector<double> Reporter::values_at_rows(const TableColumn& column,
                                             const std::vector<std::size_t>& rows) {
  std::vector<double> out;
  for (const std::size_t i : rows) out.push_back(column.values[i]);
  return out;
}

std::string Reporter::label(const TableColumn& column) {
  return column.unit.empty() || column.unit == "-"
             ? column.name
             : fmt::format("{} [{}]", column.name, column.unit);
}

const TableColumn& Reporter::column_of(const Variable& variable) const {
  return *table_.find(variable.targets.front());
}

TableColumn Reporter::display_column(const Variable& variable) const {
  TableColumn out = column_of(variable);
  if (!variable.is_group()) return out;
  const auto n = static_cast<double>(variable.targets.size());
  for (std::size_t k = 1; k < variable.targets.size(); ++k) {
    const std::vector<double>& more = table_.find(variable.targets[k])->values;
    for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] += more[i];
  }
  for (double& value : out.values) value /= n;
  out.name = variable.name + " (mean of the elements)";
  return out;
}

std::vector<TableColumn> Reporter::display_columns() const {
  std::vector<TableColumn> out;
  for (const Variable& variable : study_.variables) out.push_back(display_column(variable));
  if (const TableColumn* seeds = table_.find("seed")) out.push_back(*seeds);
  return out;
}

void Reporter::parallel(long heavy) {
  const std::vector<TableColumn> variables = display_columns();
  const std::vector<const TableColumn*> columns = parallel_chart_axes(variables, table_.quantities);
  if (columns.size() > 2 && table_.rows() > 2)
    charts_.push_back(parallel_chart("parallel", columns, heavy, table_.run));
}

Report make_report(const Study& study, const Results& results, const StudyTable& table) {
  return Reporter(study, results, table).make();
}

Report write_report(const Study& study) {
  const Results results = read_results(study);
  const StudyTable table = write_tables(study, results);
  Report report = make_report(study, results, table);
  const WriteFolder folder = open_study_folder(study.folder());
  write_into_study(folder, "REPORT.txt", report.text);
  write_into_study(folder, "CHARTS.json", report.charts);
  return report;
}

}  // namespace adore::studies
