#include "adrinput/file_names.hpp"
#include "adrinput/run_panel.hpp"
#include "adrinput/unfinished_runs.hpp"
#include "adrinput/window_words.hpp"
#include "base/counted.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/findings_bar.hpp"
#include "studies/sweep_mark.hpp"

#include <QAction>
#include <QCheckBox>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <fmt/format.h>

#include <algorithm>

/// Commands to run: again, in a new folder, continuation, or over a range.
namespace adore::adrinput {
namespace {

namespace fs = std::filesystem;

QString from(const fs::path& path) { return QString::fromStdString(path.string()); }

/// The first free folder "<stem>-001" and so on.
fs::path free_folder(const fs::path& beside, const std::string& stem) {
  std::error_code ignored;
  for (int number = 1;; ++number) {
    const auto folder = beside / fmt::format("{}-{:03d}", stem, number);
    if (!fs::exists(folder, ignored)) return folder;
  }
}

runs::RunRequest sweep_request(const fs::path& file, const fs::path& folder,
                               const std::string& range) {
  runs::RunRequest request;
  request.deck = file;
  request.out = folder;
  const QString text = QString::fromStdString(range);
  request.sets.emplace_back(text.section('=', 0, 0).trimmed().toStdString(),
                            text.section('=', 1).trimmed().toStdString());
  return request;
}

QString place_of(const fs::path& folder, const fs::path& file) {
  return folder == file.parent_path() ? RunPanel::tr("next to the deck")
                                      : RunPanel::tr("in %1").arg(from(folder.filename()));
}

}  // namespace

void RunPanel::start(const fs::path& file, const deck::Deck& deck, const RunOptionValues& options) {
  if (busy()) return;
  begin(file, deck, options);
  launchRun(canReplaceResults());
}

void RunPanel::begin(const fs::path& file, const deck::Deck& deck, const RunOptionValues& options) {
  computed_deck_ = deck;
  results_of_other_deck_ = false;
  computed_options_ = options;
  stale_ = false;
  file_ = file;
  result_folder_.clear();
  findings_->setFindings({});
}

void RunPanel::startInNewFolder(const fs::path& file, const deck::Deck& deck,
                                const RunOptionValues& options) {
  if (busy()) return;
  begin(file, deck, options);
  result_folder_ = free_folder(file.parent_path(), "run");
  launchRun(false);
}

void RunPanel::continueRun(const fs::path& file, const deck::Deck& deck,
                           const RunOptionValues& options, const fs::path& folder) {
  if (busy()) return;
  begin(file, deck, options);
  if (folder != file.parent_path()) result_folder_ = folder;
  runs::RunRequest request;
  request.deck = file_;
  if (!result_folder_.empty()) request.out = result_folder_;
  request.go_on = true;
  launchRequest(std::move(request));
}

void RunPanel::sweep(const fs::path& file, const deck::Deck& deck, const RunOptionValues& options,
                     const QString& range) {
  if (busy()) return;
  begin(file, deck, options);
  result_folder_ = free_folder(file.parent_path(), "sweep");
  launchRequest(sweep_request(file_, result_folder_, range.toStdString()));
}

/// Existing results of its runs are kept: for another deck or program all of them would be computed
/// again.
void RunPanel::continueSweep(const fs::path& folder, const deck::Deck& deck,
                             const RunOptionValues& options, const fs::path& file) {
  const auto mark = studies::read_sweep_manifest(folder);
  if (!mark) return;  // gone a moment ago
  runs::RunRequest request = sweep_request(file, folder, mark->range);
  if (mark->request != studies::sweep_digest(request))
    return desktop::show_message(
        this, tr("The sweep %1 cannot be continued: the deck, the values, the run options or the "
                 "program version have changed. Undo the change (Ctrl+Z), or start a new sweep.")
                  .arg(place_of(folder, file)));
  begin(file, deck, options);
  if (folder != file.parent_path()) result_folder_ = folder;
  request.go_on = true;
  launchRequest(std::move(request));
}

std::vector<RunPanel::Continuation> RunPanel::continuationChoices(const fs::path& file,
                                                                  const deck::Deck& deck) const {
  std::vector<Continuation> out;
  if (file.empty()) return out;
  const bool told = !computed_deck_.records.empty() && file == file_;
  const fs::path last = told ? resultFolder() : fs::path();
  std::error_code ignored;
  const auto add = [&](const fs::path& folder, const std::string& state, bool sweep) {
    if (std::none_of(out.begin(), out.end(), [&](const Continuation& way) {
          return way.folder == folder && way.sweep == sweep;
        }))
      out.push_back({folder, QString::fromStdString(state), sweep});
  };
  const std::vector<UnfinishedSweep> sweeps = unfinished_sweeps(file);
  if (told && !shows_sweep_ && fs::exists(last / "RUN.json", ignored))
    add(last, "last run of this window", false);
  for (const UnfinishedSweep& one : sweeps)
    if (told && shows_sweep_ && one.folder == last) add(last, one.state, true);
  for (const UnfinishedSweep& one : sweeps) add(one.folder, one.state, true);
  for (const UnfinishedRun& one : unfinished_runs(file, deck)) add(one.folder, one.state, false);
  return out;
}

void RunPanel::continueFrom(const Continuation& way, const fs::path& file, const deck::Deck& deck,
                            const RunOptionValues& options) {
  if (way.sweep) return continueSweep(way.folder, deck, options, file);
  continueRun(file, deck, options, way.folder);
}

void RunPanel::continueInterruptedRun(const fs::path& file, const deck::Deck& deck,
                                      const RunOptionValues& options) {
  if (busy()) return;
  const std::vector<Continuation> ways = continuationChoices(file, deck);
  if (ways.empty()) return continueRun(file, deck, options);
  if (ways.size() == 1) return continueFrom(ways.front(), file, deck, options);
  QStringList names;
  for (const Continuation& way : ways)
    names << tr("%1: %2").arg(
        way.folder == file.parent_path() ? tr("next to the deck") : from(way.folder.filename()),
        way.state);
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName("continue-which");
  desktop::delete_when_done(*dialog);
  dialog->setWindowTitle(tr("Continue a run"));
  dialog->setLabelText(tr("Several runs of %1 can be continued. Which one?")
                           .arg(QString::fromStdString(shortened_path(file))));
  dialog->setComboBoxItems(names);
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, ways, names, file, deck, options](const QString& name) {
            const auto index = names.indexOf(name);
            if (index >= 0 && !busy())
              continueFrom(ways[static_cast<std::size_t>(index)], file, deck, options);
          });
  dialog->open();
}

