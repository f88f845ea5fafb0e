#include "adrinput/study_panel.hpp"

#include "adrinput/qt_text.hpp"
#include "adrinput/wheel_guard.hpp"
#include "adrinput/window_words.hpp"
#include "base/counted.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/launch.hpp"
#include "desktop/listing_view.hpp"
#include "desktop/one_window.hpp"
#include "desktop/spoken_name.hpp"
#include "desktop/theme.hpp"

#include <QBoxLayout>
#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <fmt/format.h>

#include <exception>

namespace adore::adrinput {
namespace {

constexpr int kStudyBarSteps = 1000;
constexpr int kStudyCheckPause = 150;  // [ms] without a change

}  // namespace

StudyPanel::StudyPanel(StudyDocument& document, QWidget* parent)
    : QWidget(parent), launch(&desktop::start_program), document_(document) {
  program = (QCoreApplication::applicationDirPath() + "/adore").toStdString();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  state_ = new QLabel(this);
  state_->setObjectName("study-state");
  state_->setWordWrap(true);
  state_->setTextFormat(Qt::PlainText);
  state_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(state_);
  const auto button = [&](const QString& text, const char* name, const QString& help) {
    auto* push = new QPushButton(text, this);
    push->setObjectName(name);
    push->setToolTip(help);
    push->setAutoDefault(true);
    return push;
  };
  auto* grid = new QGridLayout;
  plan_ =
      button(tr("&Plan"), "study-plan",
             tr("Save the study, compute up to three pilot runs, and estimate the number of runs, "
                "computing time and disk space (F5)"));
  start_ = button(tr("&Run"), "study-run",
                  tr("Save the study and start all runs that have no result yet (F7)"));
  cancel_ = button(
      tr("&Cancel"), "study-cancel",
      tr("Stop the active runs. Finished runs are kept. \"Resume\" starts the remaining runs."));
  results_ = button(tr("Res&ults"), "study-results", tr("Open the charts of the study in AdrPlot"));
  retry_ = button(tr("Retr&y failed"), "study-retry", tr("Repeat the failed runs"));
  over_budget_button_ =
      button(tr("Run &anyway"), "study-over-budget", tr("Run even if the plan exceeds the budget"));
  connect(plan_, &QPushButton::clicked, this, &StudyPanel::planRequested);
  connect(start_, &QPushButton::clicked, this, &StudyPanel::runRequested);
  connect(cancel_, &QPushButton::clicked, this, &StudyPanel::cancel);
  connect(results_, &QPushButton::clicked, this, &StudyPanel::openResults);
  connect(retry_, &QPushButton::clicked, this, &StudyPanel::retryRequested);
  connect(over_budget_button_, &QPushButton::clicked, this, &StudyPanel::overBudgetRunRequested);
  grid->addWidget(plan_, 0, 0);
  grid->addWidget(start_, 0, 1);
  grid->addWidget(cancel_, 0, 2);
  grid->addWidget(results_, 1, 0);
  grid->addWidget(retry_, 1, 1);
  grid->addWidget(over_budget_button_, 1, 2);
  layout->addLayout(grid);
  auto* row = new QHBoxLayout;
  auto* engine_label = new QLabel(tr("E&ngine"), this);
  engine_ = new QComboBox(this);
  engine_->setObjectName("study-engine");
  desktop::set_accessible_name(*engine_, tr("Engine"));
  engine_->addItems({"local", "slurm"});
  engine_->setToolTip(tr("Compute with local processes or on a Slurm cluster"));
  engine_label->setBuddy(engine_);
  new WheelGuard(engine_);
  auto* workers_label = new QLabel(tr("&max. runs"), this);
  workers_ = new QSpinBox(this);
  workers_->setObjectName("study-workers");
  workers_->setAccessibleName(tr("Parallel runs"));
  workers_->setRange(0, 1024);
  workers_->setSpecialValueText(tr("auto"));
  workers_->setToolTip(
      tr("Maximum number of parallel runs (auto: limited by processor cores and memory)"));
  workers_label->setBuddy(workers_);
  new WheelGuard(workers_);
  row->addWidget(engine_label);
  row->addWidget(engine_);
  row->addWidget(workers_label);
  row->addWidget(workers_);
  row->addStretch(1);
  layout->addLayout(row);
  bar_ = new QProgressBar(this);
  bar_->setObjectName("study-bar");
  bar_->setRange(0, kStudyBarSteps);
  layout->addWidget(bar_);
  note_ = new QLabel(this);
  note_->setObjectName("study-note");
  note_->setWordWrap(true);
  note_->setTextFormat(Qt::PlainText);
  layout->addWidget(note_);
  view_ = desktop::make_listing_view(tr("Plan or report"), this);
  view_->setObjectName("study-text");
  layout->addWidget(view_, 1);
  delay_timer_ = new QTimer(this);
  delay_timer_->setSingleShot(true);
  delay_timer_->setInterval(kStudyCheckPause);
  connect(delay_timer_, &QTimer::timeout, this, &StudyPanel::checkNow);
  run_.progressed = [this](const studies::StudyProgress& progress) { show(progress); };
  run_.ended = [this](const StudyEnd& end) { show(end); };
  enableButtons();
}

QString StudyPanel::text() const { return view_->toPlainText(); }
QString StudyPanel::note() const { return note_->text(); }

void StudyPanel::changed() { delay_timer_->start(); }

void StudyPanel::checkNow() {
  delay_timer_->stop();
  finding_ = document_.check();
  const desktop::Theme& theme = desktop::current_theme();
  QPalette colours = state_->palette();
  colours.setColor(QPalette::WindowText, finding_.problem.empty() ? theme.text : theme.red);
  state_->setPalette(colours);
  state_->setText(
      finding_.problem.empty()
          ? tr("%1%2. The study has no errors.")
                .arg(document_.kind() == studies::Kind::WorstCase ? tr("At most ") : QString())
                .arg(text_of(counted(finding_.runs, "run")))
          : text_of(replace_cli_terms(finding_.problem)));
  enableButtons();
  emit checkFinished();
}

void StudyPanel::enableButtons() {
  const bool fit = finding_.problem.empty() && !busy();
  plan_->setEnabled(fit);
  start_->setEnabled(fit);
  start_->setText(started_ && !complete_ ? tr("&Resume") : tr("&Run"));
  cancel_->setEnabled(busy());
  retry_->setEnabled(fit && failed_runs_ > 0);
  // Until the study whose plan exceeded the budget changes; saving or checking changes nothing.
  over_budget_button_->setVisible(fit && !over_budget_study_.empty() &&
                                  over_budget_study_ == document_.text());
  engine_->setEnabled(!busy());
  workers_->setEnabled(!busy() && engine_->currentText() == "local");
  std::error_code error;
  std::filesystem::path folder = document_.path();
  results_->setEnabled(
      std::filesystem::exists(folder.replace_extension(".study") / "CHARTS.json", error));
}

StudyRun::Request StudyPanel::request() const {
  StudyRun::Request out;
  out.file = document_.path();
  out.program = program;
  out.engine = engine_->currentText().toStdString();
  out.workers = workers_->value();
  return out;
}

void StudyPanel::startPlan() {
  if (busy()) return;
  planning_ = true;
  started_study_ = document_.text();
  over_budget_study_.clear();
  view_->clear();
  bar_->setRange(0, 0);
  note_->setText(tr("Computing up to three pilot runs …"));
  run_.plan(request());
  enableButtons();
}

void StudyPanel::startRun(bool retry_failed, bool over_budget) {
  if (busy()) return;
  planning_ = false;
  started_study_ = document_.text();
  over_budget_study_.clear();
  view_->clear();
  bar_->setRange(0, 0);  // until the pilot runs are made
  note_->setText(tr("Starting with up to three pilot runs …"));
  StudyRun::Request asked = request();
  asked.retry_failed = retry_failed;
  asked.over_budget = over_budget;
  run_.run(asked);
  enableButtons();
}

void StudyPanel::cancel() {
  run_.stop();
  cancel_->setEnabled(false);
}

void StudyPanel::show(const studies::StudyProgress& progress) {
  bar_->setRange(0, kStudyBarSteps);
  bar_->setValue(
      progress.total > 0 ? static_cast<int>(kStudyBarSteps * progress.done / progress.total) : 0);
  QString text = text_of(studies::progress_text(progress));
  if (!progress.last_failure.empty())
    text += tr("\nLast failure: %1").arg(text_of(replace_cli_terms(progress.last_failure)));
  note_->setText(text);
}

void StudyPanel::show(const StudyEnd& end) {
  bar_->setRange(0, kStudyBarSteps);
  bar_->setValue(0);
  view_->setPlainText(text_of(replace_cli_terms(end.text)));
  bool over_budget = end.over_budget;
  if (!end.reason.empty()) {
    note_->setText(text_of(replace_cli_terms(end.reason)));
  } else if (end.interrupted) {
    note_->setText(tr("Cancelled. Finished runs are kept."));
  } else if (end.plan) {
    over_budget = !end.plan->over_budget.empty();
    note_->setText(over_budget ? tr("The plan exceeds the budget of the study.")
                               : tr("The pilot runs are kept. They will not be repeated."));
  } else if (end.outcome) {
    note_->setText(
        text_of(studies::outcome_text(*end.outcome)) +
        (end.outcome->complete
             ? QString()
             : tr("\nCancelled. Finished runs are kept. \"Resume\" starts the remaining runs.")));
    if (end.outcome->runs > 0)
      bar_->setValue(static_cast<int>(kStudyBarSteps * end.outcome->done / end.outcome->runs));
  }
  if (end.outcome) {
    failed_runs_ = end.outcome->failed;
    complete_ = end.outcome->complete;
  }
  started_ = started_ || !planning_;
  if (over_budget) over_budget_study_ = started_study_;
  enableButtons();
  emit finished();
}

void StudyPanel::showStatus() {
  started_ = complete_ = false;
  over_budget_study_.clear();
  failed_runs_ = 0;
  bar_->setValue(0);
  view_->clear();
  note_->setText(tr("\"Plan\" estimates the computing time. \"Run\" starts the study. Folder of "
                    "the results: %1.")
                     .arg(text_of(std::filesystem::path(document_.path())
                                      .replace_extension(".study")
                                      .filename()
                                      .string())));
  try {
    const studies::Status status =
        studies::study_status(studies::open_study_text(document_.text(), document_.path()));
    started_ = true;
    complete_ = status.done == status.runs;
    failed_runs_ = status.failed;
    bar_->setValue(status.runs > 0 ? static_cast<int>(kStudyBarSteps * status.done / status.runs)
                                   : 0);
    note_->setText(text_of(fmt::format("{} of {} runs are done ({} failed). {}", status.done,
                                       status.runs, status.failed,
                                       status.at_work ? "Another program is running the study."
                                       : complete_    ? "The study is complete."
                                                      : "\"Resume\" starts the remaining runs.")));
    std::string failures;
    for (const std::string& text : status.diagnoses) failures += replace_cli_terms(text) + "\n";
    view_->setPlainText(text_of(failures));
  } catch (const std::exception&) {
    // Never started, or with errors reported by the check.
  }
  enableButtons();
}

void StudyPanel::openResults() {
  std::filesystem::path folder = document_.path();
  const QString project = desktop::folder_of(folder);
  show_in_viewer(this, launch, "adrplot", project,
                 {text_of(folder.replace_extension(".study").string())});
}

}  // namespace adore::adrinput
