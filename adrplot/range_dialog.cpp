#include "adrplot/range_dialog.hpp"

#include "base/counted.hpp"
#include "desktop/dialogs.hpp"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>

#include <algorithm>
#include <limits>

namespace adore::adrplot {

RangeDialog::RangeDialog(const QString& file, long stored, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Plot parameters"));
  desktop::delete_when_done(*this);
  const int last =
      static_cast<int>(std::clamp<long>(stored, 1, std::numeric_limits<int>::max() / 2));
  const auto box = [this, last](const char* name, int value) {
    auto* spin = new QSpinBox(this);
    spin->setObjectName(name);
    spin->setRange(1, last);
    spin->setValue(value);
    spin->setMinimumWidth(140);
    return spin;
  };
  count_ = new QLabel(this);
  count_->setObjectName("count");
  first_step_box_ = box("from", 1);
  last_step_box_ = box("to", last);
  step_interval_box_ = box("every", 1);
  for (const QSpinBox* spin : {first_step_box_, last_step_box_, step_interval_box_})
    connect(spin, &QSpinBox::valueChanged, this, &RangeDialog::count);
  // The end is never before the start.
  connect(first_step_box_, &QSpinBox::valueChanged, last_step_box_, &QSpinBox::setMinimum);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 18, 20, 16);
  form->addRow(
      new QLabel(tr("Stored steps of <b>%1</b> to plot:").arg(file.toHtmlEscaped()), this));
  form->addRow(tr("&Start point"), first_step_box_);
  form->addRow(tr("&End point"), last_step_box_);
  form->addRow(tr("&Interval"), step_interval_box_);
  form->addRow(count_);
  form->addRow(buttons);
  count();
}

void RangeDialog::count() {
  const int steps =
      (last_step_box_->value() - first_step_box_->value()) / step_interval_box_->value() + 1;
  count_->setText(
      tr("%1 of %2")
          .arg(steps)
          .arg(QString::fromStdString(counted(last_step_box_->maximum(), "stored step"))));
}

results::SolRange RangeDialog::range() const {
  // The end of the file stays the end while it grows.
  const long to = last_step_box_->value() == last_step_box_->maximum() ? results::SolRange{}.to
                                                                       : last_step_box_->value();
  return {first_step_box_->value(), to, step_interval_box_->value()};
}

}  // namespace adore::adrplot
