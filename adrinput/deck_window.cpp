#include "adrinput/deck_window.hpp"

#include "adrinput/accuracy_panel.hpp"
#include "adrinput/compare_dialog.hpp"
#include "adrinput/drawing_panel.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/help_text.hpp"
#include "adrinput/lubricant_panel.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_list.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/run_panel.hpp"
#include "adrinput/solution_charts.hpp"
#include "adrinput/start_check.hpp"
#include "adrinput/sweep_range.hpp"
#include "adrinput/time_scale.hpp"
#include "adrinput/unit_choice.hpp"
#include "base/excerpt.hpp"
#include "deck/lookup.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/file_drops.hpp"
#include "desktop/flow_layout.hpp"
#include "desktop/menu_keys.hpp"
#include "desktop/theme.hpp"
#include "desktop/window_place.hpp"

#include <QAction>
#include <QBoxLayout>
#include <QDockWidget>
#include <QFontDatabase>
#include <QInputDialog>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStringDecoder>
#include <QTabWidget>
#include <QTimer>

#include <algorithm>
#include <exception>

namespace adore::adrinput {
namespace {

/// The letters of a file in UTF-8 or, where it is none, in Latin-1.
QString text_in(const std::string& bytes) {
  QStringDecoder decode(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
  QString text = decode(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
  return decode.hasError() ? QString::fromLatin1(bytes.data(), static_cast<qsizetype>(bytes.size()))
                           : text;
}

constexpr int kDrawingWidth = 300;  // of the drawing beside the form
constexpr int kListWidth = 144;     // of the records, at least
constexpr int kNarrow = 1100;       // a window whose form needs the room of list and drawing
constexpr int kFormWidth = 390;     // of a record's page, which scrolls where it needs more
constexpr int kCheckPause = 200;    // ms without a change before the model is built

/// A panel that may be lower than it needs to be.
QScrollArea* scrolled(QWidget* panel) {
  auto* area = new QScrollArea(panel->parentWidget());
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidget(panel);
  return area;
}

}  // namespace

DeckWindow::DeckWindow(QWidget* parent) : QMainWindow(parent) {
  desktop::take_files_anywhere(*this, [this](const QStringList& files) { openDropped(files); });
  desktop::open_at_size(*this, {1280, 860});
  check_ = new QTimer(this);
  check_->setSingleShot(true);
  check_->setInterval(kCheckPause);
  connect(check_, &QTimer::timeout, this, &DeckWindow::checkNow);
  scale_ = new TimeScale(this);
  scale_->found = [this](const deck::Deck& of, const std::optional<facade::RunScales>& scales) {
    const bool edited = check_->isActive();
    document_.set_scales(of, scales);
    if (!edited) check_->stop();  // nothing of the deck changed
  };
  start_check_ = new StartCheck(this);
  start_check_->found = [this](const Document::Candidate& of, std::vector<Issue> refusals) {
    const bool edited = check_->isActive();
    document_.set_rehearsal(of, std::move(refusals));
    if (edited) return;  // checkNow() comes
    check_->stop();
    askForStart();  // of the deck as it is by now
  };
  makeCentre();
  makeDrawing();
  makeFileMenu();
  makeOtherMenus();
  makeToolBar();
  new desktop::MenuKeys(*this);
  document_.meaning = [this](const Cell& cell, const std::string& typed) {
    return as_meant(document_, cell, typed);
  };
  document_.changed = [this] {
    check_->start();
    refresh();
    emit documentChanged();
  };
  showRecord(document_.pages().front());
  checkNow();
}

DeckWindow::~DeckWindow() {
  scale_->found = nullptr;
  start_check_->found = nullptr;
  document_.changed = nullptr;
  delete compare_;
  delete centralWidget();  // its fields speak to the document when they lose the focus
}

void DeckWindow::makeCentre() {
  list_ = new RecordList(document_, this);
  scroll_ = new QScrollArea(this);
  scroll_->setObjectName("form");
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);  // below 1000 pixels
  problems_ = new QListWidget(this);
  problems_->setObjectName("problems");
  problems_->setAccessibleName(tr("Problems"));
  problems_->setWordWrap(true);
  problems_->setResizeMode(QListView::Adjust);
  problems_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  problems_->setFrameShape(QFrame::NoFrame);
  connect(problems_, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { goToProblem(problems_->row(item)); });
  connect(problems_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { goToProblem(problems_->row(item)); });
  plan_ = new EvaluationPanel(
      &plan_of, tr("What this deck turns on and why, its unknowns and the expected cost: F5."),
      this);
  plan_->setObjectName("plan");
  statics_ = new EvaluationPanel(
      &quasi_static_of, tr("The quasi-static equilibrium of this deck and its fatigue life: F6."),
      this);
  statics_->setObjectName("statics");
  run_ = new RunPanel(this);
  connect(run_, &RunPanel::wanted, this, &DeckWindow::runDeck);
  connect(run_, &RunPanel::newFolderWanted, this, &DeckWindow::runInNewFolder);
  connect(run_, &RunPanel::continueWanted, this, &DeckWindow::continueRun);
  connect(run_, &RunPanel::sweepWanted, this, &DeckWindow::askForSweep);
  connect(run_, &RunPanel::finished, this, [this] {
    start_check_->forget();  // it may have looked at files that the run has replaced
    document_.forget_rehearsal();
  });
  accuracy_ = new AccuracyPanel(this);
  connect(accuracy_, &AccuracyPanel::wanted, this, &DeckWindow::studyAccuracy);
  connect(accuracy_, &AccuracyPanel::applyWanted, this, &DeckWindow::applyAccuracy);
  original_ = new QPlainTextEdit(this);
  original_->setObjectName("original");
  original_->setReadOnly(true);
  original_->setLineWrapMode(QPlainTextEdit::NoWrap);
  original_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  original_->setFrameShape(QFrame::NoFrame);
  original_->setTabChangesFocus(true);
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("panels");
  tabs_->setDocumentMode(true);
  tabs_->addTab(problems_, tr("Problems"));
  tabs_->addTab(plan_, tr("Plan"));
  tabs_->addTab(statics_, tr("Quasi-static"));
  tabs_->addTab(scrolled(run_), tr("Run"));
  tabs_->addTab(scrolled(accuracy_), tr("Accuracy"));
  tabs_->addTab(original_, tr("File as opened"));

  auto* form = new QWidget(this);
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  makeNotices(column);
  column->addWidget(scroll_, 1);
  column->addWidget(makeButtons());
  list_->setMinimumWidth(kListWidth);
  auto* right = new QSplitter(Qt::Vertical, this);
  right->addWidget(form);
  right->addWidget(tabs_);
  right->setMinimumWidth(kFormWidth);
  right->setStretchFactor(0, 3);
  right->setStretchFactor(1, 1);
  right->setSizes({620, 190});
  right->setChildrenCollapsible(false);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(list_);
  splitter->addWidget(right);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({width() < kNarrow ? kListWidth : 200, 1032});
  splitter->setChildrenCollapsible(false);
  setCentralWidget(splitter);
  connect(list_, &RecordList::recordChosen, this, [this](const QString& record) {
    showRecord(record.toStdString());
    list_->focusRecords();  // so that the arrow keys go on through the records
  });
  connect(list_, &RecordList::stateChosen, this, [this] {
    tabs_->setCurrentWidget(problems_);
    if (document_.problems().empty()) return;
    problems_->setCurrentRow(0);
    goToProblem(0);
  });
  connect(list_, &RecordList::variableChosen, this, [this](const QString& record, int variable) {
    Cell cell;
    cell.record = record.toStdString();
    cell.variable = static_cast<std::size_t>(variable);
    goTo(cell);
  });
}

void DeckWindow::goTo(const Cell& cell) {
  search_notice_->hide();  // of what was looked for before
  if (document_.instances(cell.record) == 0) return goToOptionOf(cell);
  showRecord(cell.record);
  page_->focusCell(cell);
}

void DeckWindow::makeDrawing() {
  lubricant_ = LubricantPanel::inDockOf(this);
  drawing_ = new DrawingPanel(this);
  drawing_dock_ = new QDockWidget(tr("Drawing"), this);
  drawing_dock_->setObjectName("drawing-dock");
  drawing_dock_->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
  drawing_dock_->setWidget(drawing_);
  addDockWidget(Qt::RightDockWidgetArea, drawing_dock_);
  resizeDocks({drawing_dock_}, {width() < kNarrow ? kDrawingWidth * 2 / 3 : kDrawingWidth},
              Qt::Horizontal);
  charts_ = new SolutionCharts(this);
  charts_dock_ = new QDockWidget(tr("Solution"), this);
  charts_dock_->setObjectName("solution-dock");
  charts_dock_->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
  charts_dock_->setWidget(charts_);
  addDockWidget(Qt::RightDockWidgetArea, charts_dock_);
  tabifyDockWidget(drawing_dock_, charts_dock_);
  // In one place with the others: below each other they are higher than a small screen.
  tabifyDockWidget(charts_dock_, findChild<QDockWidget*>("lubricant-dock"));
  charts_dock_->hide();  // until there is a solution
  drawing_dock_->raise();
  connect(statics_, &EvaluationPanel::finished, this, &DeckWindow::showCharts);
  drawing_->wording = [this](const std::string& name, int instance, int index) {
    const deck::VariableRef ref = deck::find_present(document_.deck(), name, instance);
    if (ref.record == nullptr || document_.instances(ref.record->id) == 0) return QString();
    return named_value(document_, {std::string(ref.record->id), instance, ref.position,
                                   static_cast<std::size_t>(index - 1)});
  };
  connect(
      drawing_, &DrawingPanel::fieldWanted, this,
      [this](const QString& name, int instance, int index) {
        const deck::VariableRef ref =
            deck::find_present(document_.deck(), name.toStdString(), instance);
        if (ref.record == nullptr) return;
        showRecord(std::string(ref.record->id));
        page_->focusCell({current_, instance, ref.position, static_cast<std::size_t>(index - 1)});
      });
}

QWidget* DeckWindow::makeButtons() {
  auto* bar = new QWidget(this);
  auto* row = new desktop::FlowLayout(bar);
  row->setContentsMargins(12, 6, 12, 6);
  const auto button = [&](const QString& text, const QString& name, const QString& help,
                          auto slot) {
    auto* push = new QPushButton(text, bar);
    push->setObjectName(name);
    push->setToolTip(help);
    push->setAutoDefault(true);
    connect(push, &QPushButton::clicked, this, slot);
    return push;
  };
  row->addWidget(button(tr("Go &Back"), "back", tr("The record before this one (Page Up)"),
                        &DeckWindow::goBack));
  row->addWidget(
      button(tr("&Next Rec"), "next", tr("The next record (Page Down)"), &DeckWindow::nextRecord));
  row->addStretch();
  row->addWidget(button(tr("Run &quasi-static now"), "run-statics",
                        tr("Equilibrium, contacts, stiffness and life of this deck (F6)"),
                        &DeckWindow::runQuasiStatic));
  row->addWidget(button(tr("R&un"), "run-deck", tr("Save the deck and run it whole (F7)"),
                        &DeckWindow::runDeck));
  row->addWidget(button(tr("Save && E&xit"), "save-exit", tr("Save the deck and end AdrInput"),
                        &DeckWindow::saveAndExit));
  return bar;
}

void DeckWindow::showRecord(const std::string& record) {
  if (record == current_ && page_ != nullptr) return page_->sync(true);
  document_.end_step();
  search_notice_->hide();
  current_ = record;
  if (scroll_->widget() != nullptr) scroll_->takeWidget()->deleteLater();
  page_ = new RecordPage(document_, record);
  connect(page_, &RecordPage::focusMoved, this,
          [this](QWidget* field) { scroll_->ensureWidgetVisible(field, 20, 60); });
  connect(page_, &RecordPage::otherUnitsWanted, other_units_, &QAction::setChecked);
  connect(page_, &RecordPage::unitChosen, this, [this] { showUnits(); });
  page_->setOtherUnits(other_units_->isChecked());
  connect(page_, &RecordPage::cellFocused, this, [this](const Cell& cell) {
    drawing_->setFocusOn({cell.record, std::string(variable_of(cell)->name), cell.instance,
                          static_cast<int>(cell.element) + 1});
  });
  scroll_->setWidget(page_);
  orderTabs();
  drawing_->setFocusOn({record, "", 1, 1});
  list_->setCurrent(record);
  page_->focusFirst();
  scroll_->ensureVisible(0, 0);
  askForScales();
  emit pageShown();
}

/// Other units of view were chosen.
void DeckWindow::showUnits() {
  page_->sync(true);
  drawing_->nameAnew();
}

/// Tab goes from the last field of a page on to what stands below it; Qt puts a new page last.
void DeckWindow::orderTabs() {
  QWidget* last = nullptr;
  std::vector<QWidget*> behind;
  for (QWidget* widget = scroll_->nextInFocusChain(); widget != scroll_ && widget != list_;
       widget = widget->nextInFocusChain()) {
    if (widget->focusPolicy() == Qt::NoFocus || widget->window() != this) continue;
    if (page_->isAncestorOf(widget))
      last = widget;
    else if (last == nullptr)
      behind.push_back(widget);
  }
  if (last == nullptr) return;
  const QWidget* form = scroll_->parentWidget();  // its buttons come before the panels below
  std::stable_partition(behind.begin(), behind.end(),
                        [&](const QWidget* widget) { return form->isAncestorOf(widget); });
  for (QWidget* widget : behind) {
    setTabOrder(last, widget);
    last = widget;
  }
}

void DeckWindow::refresh() {
  const std::vector<std::string> pages = document_.pages();
  list_->sync();
  if (std::find(pages.begin(), pages.end(), current_) == pages.end()) {
    // The page went away: show the one that stands where it stood.
    const auto spec_of = [](const std::string& id) { return deck::find_record(id); };
    std::string nearest = pages.front();
    for (const std::string& id : pages)
      if (id != kOptionsPage && spec_of(id) <= spec_of(current_)) nearest = id;
    showRecord(nearest);
  } else if (page_ != nullptr) {
    list_->setCurrent(current_);
    page_->sync();
  }
  refreshProblems();
  undo_->setEnabled(document_.can_undo());
  redo_->setEnabled(document_.can_redo());
  plan_->setDeck(document_.deck(), document_.options());
  statics_->setDeck(document_.deck(), document_.options());
  run_->setDeck(document_.path(), document_.deck(), document_.options());
  accuracy_->setDeck(document_.deck());
  charts_->setStale(statics_->stale());
  if (shown_original_ != document_.original()) {
    shown_original_ = document_.original();
    original_->setPlainText(text_in(shown_original_));
  }
  drawing_->setDeck(document_.deck());
  lubricant_->setDeck(document_.deck());
  const std::filesystem::path& shown =
      document_.draft().empty() ? document_.path() : document_.draft();
  const QString name =
      shown.empty()
          ? tr("new deck")
          : QString::fromStdString(
                (std::filesystem::absolute(shown).parent_path().filename() / shown.filename())
                    .string());
  setWindowTitle(name + "[*] — AdrInput");
  setWindowModified(document_.modified());
  refreshNotices();
}

void DeckWindow::refreshProblems() {
  const desktop::Theme& theme = desktop::current_theme();
  const int selected = problems_->currentRow();
  problems_->clear();
  int errors = 0;
  for (const Problem& problem : document_.problems()) {
    const Issue& issue = problem.issue;
    const bool error = issue.severity == Severity::Error;
    errors += error || problem.refused ? 1 : 0;
    QString text = error                                 ? tr("Error")
                   : problem.refused                     ? tr("Refused")
                   : issue.severity == Severity::Warning ? tr("Warning")
                                                         : tr("Note");
    if (!issue.record.empty())
      text += (issue.record == kOptionsPage ? QString(", %1") : tr(", record %1"))
                  .arg(QString::fromStdString(issue.record));
    if (!issue.variable.empty()) text += ", " + QString::fromStdString(issue.variable);
    if (!issue.value.empty()) text += " = " + QString::fromStdString(excerpt(issue.value));
    text += ": " + QString::fromStdString(issue.message);
    if (!issue.remedy.empty()) text += "; " + QString::fromStdString(issue.remedy);
    auto* item =
        new QListWidgetItem(state_icon(error ? RecordState::Wrong
                                       : problem.refused || issue.severity == Severity::Warning
                                           ? RecordState::Doubtful
                                           : RecordState::Untouched),
                            text, problems_);
    item->setForeground(error ? theme.red : theme.text);
  }
  if (problems_->count() == 0) {
    const bool ready = document_.deck_state() == DeckState::Ready;
    auto* item = new QListWidgetItem(
        state_icon(ready ? RecordState::Complete : RecordState::Untouched),
        ready ? tr("The deck is complete and has no problem.")
              : tr("The deck has no error; whether a run begins is being found out …"),
        problems_);
    item->setFlags(Qt::ItemIsEnabled);
  }
  problems_->setCurrentRow(std::min(selected, problems_->count() - 1));
  const auto total = static_cast<int>(document_.problems().size());
  QString title = tr("Problems");
  if (errors > 0 && errors == total)
    title += tr(" (%1 to mend)").arg(errors);
  else if (total > 0)
    title += tr(" (%1 to mend, %2 to note)").arg(errors).arg(total - errors);
  tabs_->setTabText(0, title);
}

void DeckWindow::goToProblem(int row) {
  if (row < 0 || row >= static_cast<int>(document_.problems().size())) return;
  const Problem problem = document_.problems()[static_cast<std::size_t>(row)];
  visited_problem_ = problem.issue.text();
  if (problem.page.empty()) return;
  showRecord(problem.page);
  if (problem.cell) page_->focusCell(*problem.cell);
}

void DeckWindow::stepProblem(int by) {
  const auto count = static_cast<int>(document_.problems().size());
  tabs_->setCurrentWidget(problems_);
  if (count == 0) return;
  const int here = problems_->currentRow();
  // One that is mended has left the list, and the next stands in its row.
  const bool mended =
      by > 0 && here >= 0 && here < count && !visited_problem_.empty() &&
      document_.problems()[static_cast<std::size_t>(here)].issue.text() != visited_problem_;
  const int row = mended ? here : (std::max(here, by > 0 ? -1 : 0) + by + count) % count;
  problems_->setCurrentRow(row);
  goToProblem(row);
}

void DeckWindow::nextProblem() { stepProblem(1); }
void DeckWindow::previousProblem() { stepProblem(-1); }

void DeckWindow::checkNow() {
  check_->stop();
  document_.check_model();
  check_->stop();  // what was just found is no change
  askForStart();
  askForScales();
}

void DeckWindow::askForStart() {
  if (document_.wants_rehearsal()) start_check_->ask(document_.candidate());
}

void DeckWindow::askForScales() {
  if (current_ != "2.1" || document_.typing() || document_.has_errors() || document_.scales())
    return;
  scale_->ask(document_.deck(), document_.options());
}

void DeckWindow::goBack() {
  const std::vector<std::string> pages = document_.pages();
  const auto here = std::find(pages.begin(), pages.end(), current_);
  if (here == pages.begin() || here == pages.end())
    return desktop::show_message(this, tr("This is the first record."));
  showRecord(*std::prev(here));
}

void DeckWindow::nextRecord() {
  document_.accept_defaults(current_);
  const std::vector<std::string> pages = document_.pages();
  const auto here = std::find(pages.begin(), pages.end(), current_);
  if (here == pages.end() || std::next(here) == pages.end())
    return desktop::show_message(
        this, tr("This is the last page. Save the deck with Save & Exit, or under File."));
  showRecord(*std::next(here));
}

void DeckWindow::undo() {
  const std::string record = document_.undo();
  if (record.empty()) return;
  const std::vector<std::string> pages = document_.pages();
  if (std::find(pages.begin(), pages.end(), record) != pages.end()) showRecord(record);
  page_->sync(true);
}

void DeckWindow::redo() {
  const std::string record = document_.redo();
  if (record.empty()) return;
  const std::vector<std::string> pages = document_.pages();
  if (std::find(pages.begin(), pages.end(), record) != pages.end()) showRecord(record);
  page_->sync(true);
}

bool DeckWindow::readyToCompute() {
  document_.end_step();  // what is being typed counts
  if (!document_.has_errors()) return true;
  desktop::show_message(this, tr("The deck has errors; mend them first (F8)."), true);
  return false;
}

void DeckWindow::showPanel(const QWidget* panel) {
  for (int i = 0; i < tabs_->count(); ++i)
    if (tabs_->widget(i)->isAncestorOf(panel)) tabs_->setCurrentIndex(i);
}

void DeckWindow::showPlan() {
  tabs_->setCurrentWidget(plan_);
  if (!readyToCompute()) return;
  plan_->start(document_.deck(), document_.path(), document_.options());
}

void DeckWindow::runQuasiStatic() {
  tabs_->setCurrentWidget(statics_);
  if (!readyToCompute()) return;
  statics_->start(document_.deck(), document_.path(), document_.options());
}

void DeckWindow::showCharts() {
  if (statics_->tables() == nullptr) return;
  charts_->setSolution(*statics_->tables());
  charts_->setStale(statics_->stale());
  if (!drawing_dock_->isHidden() || !charts_dock_->isHidden()) {
    const bool as_made = std::abs(drawing_dock_->width() - kDrawingWidth) < kDrawingWidth / 10;
    charts_dock_->show();
    charts_dock_->raise();
    // Keys of curves need more room than the drawing; a width that somebody chose stays.
    if (as_made && width() > kNarrow) resizeDocks({charts_dock_}, {width() / 3}, Qt::Horizontal);
  }
}

void DeckWindow::hideEmptyPanels() {
  if (statics_->tables() != nullptr || charts_dock_->isHidden()) return;
  charts_dock_->hide();
  if (!drawing_dock_->isHidden()) drawing_dock_->raise();
}

void DeckWindow::studyAccuracy() {
  showPanel(accuracy_);
  if (accuracy_->busy() || !readyToCompute()) return;
  accuracy_->start(document_.deck(), document_.options());
}

void DeckWindow::applyAccuracy() {
  try {
    document_.change(accuracy_->recommended());
    page_->sync(true);
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
}

void DeckWindow::runDeck() {
  showPanel(run_);
  if (run_->busy() || !readyToCompute()) return;
  withSavedDeck([this] { run_->start(document_.path(), document_.deck(), document_.options()); });
}

void DeckWindow::withSavedDeck(std::function<void()> then) {
  if (document_.path().empty()) return askForName(std::move(then));
  if (document_.modified()) return saveTo(document_.path(), std::move(then));
  then();
}

void DeckWindow::runInNewFolder() {
  showPanel(run_);
  if (run_->busy() || !readyToCompute()) return;
  withSavedDeck(
      [this] { run_->startInNewFolder(document_.path(), document_.deck(), document_.options()); });
}

void DeckWindow::continueRun() {
  showPanel(run_);
  if (run_->busy() || !readyToCompute()) return;
  withSavedDeck(
      [this] { run_->continueAny(document_.path(), document_.deck(), document_.options()); });
}

void DeckWindow::askForSweep() {
  showPanel(run_);
  if (run_->busy() || !readyToCompute()) return;
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName("sweep");
  desktop::delete_when_done(*dialog);
  dialog->setWindowTitle(tr("Sweep"));
  const auto tell = [this, dialog](const QString& typed) {
    QString told = tr("such as appLoadZ=500:1500:5 or appLoadZ=0.5 kN:1.5 kN:5");
    try {
      if (!typed.trimmed().isEmpty())
        told = QString::fromStdString(read_sweep(document_, typed.toStdString()).told);
    } catch (const InputError&) {
      const QString unit = QString::fromStdString(sweep_unit(document_, typed.toStdString()));
      if (!unit.isEmpty()) told = tr("a number without a unit is in %1").arg(unit);
    }
    dialog->setLabelText(tr("Variable, first and last value and number of runs:\n%1").arg(told));
  };
  tell({});
  connect(dialog, &QInputDialog::textValueChanged, this, tell);
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& typed) {
    try {
      const QString range = QString::fromStdString(read_sweep(document_, typed.toStdString()).set);
      withSavedDeck([this, range] {
        run_->sweep(document_.path(), document_.deck(), document_.options(), range);
      });
    } catch (const InputError& error) {
      desktop::show_message(this, QString::fromUtf8(error.what()), true);
    }
  });
  dialog->open();
}

void DeckWindow::switchTheme() {
  using desktop::ThemeKind;
  desktop::apply_theme(desktop::current_theme().kind == ThemeKind::Dark ? ThemeKind::Light
                                                                        : ThemeKind::Dark);
  desktop::remember_theme(desktop::current_theme().kind);
  for (auto* chart : findChildren<desktop::ChartView*>())
    chart->chartScene().setTheme(desktop::current_theme());
  const std::string record = std::exchange(current_, {});
  showRecord(record);
  refresh();
}

}  // namespace adore::adrinput
