#include "adrinput/accuracy_panel.hpp"

#include "adrinput/wheel_guard.hpp"
#include "adrinput/window_words.hpp"
#include "desktop/flow_layout.hpp"
#include "desktop/listing_view.hpp"

#include <QBoxLayout>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <fmt/format.h>

#include <cmath>
#include <exception>

namespace adore::adrinput {
namespace {

constexpr int kAccuracyBarSteps = 1000;

QString row_text(const studies::AccuracyRow& row) {
  return QString::fromStdString(
      row.failure.empty() ? fmt::format("{:<40} {:.3g} s, error {:.2g} %", row.setting.name,
                                        row.seconds, 100.0 * row.errors.largest())
                          : fmt::format("{:<40} {}", row.setting.name, row.failure));
}

}  // namespace

AccuracyPanel::AccuracyPanel(QWidget* parent)
    : QWidget(parent),
      study([](const studies::AccuracyRequest& request, const studies::AccuracySink& row,
               std::stop_token stop) {
        return studies::study_accuracy(request, row, std::move(stop));
      }) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  auto* row = new desktop::FlowLayout;
  const auto button = [&](const QString& text, const char* name, const QString& help, auto act) {
    auto* push = new QPushButton(text, this);
    push->setObjectName(name);
    push->setToolTip(help);
    push->setAutoDefault(true);
    connect(push, &QPushButton::clicked, this, act);
    row->addWidget(push);
    return push;
  };
  const auto number = [&](const QString& text, const char* name, double value, double low,
                          double high, const QString& unit) {
    auto* pair = new QWidget(this);  // stays together where the row is broken
    auto* label = new QLabel(text, pair);
    auto* box = new QDoubleSpinBox(pair);
    box->setObjectName(name);
    box->setAccessibleName(text);
    box->setRange(low, high);
    box->setDecimals(unit == " s" ? 0 : unit == " %" ? 2 : 1);
    box->setSuffix(unit);
    box->setValue(value);
    label->setBuddy(box);
    new WheelGuard(box);
    auto* both = new QHBoxLayout(pair);
    both->setContentsMargins(0, 0, 0, 0);
    both->addWidget(label);
    both->addWidget(box);
    row->addWidget(pair);
    return box;
  };
  start_ = button(tr("Stud&y accuracy"), "study-accuracy",
                  tr("Compare integrators, tolerances and step sizes for this deck"),
                  &AccuracyPanel::wanted);
  cancel_ = button(tr("Cancel"), "cancel-study", tr("Stop the study and keep its results"),
                   &AccuracyPanel::cancel);
  target_ = number(tr("target error"), "accuracy-target", 1.0, 0.01, 50.0, " %");
  budget_ = number(tr("time limit"), "accuracy-budget", 120.0, 1.0, 100000.0, " s");
  revolutions_box_ = number(tr("run length"), "accuracy-turns", studies::AccuracyRequest().turns,
                            0.1, 10000.0, tr(" rev"));
  revolutions_box_->setToolTip(
      tr("Shaft revolutions simulated in each run of the second round, which compares the best "
         "settings. The time limit can reduce this number. The first round compares all settings "
         "in shorter runs."));
  row->addStretch();
  layout->addLayout(row);
  row = new desktop::FlowLayout;  // two short rows: one long one would widen the whole window
  bar_ = new QProgressBar(this);
  bar_->setObjectName("study-progress");
  bar_->setRange(0, kAccuracyBarSteps);
  row->addWidget(bar_);
  apply_ = button(tr("Apply to deck"), "apply-accuracy",
                  tr("Set the recommended values in this deck"), &AccuracyPanel::applyRequested);
  note_ = new QLabel(
      tr("The study runs this deck with different integrators, tolerances and maximum steps, and "
         "compares their errors and computing times (like `adore accuracy`). It writes no files."),
      this);
  note_->setObjectName("study-note");
  note_->setWordWrap(true);
  view_ = desktop::make_listing_view(tr("Accuracy study"), this);
  view_->setObjectName("study-text");
  view_->hide();
  layout->addLayout(row);
  layout->addWidget(note_);
  layout->addWidget(view_, 1);
  layout->addStretch(0);
  enableButtons();
}

QString AccuracyPanel::text() const { return view_->toPlainText(); }

