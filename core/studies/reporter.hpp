#pragma once

#include "studies/campaign.hpp"
#include "studies/charts.hpp"
#include "studies/report.hpp"

#include <limits>
#include <string>
#include <utility>
#include <vector>

/// Parts of make_report(): what each kind of study says of its table.
namespace adore::studies {

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A column's name as part of a file name.
[[nodiscard]] std::string file_name(std::string text);
[[nodiscard]] std::vector<double> sorted_values(const std::vector<double>& values);
/// "-" for missing values.
[[nodiscard]] std::string number(double value, int digits = 5);

class Reporter {
 public:
  Reporter(const Study& study, const Results& results, const StudyTable& table);
  Report make();

 private:
  // report.cpp
  void head();
  /// Variables without effect.
  void no_part();
  void failures();
  /// Number of runs with each code.
  void findings();
  /// Rows where `variable` has that value, for every given pair.
  [[nodiscard]] std::vector<std::size_t> rows_at(
      const std::vector<std::pair<const TableColumn*, double>>& where) const;
  [[nodiscard]] std::vector<long> numbers_of(const std::vector<std::size_t>& rows) const;
  static std::vector<double> picked(const TableColumn& column,
                                    const std::vector<std::size_t>& rows);
  static std::string label(const TableColumn& column);
  [[nodiscard]] const TableColumn& column_of(const Variable& variable) const;
  /// Its column; of a lot the mean of its elements.
  [[nodiscard]] TableColumn shown_of(const Variable& variable) const;
  /// A lot has one axis.
  [[nodiscard]] std::vector<TableColumn> shown_variables() const;
  void parallel(long heavy);

  // report_statistics.cpp
  void statistics();
  /// Share of the runs below each value.
  void distribution(const TableColumn& column);
  /// Curves over the first grid, one for each value of the second, bands where samples scatter.
  void over_grids();
  /// Rows of each point of the grids: what scatters there, scatters there alone.
  [[nodiscard]] std::vector<std::vector<std::size_t>> grid_points() const;
  /// Rank correlation of what scatters with what comes of it, the mean over the points of the
  /// grids.
  void influence();

  // report_cage_map.cpp
  void cage_map();

  // report_comparisons.cpp
  void sensitivity(std::size_t deck);
  void worst_case();
  void what_if();

  const Study& study_;
  const Results& results_;
  const StudyTable& table_;
  std::vector<const Variable*> grids_, randoms_;
  std::string text_;
  Chart charts_ = Chart::array();
};

}  // namespace adore::studies
