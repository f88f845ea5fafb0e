#include "adrplot/range_dialog.hpp"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>

namespace adore::adrplot {

RangeDialog::RangeDialog(const QString& file, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Plot parameters"));
  setAttribute(Qt::WA_DeleteOnClose);
  const auto box = [this](const char* name, int value) {
    auto* spin = new QSpinBox(this);
    spin->setObjectName(name);
    spin->setRange(1, 100'000'000);
    spin->setValue(value);
    spin->setMinimumWidth(140);
    return spin;
  };
  const results::SolRange defaults;
  from_ = box("from", static_cast<int>(defaults.from));
  to_ = box("to", static_cast<int>(defaults.to));
  every_ = box("every", static_cast<int>(defaults.every));
  // The end never lies before the start.
  connect(from_, &QSpinBox::valueChanged, to_, &QSpinBox::setMinimum);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 18, 20, 16);
  form->addRow(new QLabel(
      tr("Which stored steps of <b>%1</b> shall be plotted?").arg(file.toHtmlEscaped()), this));
  form->addRow(tr("&Start point"), from_);
  form->addRow(tr("&End point"), to_);
  form->addRow(tr("&Interval"), every_);
  form->addRow(buttons);
}

results::SolRange RangeDialog::range() const {
  return {from_->value(), to_->value(), every_->value()};
}

}  // namespace adore::adrplot
