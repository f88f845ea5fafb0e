#include "agore/film_dialog.hpp"

#include "desktop/chart_page.hpp"
#include "desktop/dialogs.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

namespace adore::agore {

namespace {
constexpr double kMs = 1e3;
}

FilmDialog::FilmDialog(std::vector<double> time, const FilmChoice& start, bool by_time, Tell tell,
                       QWidget* parent)
    : QDialog(parent), time_(std::move(time)), tell_(std::move(tell)) {
  setObjectName("filmRange");
  setWindowTitle(tr("Save Movie"));
  desktop::delete_when_done(*this);
  auto* all = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  all->addLayout(form);
  const auto row = [&](const QString& text, const End& end) {
    auto* line = new QHBoxLayout;
    line->addWidget(end.frame);
    line->addWidget(new QLabel(tr("at"), this));
    line->addWidget(end.time);
    form->addRow(text, line);
  };
  from_ = makeEnd("filmFrom", start.first);
  from_.frame->setAccessibleName(tr("From frame"));
  row(tr("From frame"), from_);
  to_ = makeEnd("filmTo", start.last);
  to_.frame->setAccessibleName(tr("To frame"));
  row(tr("To frame"), to_);
  addPictures(*form, start, by_time);
  length_ = new QLabel(this);
  length_->setObjectName("filmLength");
  length_->setWordWrap(true);
  all->addWidget(length_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  ok_->setText(tr("&Next..."));
  all->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  changed();
}

void FilmDialog::addPictures(QFormLayout& form, const FilmChoice& start, bool by_time) {
  constexpr int kMostRate = 60;
  every_ = new QSpinBox(this);
  every_->setObjectName("filmEvery");
  every_->setRange(1, static_cast<int>(time_.size()));
  every_->setValue(start.every);
  every_->setEnabled(!by_time);
  every_->setToolTip(by_time ? tr("Slow motion: pictures at equal steps of time")
                             : tr("1: all frames, 2: every second frame"));
  rate_ = new QSpinBox(this);
  rate_->setObjectName("filmRate");
  rate_->setRange(1, kMostRate);
  rate_->setValue(start.rate);
  size_ = new QComboBox(this);
  size_->setObjectName("filmSize");
  const auto add = [this](QSize size, const QString& note) {
    if (size_->findData(size) < 0)
      size_->addItem(tr("%1 × %2%3").arg(size.width()).arg(size.height()).arg(note), size);
  };
  add(start.size, tr(" (as displayed)"));
  for (const QSize& size : {QSize(854, 480), QSize(1280, 720), QSize(1280, 800), QSize(1920, 1080)})
    add(size, {});
  const auto row = [&](const QString& text, QWidget* field) {
    form.addRow(text, field);
    field->setAccessibleName(text);
  };
  row(tr("Interval of frames"), every_);
  row(tr("Pictures per second"), rate_);
  row(tr("Size [pixels]"), size_);
  for (QSpinBox* box : {every_, rate_})
    connect(box, &QSpinBox::valueChanged, this, &FilmDialog::changed);
  connect(size_, &QComboBox::currentIndexChanged, this, &FilmDialog::changed);
}

FilmDialog::End FilmDialog::makeEnd(const QString& name, std::size_t frame) {
  End out{new QSpinBox(this), new QDoubleSpinBox(this)};
  out.frame->setObjectName(name);
  out.frame->setRange(1, static_cast<int>(time_.size()));
  out.frame->setValue(static_cast<int>(frame) + 1);
  out.time->setObjectName(name + "Time");
  out.time->setAccessibleName(tr("Time of the frame"));
  out.time->setSuffix(tr(" ms"));
  out.time->setDecimals(6);
  out.time->setRange(kMs * time_.front(), kMs * time_.back());
  out.time->setSingleStep(kMs * (time_.back() - time_.front()) / 100.0);
  out.time->setValue(kMs * time_[frame]);
  // A number shows its time; a typed time selects the nearest frame.
  connect(out.frame, &QSpinBox::valueChanged, this, [this, out](int number) {
    const QSignalBlocker quiet(out.time);
    out.time->setValue(kMs * time_[static_cast<std::size_t>(number - 1)]);
    changed();
  });
  connect(out.time, &QDoubleSpinBox::valueChanged, this, [this, out](double time) {
    const QSignalBlocker quiet(out.frame);
    out.frame->setValue(static_cast<int>(desktop::nearest_index(time_, time / kMs)) + 1);
    changed();
  });
  connect(out.time, &QDoubleSpinBox::editingFinished, this, [this, out] {
    const QSignalBlocker quiet(out.time);
    out.time->setValue(kMs * time_[static_cast<std::size_t>(out.frame->value() - 1)]);
  });
  return out;
}

FilmChoice FilmDialog::choice() const {
  return {static_cast<std::size_t>(from_.frame->value() - 1),
          static_cast<std::size_t>(to_.frame->value() - 1), every_->value(), rate_->value(),
          size_->currentData().toSize()};
}

void FilmDialog::changed() {
  if (ok_ == nullptr) return;  // not made yet
  const FilmChoice now = choice();
  const auto [words, valid] =
      now.first > now.last ? std::pair{tr("The first frame (%1) is after the last frame (%2).")
                                           .arg(now.first + 1)
                                           .arg(now.last + 1),
                                       false}
                           : tell_(now);
  length_->setText(words);
  ok_->setEnabled(valid);
}

}  // namespace adore::agore
