#pragma once

#include "results/sol_file.hpp"

#include <QDialog>

class QSpinBox;

namespace adore::adrplot {

/// Start point, end point and interval of the stored steps to plot: 1, 5000 and 1 unless the user
/// says otherwise.
class RangeDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RangeDialog(const QString& file, QWidget* parent = nullptr);
  [[nodiscard]] results::SolRange range() const;

 private:
  QSpinBox* from_;
  QSpinBox* to_;
  QSpinBox* every_;
};

}  // namespace adore::adrplot
