#pragma once

#include "adrplot/own_chart.hpp"

#include <QDialog>

class QComboBox;
class QTreeWidget;
class QTreeWidgetItem;

namespace adore::adrplot {

/// Selection in the dialog, kept for the next time: curves in the order in which they were checked.
struct CurveChoice {
  struct Curve {
    std::filesystem::path file;
    int page = 1;
    std::size_t panel = 0, curve = 0;
    bool reference = false;  ///< chosen to be the one that the others are less
  };
  std::vector<Curve> curves = {};
  Combine how = Combine::Overlay;
};

/// Every curve of every open file, to be ticked for one chart. Differences are from one of the
/// ticked curves: from the one that was ticked first, unless another one is chosen.
class CurveDialog : public QDialog {
  Q_OBJECT
 public:
  /// `files` must outlive the dialog. Curves of `before` are checked if their file is open.
  CurveDialog(const std::vector<const PlotDocument*>& files, const PageOptions& options,
              const CurveChoice& before = {}, QWidget* parent = nullptr);
  /// In the order of the tree; for differences the reference first.
  [[nodiscard]] std::vector<CurvePick> picks() const;
  [[nodiscard]] Combine how() const;
  [[nodiscard]] CurveChoice choice() const;

 private:
  void fillReferenceBox();
  void checkCurves(const CurveChoice& before);

  std::vector<const PlotDocument*> files_;
  QTreeWidget* tree_;
  QComboBox* combination_box_;
  QComboBox* reference_;
  std::vector<QTreeWidgetItem*> checked_items_;  ///< of ticking
  QTreeWidgetItem* chosen_ = nullptr;            ///< as reference; none: the first one
};

}  // namespace adore::adrplot
