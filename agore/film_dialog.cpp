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

MovieDialog::MovieDialog(std::vector<double> time, const MovieSettings& start, bool by_time,
                         DescribeMovie tell, QWidget* parent)
    : QDialog(parent), frame_times_(std::move(time)), describe_movie_(std::move(tell)) {
  setObjectName("filmRange");
  setWindowTitle(tr("Save Movie"));
  desktop::delete_when_done(*this);
  auto* all = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  all->addLayout(form);
  const auto row = [&](const QString& text, const RangeLimitFields& end) {
    auto* line = new QHBoxLayout;
    line->addWidget(end.frame);
    line->addWidget(new QLabel(tr("at"), this));
    line->addWidget(end.time);
    form->addRow(text, line);
  };
  from_ = makeLimitFields("filmFrom", start.first);
  from_.frame->setAccessibleName(tr("From frame"));
  row(tr("From frame"), from_);
  to_ = makeLimitFields("filmTo", start.last);
  to_.frame->setAccessibleName(tr("To frame"));
  row(tr("To frame"), to_);
  addPictureFields(*form, start, by_time);
  length_ = new QLabel(this);
  length_->setObjectName("filmLength");
  length_->setWordWrap(true);
  all->addWidget(length_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  ok_button_ = buttons->button(QDialogButtonBox::Ok);
  ok_button_->setText(tr("&Next..."));
  all->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  changed();
}

void MovieDialog::addPictureFields(QFormLayout& form, const MovieSettings& start, bool by_time) {
  constexpr int kMostRate = 60;
  frame_interval_box_ = new QSpinBox(this);
  frame_interval_box_->setObjectName("filmEvery");
  frame_interval_box_->setRange(1, static_cast<int>(frame_times_.size()));
  frame_interval_box_->setValue(start.every);
  frame_interval_box_->setEnabled(!by_time);
  frame_interval_box_->setToolTip(by_time ? tr("Slow motion: pictures at equal time steps")
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
  row(tr("Interval of frames"), frame_interval_box_);
  row(tr("Pictures per second"), rate_);
  row(tr("Size [pixels]"), size_);
  for (QSpinBox* box : {frame_interval_box_, rate_})
    connect(box, &QSpinBox::valueChanged, this, &MovieDialog::changed);
  connect(size_, &QComboBox::currentIndexChanged, this, &MovieDialog::changed);
}

MovieDialog::RangeLimitFields MovieDialog::makeLimitFields(const QString& name, std::size_t frame) {
  RangeLimitFields out{new QSpinBox(this), new QDoubleSpinBox(this)};
  out.frame->setObjectName(name);
  out.frame->setRange(1, static_cast<int>(frame_times_.size()));
  out.frame->setValue(static_cast<int>(frame) + 1);
  out.time->setObjectName(name + "Time");
  out.time->setAccessibleName(tr("Time of the frame"));
  out.time->setSuffix(tr(" ms"));
  out.time->setDecimals(6);
  out.time->setRange(kMs * frame_times_.front(), kMs * frame_times_.back());
  out.time->setSingleStep(kMs * (frame_times_.back() - frame_times_.front()) / 100.0);
  out.time->setValue(kMs * frame_times_[frame]);
  // A number shows its time; a typed time selects the nearest frame.
  connect(out.frame, &QSpinBox::valueChanged, this, [this, out](int number) {
    const QSignalBlocker quiet(out.time);
    out.time->setValue(kMs * frame_times_[static_cast<std::size_t>(number - 1)]);
    changed();
  });
  connect(out.time, &QDoubleSpinBox::valueChanged, this, [this, out](double time) {
    const QSignalBlocker quiet(out.frame);
    out.frame->setValue(static_cast<int>(desktop::nearest_index(frame_times_, time / kMs)) + 1);
    changed();
  });
  connect(out.time, &QDoubleSpinBox::editingFinished, this, [this, out] {
    const QSignalBlocker quiet(out.time);
    out.time->setValue(kMs * frame_times_[static_cast<std::size_t>(out.frame->value() - 1)]);
  });
  return out;
}

MovieSettings MovieDialog::choice() const {
  return {static_cast<std::size_t>(from_.frame->value() - 1),
          static_cast<std::size_t>(to_.frame->value() - 1), frame_interval_box_->value(),
          rate_->value(), size_->currentData().toSize()};
}

void MovieDialog::changed() {
  if (ok_button_ == nullptr) return;  // not made yet
  const MovieSettings now = choice();
  const auto [words, valid] =
      now.first > now.last ? std::pair{tr("The first frame (%1) is after the last frame (%2).")
                                           .arg(now.first + 1)
                                           .arg(now.last + 1),
                                       false}
                           : describe_movie_(now);
  length_->setText(words);
  ok_button_->setEnabled(valid);
}

}  // namespace adore::agore
