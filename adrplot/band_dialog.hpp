#pragma once

#include "adrplot/spectrum.hpp"

#include <QDialog>

class QCheckBox;
class QDoubleSpinBox;

namespace adore::adrplot {

/// Dialog for the frequency band of envelopes: automatic, or two frequencies in Hz. OK is enabled
/// for an upper frequency above the lower one; the page reports bands that its curves do not have.
class BandDialog : public QDialog {
  Q_OBJECT
 public:
  explicit BandDialog(const PassBand& band, QWidget* parent = nullptr);
  [[nodiscard]] PassBand band() const;

 private:
  QCheckBox* automatic_check_box_;
  QDoubleSpinBox* low_frequency_box_;
  QDoubleSpinBox* high_frequency_box_;
};

}  // namespace adore::adrplot
