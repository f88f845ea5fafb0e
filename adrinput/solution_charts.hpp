#pragma once

#include "results/static_tables.hpp"

#include <QWidget>

class QComboBox;
class QLabel;
class QScrollArea;

namespace adore::desktop {
class ChartView;
}

namespace adore::adrinput {

/// Charts of a quasi-static solution next to the form: load distribution, contact ellipses in the
/// grooves, and other pages of AdrPlot.
class SolutionCharts : public QWidget {
  Q_OBJECT
 public:
  explicit SolutionCharts(QWidget* parent = nullptr);

  /// Keeps the current page if the new solution has it.
  void setSolution(const results::StaticTables& tables);
  /// The deck has no solution.
  void invalidateResult();
  /// The deck changed since.
  void setStale(bool stale);
  [[nodiscard]] QStringList pages() const;
  void choosePage(int index);
  /// Size of the area for a complete chart, without horizontal scrolling.
  [[nodiscard]] int fullChartWidth() const;
  [[nodiscard]] desktop::ChartView& view() { return *view_; }

 private:
  void showPage(int index);

  QComboBox* page_box_;
  QLabel* note_;
  desktop::ChartView* view_;
  QScrollArea* scroll_area_;
  results::StaticTables tables_;
};

}  // namespace adore::adrinput
