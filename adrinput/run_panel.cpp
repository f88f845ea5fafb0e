#include "adrinput/run_panel.hpp"

#include "adrinput/qt_text.hpp"
#include "adrinput/run_time_bar.hpp"
#include "adrinput/settings.hpp"
#include "adrinput/window_words.hpp"
#include "base/counted.hpp"
#include "base/duration.hpp"
#include "base/input_file.hpp"
#include "desktop/behind.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/flow_layout.hpp"
#include "desktop/launch.hpp"
#include "desktop/listing_view.hpp"
#include "desktop/one_window.hpp"
#include "desktop/window_place.hpp"
#include "results/run_findings.hpp"
#include "results/run_json.hpp"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QLabel>
#include <QMenu>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <fmt/format.h>

#include <cmath>
#include <exception>

namespace adore::adrinput {
namespace {

constexpr int kBarSteps = 1000;
constexpr int kLookPause = 150;           // ms without a change in the folder of results
constexpr qint64 kMostShown = 4'000'000;  // bytes of PRINT.txt in a window

QString report(const runs::RunOutcome& outcome) {
  std::string text;
  for (const std::string& line : outcome.results) text += line + "\n";
  for (const Finding& one : shown_findings(outcome.warnings)) text += one.text() + "\n";
  if (outcome.energy_scale > 0.0)
    text +=
        fmt::format("Energy residual: {:.3g} J ({:.2g} times the exchanged energy of {:.3g} J).\n",
                    outcome.energy_residual, outcome.energy_residual / outcome.energy_scale,
                    outcome.energy_scale);
  text += fmt::format("Files in {}:\n ", outcome.folder.string());
  for (const auto& file : outcome.files) text += " " + file.filename().string();
  return text_of(replace_cli_terms(text));
}

/// A message with one period at its end.
std::string sentence(std::string message) {
  if (!message.empty() && message.back() != '.') message += '.';
  return message;
}

QString headline_of(const runs::RunOutcome& outcome) {
  const std::string done =
      outcome.steps > 0
          ? fmt::format("{}, {}, {:.6g} s simulated, computed in {}.",
                        counted(outcome.steps, "step"),
                        counted(fmt::format("{:.4g}", outcome.revolutions), "revolution"),
                        outcome.time, duration_text(outcome.seconds))
          : fmt::format("Quasi-static solution computed in {}.", duration_text(outcome.seconds));
  const std::string message = sentence(replace_cli_terms(outcome.message));
  switch (outcome.status) {
    case runs::RunStatus::Done:
      // A message reports that the run was already complete.
      return text_of("Done: " + (message.empty() ? done : message) +
                     (outcome.missed_end > 0.0
                          ? fmt::format(" The run stopped after maxStps steps, before its end time "
                                        "of {:.6g} s (fTime).",
                                        outcome.missed_end)
                          : ""));
    case runs::RunStatus::Interrupted:
      return text_of(
          "Cancelled. The files are valid up to the last stored step. " +
          (message.empty() ? done : "The results are not reliable: " + message + " " + done));
    case runs::RunStatus::Untrusted:
      return text_of("Done, but the results are not reliable: " + message + " " + done);
    case runs::RunStatus::Failed:
      break;
  }
  return text_of("The run failed: " + message +
                 " The files are valid up to the last stored step. " + done);
}

}  // namespace

RunPanel::RunPanel(QWidget* parent)
    : QWidget(parent),
      launch(&desktop::start_program),
      watcher_(new QFileSystemWatcher(this)),
      delay_timer_(new QTimer(this)) {
  delay_timer_->setSingleShot(true);
  delay_timer_->setInterval(kLookPause);
  connect(watcher_, &QFileSystemWatcher::directoryChanged, delay_timer_,
          qOverload<>(&QTimer::start));
  connect(delay_timer_, &QTimer::timeout, this, [this] {
    watchResults();
    enableViewers();
  });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  auto* first = new desktop::FlowLayout;
  auto* second = new desktop::FlowLayout;
  const auto button = [&](QLayout* row, const QString& text, const char* name, const QString& help,
                          auto slot) {
    auto* push = new QPushButton(text, this);
    push->setObjectName(name);
    push->setToolTip(help);
    push->setAutoDefault(true);
    connect(push, &QPushButton::clicked, this, slot);
    row->addWidget(push);
    return push;
  };
  start_ = button(first, tr("Run"), "run", tr("Save the deck and run it (F7)"), &RunPanel::wanted);
  more_runs_button_ = new QToolButton(this);
  more_runs_button_->setObjectName("more-runs");
  more_runs_button_->setText(tr("More"));
  more_runs_button_->setToolTip(tr("Run in a new folder, continue a run, or run a sweep"));
  more_runs_button_->setAccessibleName(tr("More run commands"));
  more_runs_button_->setPopupMode(QToolButton::InstantPopup);
  auto* ways = new QMenu(more_runs_button_);
  ways->addAction(tr("Run in a &new folder"), this, &RunPanel::newFolderRequested);
  QAction* go_on = ways->addAction(tr("&Continue the run"), this, &RunPanel::continueRequested);
  ways->setToolTipsVisible(true);
  connect(ways, &QMenu::aboutToShow, this, [this, go_on] { updateContinueAction(*go_on); });
  ways->addAction(tr("&Sweep a variable …"), this, &RunPanel::sweepRequested);
  more_runs_button_->setMenu(ways);
  first->addWidget(more_runs_button_);
  cancel_ = button(first, tr("&Cancel"), "cancel", tr("Stop the run after the current step"),
                   &RunPanel::cancel);
  bar_ = new QProgressBar(this);
  bar_->setObjectName("progress");
  bar_->setRange(0, kBarSteps);
  first->addWidget(bar_);
  plots_ = button(second, tr("P&lots"), "open-plots", tr("Open the plot files in AdrPlot"),
                  &RunPanel::openPlots);
  animation_ = button(second, tr("&Animation"), "open-animation",
                      tr("Open the animation file in AGORE"), &RunPanel::openAnimation);
  listing_ = button(second, "&PRINT.txt", "listing", tr("Show the listing in a window"),
                    &RunPanel::showListing);
  second->addStretch();
  second->addWidget(new QLabel(tr("When done, open"), this));
  const auto box = [&](const QString& text, const char* name) {
    auto* check = new QCheckBox(text, this);
    check->setObjectName(name);
    check->setToolTip(tr("Open in the background without taking focus"));
    check->setChecked(settings().value(QString("open/%1").arg(name), true).toBool());
    connect(check, &QCheckBox::toggled, this,
            [name](bool on) { settings().setValue(QString("open/%1").arg(name), on); });
    second->addWidget(check);
    return check;
  };
  plots_at_end_ = box(tr("plots"), "plots-at-end");
  animation_at_end_ = box(tr("animation"), "animation-at-end");
  note_ = new QLabel(tr("Saves the deck and runs it like `adore run`. The results are stored in "
                        "the folder of the deck."),
                     this);
  note_->setObjectName("run-note");
  note_->setWordWrap(true);
  findings_ = new desktop::FindingsBar(this);
  connect(findings_, &desktop::FindingsBar::chosen, this, &RunPanel::findingChosen);
  time_bar_ = new RunTimeBar(this);
  view_ = desktop::make_listing_view(tr("Run messages"), this);
  view_->setObjectName("run-text");
  view_->hide();
  layout->addLayout(first);
  layout->addLayout(second);
  layout->addWidget(note_);
  layout->addWidget(findings_);
  layout->addWidget(time_bar_);
  layout->addWidget(view_, 1);
  layout->addStretch(0);
  run_.progressed = [this](const runs::Progress& progress) { show(progress); };
  run_.ended = [this](const RunEnd& end) { show(end); };
  enableButtons();
}

QString RunPanel::text() const { return view_->toPlainText(); }

void RunPanel::enableButtons() {
  start_->setEnabled(!busy());
  more_runs_button_->setEnabled(!busy());
  cancel_->setEnabled(busy());
  watchResults();
  enableViewers();
}

/// A plot viewer follows an active run.
void RunPanel::enableViewers() {
  const RunResults found = results();
  plots_->setEnabled(!found.plots.isEmpty());
  animation_->setEnabled(!busy() && !found.animation.isEmpty());
  listing_->setEnabled(!busy() && !found.listing.isEmpty());
  time_bar_->setRun(busy() ? std::string() : found.values.toStdString());
  // Values of an earlier run take the place of the introduction.
  note_->setVisible(!headline_.isEmpty() || time_bar_->isHidden());
}

RunResults RunPanel::results() const {
  if (computed_deck_.records.empty())
    return form_deck_file_.empty() ? RunResults()
                                   : results_in(form_deck_file_.parent_path(), form_deck_);
  if (busy()) return results_in(resultFolder(), computed_deck_, run_start_time_);
  return results_in(resultFolder(), computed_deck_);
}

/// The folder of results and its parent folder, in case it is removed or created.
void RunPanel::watchResults() {
  namespace fs = std::filesystem;
  QStringList wanted;
  const bool ran = !computed_deck_.records.empty();
  const fs::path& file = ran ? file_ : form_deck_file_;
  if (!file.empty()) {
    const fs::path folder = ran && !result_folder_.empty() ? fs::absolute(result_folder_)
                                                           : fs::absolute(file).parent_path();
    for (const fs::path& one : {folder, folder.parent_path()})
      if (const QFileInfo info(text_of(one.string())); info.isDir())
        wanted << QDir::cleanPath(info.absoluteFilePath());
    wanted.removeDuplicates();
  }
  const QStringList watched = watcher_->directories();
  for (const QString& name : watched)
    if (!wanted.contains(name)) watcher_->removePath(name);
  for (const QString& name : wanted)
    if (!watched.contains(name)) watcher_->addPath(name);
}

void RunPanel::cancel() {
  run_.stop();
  cancel_->setEnabled(false);
}

void RunPanel::show(const runs::Progress& progress) {
  bar_->setValue(static_cast<int>(std::lround(kBarSteps * progress.fraction)));
  if (progress.runs > 0) {
    headline_ = text_of(
        fmt::format("{} of {} done.", progress.step, counted(progress.runs, progress.piece)));
    if (progress.remaining > 0.0)
      headline_ += text_of(fmt::format(" Remaining: {}.", duration_text(progress.remaining)));
    return showNote();
  }
  has_stored_steps_ = has_stored_steps_ || progress.step > 0;
  enableViewers();
  // Next to the bar: the limit that ends the run.
  const std::string left = duration_text(progress.remaining);
  headline_ =
      text_of(progress.last_step > 0
                  ? fmt::format("Step {} of {}, {:.3f} revolutions, {:.4g} s. Remaining: {}.",
                                progress.step, progress.last_step, progress.revolutions,
                                progress.time, left)
                  : fmt::format("Step {}, {:.3f} revolutions, {:.4g} of {:.4g} s. Remaining: {}.",
                                progress.step, progress.revolutions, progress.time,
                                progress.end_time, left));
  showNote();
}

void RunPanel::show(const RunEnd& end) {
  if (end.outcome) {
    headline_ = headline_of(*end.outcome);
    recordFolderRun(end.outcome->status != runs::RunStatus::Interrupted);
    view_->setPlainText(report(*end.outcome));
    std::vector<Finding> found = end.outcome->warnings;
    for (Finding& finding : found) finding.message = replace_cli_terms(std::move(finding.message));
    findings_->setFindings(std::move(found));
    if (end.outcome->status == runs::RunStatus::Done) bar_->setValue(kBarSteps);
  } else if (end.sweep) {
    showSweep(*end.sweep);
  } else {
    const QString reason = text_of(replace_cli_terms(end.reason));
    // Progress is reported at intervals: a short run may have stored steps before.
    const RunResults since = results_in(resultFolder(), computed_deck_, run_start_time_);
    has_stored_steps_ = has_stored_steps_ || (!end.results_exist && since.moved);
    headline_ =
        has_stored_steps_
            ? tr("The run stopped at %1 %: %2").arg(100 * bar_->value() / kBarSteps).arg(reason)
            : tr("The deck was not run: %1").arg(reason);
    if (has_stored_steps_ && since.moved)
      headline_ += tr(" The results stored before the stop can be opened.");
  }
  view_->setVisible(!view_->toPlainText().isEmpty());
  showNote();
  enableButtons();
  if (end.results_exist) askToReplace();
  if ((end.outcome && end.outcome->status == runs::RunStatus::Done) ||
      (end.sweep && end.sweep->exit_code == 0)) {
    const RunResults found = results();
    // Not caused by a user action: the user may be typing.
    const bool plots = plots_at_end_->isChecked() && !found.plots.isEmpty();
    const bool animation = animation_at_end_->isChecked() && !found.animation.isEmpty();
    if (plots) showPlots(true);
    if (animation) showAnimation(true);
    if (plots || animation)
      view_->appendPlainText(tr("Opened in the background: %1. Press the buttons above to bring "
                                "the windows to the front.")
                                 .arg(plots && animation ? tr("plots and animation")
                                      : plots            ? tr("plots")
                                                         : tr("animation")));
  }
  emit finished();
}

void RunPanel::showNote() {
  note_->show();
  note_->setText(!stale_ ? headline_
                 : results_of_other_deck_
                     ? tr("Results of another deck, %1. ").arg(text_of(file_.string())) + headline_
                     : tr("Out of date: the deck has changed. ") + headline_);
}

void RunPanel::setOpenedFile(const std::filesystem::path& now) {
  if (computed_deck_.records.empty()) return;
  results_of_other_deck_ = now != file_;
  if (!busy()) showNote();
}

/// Findings of the run of this deck that is stored next to it.
void RunPanel::showStoredFindings() {
  const std::filesystem::path run = form_deck_file_.parent_path() / "RUN.json";
  const nlohmann::json of = results::read_run_member(run, "deck");
  const bool ours = of.is_string() && form_deck_file_.filename() == of.get<std::string>();
  findings_->setFindings(ours ? results::run_findings(run) : std::vector<Finding>());
}

void RunPanel::setDeck(const std::filesystem::path& file, const deck::Deck& deck,
                       const RunOptionValues& options) {
  const bool first = computed_deck_.records.empty();
  const bool opened = file != form_deck_file_;
  const bool looks = first && (opened || !(deck == form_deck_));
  form_deck_file_ = file;
  form_deck_ = deck;
  if (looks) {
    enableButtons();
    if (opened)
      showStoredFindings();
    else
      findings_->setFindings({});
  }
  if (first) return;
  // Results of another file are those of its folder, even if its values are now equal.
  const bool stale =
      results_of_other_deck_ || !(deck == computed_deck_ && options == computed_options_);
  if (stale == stale_) return;
  stale_ = stale;
  showNote();
}

void RunPanel::view(const QString& program, QStringList files, bool behind) {
  if (behind) files.prepend(desktop::kBehind);
  // New folders of runs are included.
  const bool ran = !computed_deck_.records.empty();
  show_in_viewer(this, launch, program, desktop::folder_of(ran ? file_ : form_deck_file_), files);
}

void RunPanel::openPlots() { showPlots(false); }

void RunPanel::openAnimation() { showAnimation(false); }

void RunPanel::showPlots(bool behind) {
  QStringList arguments = results().plots;
  if (arguments.isEmpty()) return enableViewers();  // gone a moment ago
  if (busy()) arguments.prepend("--follow");
  view("adrplot", arguments, behind);
}

void RunPanel::showAnimation(bool behind) {
  const QString file = results().animation;
  if (file.isEmpty()) return enableViewers();
  view("agore", {file}, behind);
}

void RunPanel::showListing() {
  const QString name = results().listing;
  InputFile file(name.toStdString());
  if (!file) return desktop::show_message(this, tr("%1 cannot be read").arg(name), true);
  QByteArray bytes(kMostShown, '\0');
  file.read(bytes.data(), bytes.size());
  bytes.truncate(static_cast<qsizetype>(file.gcount()));
  QString text = QString::fromUtf8(bytes).replace(QChar('\f'), QChar('\n'));
  if (file && file.peek() != std::char_traits<char>::eof())
    text += tr("\n… continued in %1").arg(name);
  auto* window = new QDialog(this);
  window->setObjectName("listing-window");
  desktop::delete_when_done(*window);
  window->setWindowTitle(name);
  desktop::resize_to_fit_screen(*window, {1080, 760});
  auto* listing = desktop::make_listing_view(name, window);
  listing->setPlainText(text);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, window);
  connect(buttons, &QDialogButtonBox::rejected, window, &QDialog::reject);
  auto* layout = new QVBoxLayout(window);
  layout->addWidget(listing, 1);
  layout->addWidget(buttons);
  window->show();  // next to the form, which keeps the focus
}

}  // namespace adore::adrinput
