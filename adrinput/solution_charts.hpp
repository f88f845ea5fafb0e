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

  /// Keeps the page that was shown where the new solution has it too.
  void setSolution(const results::StaticTables& tables);
  /// There is no solution of the deck that is here.
  void forget();
  /// The deck changed since.
  void setStale(bool stale);
  [[nodiscard]] QStringList pages() const;
  void choosePage(int index);
  /// Of this place when a chart is whole in it, without scrolling sideways.
  [[nodiscard]] int wholeWidth() const;
  [[nodiscard]] desktop::ChartView& view() { return *view_; }

 private:
  void showPage(int index);

  QComboBox* choice_;
  QLabel* note_;
  desktop::ChartView* view_;
  QScrollArea* area_;
  results::StaticTables tables_;
};

}  // namespace adore::adrinput
