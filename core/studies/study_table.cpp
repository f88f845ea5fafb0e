#include "studies/study_table.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "runs/run_ending.hpp"
#include "studies/study_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::studies {
namespace {

std::string heading(const TableColumn& column) {
  return column.unit.empty() || column.unit == "-"
             ? column.name
             : fmt::format("{} [{}]", column.name, column.unit);
}

std::string field(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

}  // namespace

const TableColumn* StudyTable::find(const std::string& name) const {
  for (const auto* columns : {&variables, &quantities})
    for (const TableColumn& column : *columns)
      if (column.name == name) return &column;
  return nullptr;
}

namespace {

/// The runs are those of the study: reports find them by their place in the list. The points of a
/// search depend on its results, so that only their number of values is known.
void check_tasks(const Study& study, const std::vector<Task>& tasks) {
  const auto refuse = [&](const std::string& problem) {
    throw InputError(fmt::format(
        "{}: {}. The study file was changed after the start, or the list is damaged: start the "
        "study again with `adore study run`; finished runs are kept.",
        (study.folder() / "tasks.jsonl").string(), problem));
  };
  if (study.kind == Kind::WorstCase) {
    const std::size_t values = columns_of(study).names.size();
    for (const Task& task : tasks)
      if (task.point.values.size() != values)
        refuse(fmt::format("run {} has {}, but the number of variables of the study is {}",
                           task.number, counted(task.point.values.size(), "value"), values));
    return;
  }
  const std::vector<Point> points = make_points(study);
  if (tasks.size() != points.size())
    refuse(fmt::format("the file lists {}, but the study has {}", counted(tasks.size(), "run"),
                       points.size()));
  // A program of another version may differ in the last digit.
  constexpr double kSameValueTolerance = 1e-9;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point &is = tasks[i].point, &expected = points[i];
    const auto same = [](double a, double b) {
      return std::abs(a - b) <= kSameValueTolerance * std::max(std::abs(a), std::abs(b));
    };
    if (is.deck != expected.deck || is.label != expected.label ||
        !std::equal(is.values.begin(), is.values.end(), expected.values.begin(),
                    expected.values.end(), same))
      refuse(
          fmt::format("line {}, run {}: the run does not match the study", i + 1, tasks[i].number));
  }
}

}  // namespace

StudyTable make_table(const Study& study, const Results& results) {
  check_tasks(study, results.tasks);
  StudyTable out;
  const Columns columns = columns_of(study);
  runs::DeckRequest base;
  base.deck = study.decks.front();
  std::vector<std::string> names = columns.names;
  if (study.kind == Kind::Sensitivity) {
    names.clear();
    for (const Variable& variable : study.variables) names.push_back(variable.name);
  }
  std::string last, unit;
  for (const std::string& name : names) {
    // Elements of a lot share their unit; the deck is read once for them.
    std::string bare = name.substr(0, name.find_first_of("0123456789["));
    if (bare != last) unit = runs::variable_unit(base, name);
    last = bare;
    out.variables.push_back({name, unit, {}});
  }
  for (const Quantity& quantity : study.quantities)
    out.quantities.push_back({quantity.name, quantity.unit, {}});
  for (std::size_t i = 0; i < results.tasks.size(); ++i) {
    const Task& task = results.tasks[i];
    const auto& record = results.records[i];
    out.run.push_back(task.number);
    out.exit.push_back(record ? record->exit_code : -1);
    out.message.push_back(record ? record->message : "");
    if (columns.decks) out.deck.push_back(study.decks.at(task.point.deck).filename().string());
    if (columns.labels) out.label.push_back(task.point.label);
    for (std::size_t k = 0; k < out.variables.size(); ++k)
      out.variables[k].values.push_back(task.point.values.at(k));
    for (std::size_t k = 0; k < out.quantities.size(); ++k)
      out.quantities[k].values.push_back(record && k < record->values.size()
                                             ? record->values[k]
                                             : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

std::string table_csv(const StudyTable& table) {
  std::string out = "run,exit";
  if (!table.deck.empty()) out += ",deck";
  if (!table.label.empty()) out += ",case";
  for (const auto* columns : {&table.variables, &table.quantities})
    for (const TableColumn& column : *columns) out += "," + heading(column);
  out += ",message\n";
  for (std::size_t i = 0; i < table.rows(); ++i) {
    out +=
        fmt::format("{},{}", table.run[i], table.exit[i] < 0 ? "" : fmt::to_string(table.exit[i]));
    if (!table.deck.empty()) out += "," + runs::quoted_message_field(table.deck[i]);
    if (!table.label.empty()) out += "," + runs::quoted_message_field(table.label[i]);
    for (const auto* columns : {&table.variables, &table.quantities})
      for (const TableColumn& column : *columns) out += "," + field(column.values[i]);
    out += "," + runs::quoted_message_field(table.message[i]) + "\n";
  }
  return out;
}

std::string times_csv(const Results& results) {
  std::string out = "run,key,processor [s],wall [s],memory [MB],files [MB],host\n";
  for (std::size_t i = 0; i < results.tasks.size(); ++i) {
    const auto& record = results.records[i];
    if (!record) continue;
    out += fmt::format("{},{},{:.6f},{:.6f},{:.1f},{:.3f},{}\n", results.tasks[i].number,
                       record->key, record->processor, record->wall, record->memory_megabytes,
                       record->disk_megabytes, record->host);
  }
  return out;
}

StudyTable write_tables(const Study& study, const Results& results) {
  StudyTable table = make_table(study, results);
  const WriteFolder folder = open_study_folder(study.folder());
  write_into_study(folder, "RUNS.csv", table_csv(table));
  write_into_study(folder, "TIMES.csv", times_csv(results));
  write_into_study(folder, "STUDY.h5",
                   table_h5(table, kind_name(study.kind), folder.path() / "STUDY.h5"));
  return table;
}

}  // namespace adore::studies
