#include "adrplot/figure_dialog.hpp"

#include "desktop/dialogs.hpp"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFontComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>

#include <exception>
#include <utility>

namespace adore::adrplot {
namespace {

constexpr double kOneColumn = 85.0, kTwoColumns = 170.0;  // [mm]
constexpr int kPreviewWidth = 280, kPreviewHeight = 250;  // pixels

}  // namespace

FigureDialog::FigureDialog(desktop::ChartPage page, desktop::ChartZoom zoom, QWidget* parent)
    : QDialog(parent), page_(std::move(page)), zoom_(std::move(zoom)) {
  setWindowTitle(tr("Figure for print"));
  desktop::delete_when_done(*this);
  const auto box = [this](const char* name, double low, double high, const QString& unit) {
    auto* spin = new QDoubleSpinBox(this);
    spin->setObjectName(name);
    spin->setRange(low, high);
    spin->setDecimals(1);
    spin->setSuffix(unit);
    connect(spin, &QDoubleSpinBox::valueChanged, this, &FigureDialog::showPreview);
    return spin;
  };
  width_ = box("width", desktop::kLeastFigure, desktop::kLargestFigure, tr(" mm"));
  height_ = box("height", desktop::kLeastFigure, desktop::kLargestFigure, tr(" mm"));
  letters_ = box("letters", desktop::kLeastLetters, desktop::kLargestLetters, tr(" pt"));
  font_ = new QFontComboBox(this);
  font_->setObjectName("font");
  connect(font_, &QFontComboBox::currentFontChanged, this, &FigureDialog::showPreview);
  gray_ = new QCheckBox(tr("&Gray lines with different dashes"), this);
  gray_->setObjectName("gray");
  connect(gray_, &QCheckBox::toggled, this, &FigureDialog::showPreview);
  preview_ = new QLabel(this);
  preview_->setObjectName("preview");
  preview_->setAlignment(Qt::AlignCenter);
  preview_->setWordWrap(true);
  preview_->setFixedSize(kPreviewWidth, kPreviewHeight);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  ok_->setText(tr("Save &As..."));
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    store();
    accept();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  const auto column = [this](const char* name, const QString& text, double width) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [this, width] {
      const double ratio = height_->value() / width_->value();
      width_->setValue(width);
      height_->setValue(ratio * width);
    });
    return button;
  };
  auto* columns = new QHBoxLayout;
  columns->addWidget(column("one-column", tr("&One column"), kOneColumn));
  columns->addWidget(column("two-columns", tr("&Two columns"), kTwoColumns));
  auto* form = new QFormLayout;
  form->addRow(tr("&Width"), width_);
  form->addRow(columns);
  form->addRow(tr("&Height"), height_);
  form->addRow(tr("&Letters"), letters_);
  form->addRow(tr("&Font"), font_);
  form->addRow(gray_);
  auto* top = new QHBoxLayout;
  top->addLayout(form);
  top->addWidget(preview_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(20, 18, 20, 16);
  all->addLayout(top);
  all->addWidget(buttons);
  restore();
  showPreview();
}

desktop::Figure FigureDialog::figure() const {
  return {width_->value(), height_->value(), letters_->value(),
          font_->currentFont().family().toStdString(), gray_->isChecked()};
}

void FigureDialog::restore() {
  const desktop::Figure usual = desktop::with_height({kOneColumn}, page_);
  const QSettings settings("Adore", "adrplot");
  width_->setValue(settings.value("figure/width", usual.width).toDouble());
  height_->setValue(settings.value("figure/height", usual.height).toDouble());
  letters_->setValue(settings.value("figure/letters", usual.letters).toDouble());
  font_->setCurrentFont(QFont(settings.value("figure/font", "DejaVu Sans").toString()));
  gray_->setChecked(settings.value("figure/gray", false).toBool());
}

void FigureDialog::store() const {
  QSettings settings("Adore", "adrplot");
  settings.setValue("figure/width", width_->value());
  settings.setValue("figure/height", height_->value());
  settings.setValue("figure/letters", letters_->value());
  settings.setValue("figure/font", font_->currentFont().family());
  settings.setValue("figure/gray", gray_->isChecked());
}

void FigureDialog::showPreview() {
  constexpr double kScreenDpi = 96.0;
  try {
    const QPixmap figure =
        QPixmap::fromImage(desktop::figure_image(page_, this->figure(), 2.0 * kScreenDpi, &zoom_));
    preview_->setPixmap(
        figure.scaled(preview_->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
    ok_->setEnabled(true);
  } catch (const std::exception& error) {
    preview_->setText(QString::fromUtf8(error.what()));
    ok_->setEnabled(false);
  }
}

}  // namespace adore::adrplot
