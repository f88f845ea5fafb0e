#pragma once

#include "results/sol_file.hpp"

#include <QDialog>

class QLabel;
class QSpinBox;

namespace adore::adrplot {

/// Dialog for start, end and interval of the stored steps to plot: the whole run by default. Shows
/// the number of steps.
class RangeDialog : public QDialog {
  Q_OBJECT
 public:
  RangeDialog(const QString& file, long stored, QWidget* parent = nullptr);
  [[nodiscard]] results::SolRange range() const;

 private:
  void count();

  QSpinBox* first_step_box_;
  QSpinBox* last_step_box_;
  QSpinBox* step_interval_box_;
  QLabel* count_;
};

}  // namespace adore::adrplot
