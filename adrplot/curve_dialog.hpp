#pragma once

#include "adrplot/own_chart.hpp"

#include <QDialog>

class QComboBox;
class QTreeWidget;
class QTreeWidgetItem;

namespace adore::adrplot {

/// Every curve of every open file, to be ticked for one chart. Differences are from one of the
/// ticked curves: from the one that was ticked first, unless another one is chosen.
class CurveDialog : public QDialog {
  Q_OBJECT
 public:
  /// `files` live as long as the dialog.
  CurveDialog(const std::vector<const PlotDocument*>& files, const PageOptions& options,
              QWidget* parent = nullptr);
  /// As they stand in the tree; of differences the reference first.
  [[nodiscard]] std::vector<CurvePick> picks() const;
  [[nodiscard]] Combine how() const;

 private:
  void offerReferences();

  std::vector<const PlotDocument*> files_;
  QTreeWidget* tree_;
  QComboBox* how_;
  QComboBox* reference_;
  std::vector<QTreeWidgetItem*> order_;  ///< of ticking
  QTreeWidgetItem* chosen_ = nullptr;    ///< as reference; none: the first of them
};

}  // namespace adore::adrplot
