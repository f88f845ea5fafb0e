#include "agore/film_dialog.hpp"

#include "desktop/chart_page.hpp"
#include "desktop/dialogs.hpp"

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

FilmDialog::FilmDialog(std::vector<double> time, std::pair<std::size_t, std::size_t> part,
                       Tell tell, QWidget* parent)
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
  from_ = makeEnd("filmFrom", part.first);
  from_.frame->setAccessibleName(tr("From frame"));
  row(tr("From frame"), from_);
  to_ = makeEnd("filmTo", part.second);
  to_.frame->setAccessibleName(tr("To frame"));
  row(tr("To frame"), to_);
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

std::size_t FilmDialog::first() const { return static_cast<std::size_t>(from_.frame->value() - 1); }
std::size_t FilmDialog::last() const { return static_cast<std::size_t>(to_.frame->value() - 1); }

void FilmDialog::changed() {
  if (to_.frame == nullptr || to_.time == nullptr) return;  // not made yet
  const auto [words, valid] =
      first() > last() ? std::pair{tr("The first frame (%1) is after the last frame (%2).")
                                       .arg(first() + 1)
                                       .arg(last() + 1),
                                   false}
                       : tell_(first(), last());
  length_->setText(words);
  ok_->setEnabled(valid);
}

}  // namespace adore::agore