void AccuracyPanel::enableButtons() {
  start_->setEnabled(!busy());
  cancel_->setEnabled(busy());
  apply_->setEnabled(!busy() && !recommended_settings_.empty());
}

void AccuracyPanel::cancel() { background_task_.stop(); }

void AccuracyPanel::start(const deck::Deck& deck, const RunOptionValues& options) {
  if (busy()) return;
  studied_deck_ = deck;
  deck_replaced_ = file_reloaded_ = stale_ = false;
  recommended_settings_.clear();
  view_->clear();
  view_->show();
  bar_->setValue(0);
  headline_ = tr("Computing the reference run …");
  note_->setText(headline_);
  studies::AccuracyRequest request;
  request.text = deck::write_deck(deck);
  for (const auto& [name, value] : options) request.options.emplace_back(name, value);
  request.target = target_->value() / 100.0;
  request.budget = budget_->value();
  request.turns = revolutions_box_->value();
  round_.clear();
  struct End {
    studies::AccuracyStudy study;
    std::string failure;
  };
  auto end = std::make_shared<End>();
  const auto row_done = [this](const studies::AccuracyRow& row,
                               const studies::AccuracyStudy& so_far) {
    const double used = so_far.seconds;
    background_task_.report([this, line = row_text(row), used,
                             round = QString::fromStdString(studies::round_text(row, so_far))] {
      showRow(line, round, used);
    });
  };
  background_task_.start(
      [function = study, request = std::move(request), row_done, end](std::stop_token token) {
        try {
          end->study = function(request, row_done, std::move(token));
        } catch (const std::exception& error) {
          end->failure = replace_cli_terms(error.what());
        }
      },
      [this, end] { show(end->study, QString::fromStdString(end->failure)); });
  enableButtons();
}

void AccuracyPanel::showRow(const QString& line, const QString& round, double used) {
  if (!busy()) return;
  if (round != round_) view_->appendPlainText(round_ = round);
  const double share = used / std::max(budget_->value(), 1.0);
  bar_->setValue(std::max(bar_->value(),
                          static_cast<int>(std::lround(kAccuracyBarSteps * std::min(share, 1.0)))));
  view_->appendPlainText("  " + line);
  note_->setText(tr("Running: %1 s of %2 s computing time used.")
                     .arg(used, 0, 'f', 0)
                     .arg(budget_->value(), 0, 'f', 0));
}

void AccuracyPanel::show(const studies::AccuracyStudy& study_made, const QString& failure) {
  if (!failure.isEmpty()) {
    headline_ = tr("The study failed: %1").arg(failure);
  } else if (!study_made.complete) {
    headline_ = tr("The study was stopped before it was complete.");
  } else {
    bar_->setValue(kAccuracyBarSteps);
    if (!deck_replaced_) recommended_settings_ = studies::recommended_sets(study_made);
    headline_ = QString::fromStdString(studies::recommendation(study_made));
    view_->setPlainText(QString::fromStdString(studies::accuracy_table(study_made)));
  }
  showNote();
  enableButtons();
  emit finished();
}

void AccuracyPanel::showNote() {
  QStringList changes;
  for (const auto& [name, value] : recommended_settings_)
    changes << QString::fromStdString(fmt::format("{} = {}", name, value));
  note_->setText(
      (file_reloaded_   ? tr("Out of date: the file was reloaded. Run the study again. ")
       : deck_replaced_ ? tr("Results of another deck. ")
       : stale_         ? tr("Out of date: the deck has changed. Run the study again. ")
                        : QString()) +
      headline_ +
      (changes.isEmpty() ? QString() : tr(" \"Apply to deck\" sets %1.").arg(changes.join(", "))));
}

void AccuracyPanel::invalidateResult(bool reread) {
  if (studied_deck_.records.empty()) return;
  file_reloaded_ = reread && (file_reloaded_ || !deck_replaced_);
  deck_replaced_ = true;
  recommended_settings_.clear();
  enableButtons();
}

void AccuracyPanel::setStoredAccuracy(const QString& text) {
  if (busy() || !studied_deck_.records.empty()) return;
  view_->setPlainText(text);
  view_->setVisible(!text.isEmpty());
}

void AccuracyPanel::setDeck(const deck::Deck& deck) {
  if (studied_deck_.records.empty()) return;
  stale_ = !(deck == studied_deck_);
  if (!busy()) showNote();
}

}  // namespace adore::adrinput
