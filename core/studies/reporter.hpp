#pragma once

#include "base/constants.hpp"
#include "studies/campaign.hpp"
#include "studies/charts.hpp"
#include "studies/report.hpp"

#include <string>
#include <utility>
#include <vector>

/// Parts of make_report(): what each kind of study says of its table.
namespace adore::studies {

/// A column's name as part of a file name.
[[nodiscard]] std::string file_name(std::string text);
[[nodiscard]] std::vector<double> sorted_unique_values(const std::vector<double>& values);
/// "-" for missing values.
[[nodiscard]] std::string number(double value, int digits = 5);

class Reporter {
 public:
  Reporter(const Study& study, const Results& results, const StudyTable& table);
  Report make();

 private:
  // report.cpp
  void add_header();
  /// Variables without effect.
  void add_unused_variables();
  void add_failures();
  /// Number of runs with each code.
  void findings();
  /// Rows where `variable` has that value, for every given pair.
  [[nodiscard]] std::vector<std::size_t> rows_with_values(
      const std::vector<std::pair<const TableColumn*, double>>& where) const;
  [[nodiscard]] std::vector<long> run_numbers(const std::vector<std::size_t>& rows) const;
  static std::vector<double> values_at_rows(const TableColumn& column,
                                            const std::vector<std::size_t>& rows);
  static std::string label(const TableColumn& column);
  [[nodiscard]] const TableColumn& column_of(const Variable& variable) const;
  /// Its column; of a lot the mean of its elements.
  [[nodiscard]] TableColumn display_column(const Variable& variable) const;
  /// A lot has one axis.
  [[nodiscard]] std::vector<TableColumn> display_columns() const;
  void parallel(long heavy);

  // report_statistics.cpp
  void statistics();
  /// Share of the runs below each value.
  void distribution(const TableColumn& column);
  /// Curves over the first grid, one for each value of the second, bands where samples scatter.
  void add_grid_curves();
  /// Rows of each point of the grids: what scatters there, scatters there alone.
  [[nodiscard]] std::vector<std::vector<std::size_t>> rows_by_grid_point() const;
  /// Rank correlation of what scatters with what comes of it, the mean over the points of the
  /// grids.
  void influence();

  // report_cage_map.cpp
  void add_cage_map();

  // report_comparisons.cpp
  void sensitivity(std::size_t deck);
  void add_worst_case();
  void add_what_if();

  const Study& study_;
  const Results& results_;
  const StudyTable& table_;
  std::vector<const Variable*> grids_, random_variables_;
  std::string text_;
  Chart charts_ = Chart::array();
};

}  // namespace adore::studies
