#pragma once

#include "desktop/chart_page.hpp"

#include <QAbstractTableModel>

#include <string>
#include <vector>

/// Statistics of the visible curves of a chart as a table.
namespace adore::adrplot {

/// One curve between two points of the abscissa; values in `unit`.
struct StatisticsRow {
  std::string curve, unit;
  desktop::CurveStatistics values;
  double deviation = 0.0;  ///< standard deviation: sqrt(rms^2 - mean^2)
};

/// Rows of all curves with values there that are not hidden, each in a unit with a prefix that fits
/// its largest value. Maps and pages with equal axes have none.
[[nodiscard]] std::vector<StatisticsRow> statistics_rows(const desktop::ChartPage& page,
                                                         double from, double to);

/// The table as text: a heading, then a line per curve. Separated by tabs, or by commas with quoted
/// names; numbers with all digits.
[[nodiscard]] std::string statistics_text(const std::vector<StatisticsRow>& rows, char separator);

class StatisticsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  using QAbstractTableModel::QAbstractTableModel;
  void setRows(std::vector<StatisticsRow> rows);
  [[nodiscard]] const std::vector<StatisticsRow>& rows() const { return rows_; }
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  std::vector<StatisticsRow> rows_;
};

}  // namespace adore::adrplot
