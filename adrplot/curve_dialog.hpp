#pragma once

#include "adrplot/own_chart.hpp"

#include <QDialog>

class QComboBox;
class QTreeWidget;

namespace adore::adrplot {

/// Every curve of every open file, to be ticked for one chart.
class CurveDialog : public QDialog {
  Q_OBJECT
 public:
  /// `files` live as long as the dialog.
  CurveDialog(const std::vector<const PlotDocument*>& files, const PageOptions& options,
              QWidget* parent = nullptr);
  [[nodiscard]] std::vector<CurvePick> picks() const;
  [[nodiscard]] Combine how() const;

 private:
  std::vector<const PlotDocument*> files_;
  QTreeWidget* tree_;
  QComboBox* how_;
};

}  // namespace adore::adrplot
