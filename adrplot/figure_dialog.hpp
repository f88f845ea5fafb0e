#pragma once

#include "desktop/chart_page.hpp"
#include "desktop/figure.hpp"

#include <QDialog>

class QCheckBox;
class QDoubleSpinBox;
class QFontComboBox;
class QLabel;
class QPushButton;

namespace adore::adrplot {

/// Dialog for the size, letters, font and style of a figure for print, with a preview. OK is
/// enabled for a figure that can be drawn; values are remembered when it is pressed.
class FigureDialog : public QDialog {
  Q_OBJECT
 public:
  FigureDialog(desktop::ChartPage page, desktop::ChartZoom zoom, QWidget* parent = nullptr);
  [[nodiscard]] desktop::Figure figure() const;

 private:
  void restore();
  void store() const;
  void showPreview();

  desktop::ChartPage page_;
  desktop::ChartZoom zoom_;
  QDoubleSpinBox* width_;
  QDoubleSpinBox* height_;
  QDoubleSpinBox* letters_;
  QFontComboBox* font_;
  QCheckBox* gray_;
  QLabel* preview_;
  QPushButton* ok_;
};

}  // namespace adore::adrplot