void RunPanel::updateContinueAction(QAction& action) const {
  const std::vector<Continuation> ways = continuationChoices(form_deck_file_, form_deck_);
  const fs::path beside = form_deck_file_.parent_path();
  if (ways.size() > 1) {
    action.setText(tr("&Continue a run …"));
    action.setToolTip(tr("Several runs can be continued"));
  } else if (ways.size() == 1) {
    const QString place = place_of(ways.front().folder, form_deck_file_);
    action.setText(ways.front().sweep ? tr("&Continue the sweep %1").arg(place)
                                      : tr("&Continue the run %1").arg(place));
    action.setToolTip(ways.front().sweep ? from(ways.front().folder) + ": " + ways.front().state
                                         : from(ways.front().folder));
  } else if (!form_deck_file_.empty() && can_continue(beside, form_deck_)) {
    action.setText(tr("&Continue the run %1").arg(place_of(beside, form_deck_file_)));
    action.setToolTip(from(beside));
  } else {
    action.setText(tr("&Continue the run"));
    action.setToolTip(tr("There is no run to continue"));
  }
}

fs::path RunPanel::resultFolder() const {
  return result_folder_.empty() ? file_.parent_path() : result_folder_;
}

void RunPanel::launchRun(bool overwrite) {
  runs::RunRequest request;
  request.deck = file_;
  if (!result_folder_.empty()) request.out = result_folder_;
  request.overwrite = overwrite;
  launchRequest(std::move(request));
}

void RunPanel::launchRequest(runs::RunRequest request) {
  run_start_time_ = fs::file_time_type::clock::now();
  has_stored_steps_ = false;
  view_->hide();
  view_->clear();
  bar_->setValue(0);
  shows_sweep_ = studies::is_sweep(request);
  headline_ = shows_sweep_     ? tr("Starting the sweep …")
              : !request.go_on ? tr("Computing the initial equilibrium …")
              : result_folder_.empty()
                  ? tr("Reading the stored state …")
                  : tr("Reading the stored state in %1 …").arg(from(result_folder_.filename()));
  showNote();
  run_.start(std::move(request));
  enableButtons();
}

