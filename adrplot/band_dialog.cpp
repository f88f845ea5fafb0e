#include "adrplot/band_dialog.hpp"

#include "desktop/dialogs.hpp"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>

namespace adore::adrplot {

BandDialog::BandDialog(const PassBand& band, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Band of the envelope"));
  desktop::delete_when_done(*this);
  automatic_check_box_ =
      new QCheckBox(tr("&Automatic: most impulsive vibration, or else strongest modulation"), this);
  automatic_check_box_->setObjectName("automatic");
  const auto box = [this](const char* name, double value) {
    constexpr double kHighest = 1e9;  // [Hz]
    auto* spin = new QDoubleSpinBox(this);
    spin->setObjectName(name);
    spin->setRange(0.0, kHighest);
    spin->setDecimals(1);
    spin->setSuffix(tr(" Hz"));
    spin->setGroupSeparatorShown(true);
    spin->setValue(value);
    spin->setMinimumWidth(160);
    return spin;
  };
  low_frequency_box_ = box("low", band.low);
  high_frequency_box_ = box("high", band.high);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 18, 20, 16);
  form->addRow(automatic_check_box_);
  form->addRow(tr("&Lower frequency"), low_frequency_box_);
  form->addRow(tr("&Upper frequency"), high_frequency_box_);
  form->addRow(buttons);
  const auto check = [this, ok = buttons->button(QDialogButtonBox::Ok)] {
    const bool automatic = automatic_check_box_->isChecked();
    low_frequency_box_->setEnabled(!automatic);
    high_frequency_box_->setEnabled(!automatic);
    ok->setEnabled(automatic || high_frequency_box_->value() > low_frequency_box_->value());
    ok->setToolTip(ok->isEnabled() ? QString()
                                   : tr("Enter an upper frequency above the lower frequency."));
  };
  connect(automatic_check_box_, &QCheckBox::toggled, this, check);
  connect(low_frequency_box_, &QDoubleSpinBox::valueChanged, this, check);
  connect(high_frequency_box_, &QDoubleSpinBox::valueChanged, this, check);
  automatic_check_box_->setChecked(band.automatic());
  check();
}

PassBand BandDialog::band() const {
  if (automatic_check_box_->isChecked()) return {};
  return {low_frequency_box_->value(), high_frequency_box_->value()};
}

}  // namespace adore::adrplot