std::optional<fs::file_time_type> RunPanel::reportTime() const {
  std::error_code error;
  const auto time = fs::last_write_time(resultFolder() / "RUN.json", error);
  if (error) return {};
  return time;
}

void RunPanel::recordFolderRun(bool whole) {
  if (const auto time = reportTime())
    folder_runs_[resultFolder()] = {*time, computed_deck_, computed_options_, whole};
}

/// Do the results in the folder come from this panel?
bool RunPanel::computedByThisWindow() const {
  const auto made = folder_runs_.find(resultFolder());
  return made != folder_runs_.end() && made->second.report == reportTime();
}

bool RunPanel::canReplaceResults() const {
  if (!computedByThisWindow()) return false;
  const FolderRun& made = folder_runs_.at(resultFolder());
  return replace_without_asking_ ||
         (made.whole && made.deck == computed_deck_ && made.options == computed_options_);
}

void RunPanel::askToReplace() {
  const bool mine = computedByThisWindow();
  const bool cancelled = mine && !folder_runs_.at(resultFolder()).whole;
  const QString what = cancelled ? tr("results of a cancelled run")
                       : mine ? tr("results that this window computed before the deck was changed")
                              : tr("results of an earlier run");
  auto* box = new QMessageBox(QMessageBox::Question, "AdrInput",
                              tr("The folder contains %1. Replace them?").arg(what) + "\n\n" +
                                  QString::fromStdString(shortened_path(resultFolder())),
                              QMessageBox::Cancel, this);
  box->setObjectName("replace-results");
  desktop::delete_when_done(*box);
  box->setDefaultButton(QMessageBox::Cancel);
  auto* always = new QCheckBox(tr("Do not ask again &while this window is open"), box);
  always->setObjectName("replace-unasked");
  box->setCheckBox(always);
  const auto answer = [&](const QString& text, const char* name, QMessageBox::ButtonRole role) {
    QPushButton* button = box->addButton(text, role);
    button->setObjectName(name);
    return button;
  };
  QPushButton* go_on = nullptr;
  if (can_continue(resultFolder(), computed_deck_))
    go_on = answer(tr("C&ontinue the run"), "continue-instead", QMessageBox::ActionRole);
  QPushButton* beside =
      answer(tr("Run in a &new folder"), "new-folder-instead", QMessageBox::ActionRole);
  QPushButton* replace = answer(tr("&Replace them"), "replace-them", QMessageBox::DestructiveRole);
  connect(box, &QMessageBox::buttonClicked, this,
          [this, go_on, beside, replace, always](QAbstractButton* button) {
            if (busy()) return;
            if (button == replace) {
              replace_without_asking_ = replace_without_asking_ || always->isChecked();
              launchRun(true);
            }
            if (button == beside) startInNewFolder(file_, computed_deck_, computed_options_);
            if (go_on != nullptr && button == go_on)
              continueRun(file_, computed_deck_, computed_options_);
          });
  box->open();
}

void RunPanel::showSweep(const studies::SweepOutcome& sweep) {
  constexpr int kCancelled = 130;
  const bool cancelled = sweep.exit_code == kCancelled;
  QString text = tr("Table: %1\n").arg(from(sweep.table));
  if (!cancelled) {
    bar_->setValue(bar_->maximum());
    headline_ = sweep.failed == 0
                    ? tr("The sweep is done.")
                    : tr("The sweep is complete, but %1 without a result (see the table). To "
                         "repeat these runs, select Run > Continue the sweep %2.")
                          .arg(QString::fromStdString(counted(sweep.failed, "run is", "runs are")))
                          .arg(place_of(resultFolder(), file_));
  } else {
    headline_ = tr("The sweep was cancelled. The table contains the finished runs. To continue, "
                   "select Run > Continue the sweep %1.")
                    .arg(place_of(resultFolder(), file_));
  }
  for (const Issue& issue : sweep.warnings)
    text += QString::fromStdString(replace_cli_terms(issue.text())) + "\n";
  view_->setPlainText(text);
}

}  // namespace adore::adrinput
