#include "adrinput/deck_window.hpp"

#include "adrinput/accuracy_panel.hpp"
#include "adrinput/compare_dialog.hpp"
#include "adrinput/design_form.hpp"
#include "adrinput/design_page.hpp"
#include "adrinput/drawing_panel.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/find_dialog.hpp"
#include "adrinput/help_text.hpp"
#include "adrinput/lubricant_panel.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_list.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/run_panel.hpp"
#include "adrinput/run_times.hpp"
#include "adrinput/solution_charts.hpp"
#include "adrinput/start_check.hpp"
#include "adrinput/stored_accuracy.hpp"
#include "adrinput/text_keys.hpp"
#include "adrinput/time_scale.hpp"
#include "adrinput/unit_choice.hpp"
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

/// Decodes a file as UTF-8 or, if invalid, as Latin-1.
QString text_in(const std::string& bytes) {
  QStringDecoder decode(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
  QString text = decode(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
  return decode.hasError() ? QString::fromLatin1(bytes.data(), static_cast<qsizetype>(bytes.size()))
                           : text;
}

constexpr int kListWidth = 144;   // of the records, at least
constexpr int kFormWidth = 320;   // of the page of a record, which scrolls if necessary
constexpr int kUsualForm = 390;   // fits the window at start
constexpr int kCheckPause = 200;  // ms without a change before the model is built

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

/// Of an array without elements, which has no field, the variable that counts them.
std::optional<Cell> count_of_none(const Document& document, const Cell& cell) {
  const deck::RecordSpec& spec = *page_record(cell.record);
  const auto count =
      std::find_if(spec.variables.begin(), spec.variables.end(),
                   [&](const auto& one) { return one.name == variable_of(cell)->length; });
  if (count == spec.variables.end()) return std::nullopt;
  const Cell at{cell.record, cell.instance,
                static_cast<std::size_t>(count - spec.variables.begin()), 0};
  if (document.has_unparsed_text(at) || document.deck().integer(count->name) != 0)
    return std::nullopt;
  return at;
}

}  // namespace

DeckWindow::DeckWindow(QWidget* parent) : QMainWindow(parent) {
  desktop::accept_file_drops(*this, [this](const QStringList& files) { openDroppedFile(files); });
  desktop::resize_to_fit_screen(*this, {1280, 860});
  check_timer_ = new QTimer(this);
  check_timer_->setSingleShot(true);
  check_timer_->setInterval(kCheckPause);
  connect(check_timer_, &QTimer::timeout, this, &DeckWindow::checkNow);
  time_scale_ = new TimeScale(this);
  time_scale_->found = [this](const deck::Deck& of, const std::optional<runs::RunScales>& scales) {
    const bool edited = check_timer_->isActive();
    document_.set_scales(of, scales);
    const bool taken = apply_pending_times(document_);
    if (!edited && !taken) check_timer_->stop();  // nothing of the deck changed
  };
  start_check_ = new StartCheck(this);
  start_check_->found = [this](const Document::Candidate& of, runs::DryRunResult rehearsal) {
    const bool edited = check_timer_->isActive();
    document_.set_start_check_result(of, std::move(rehearsal.refusals),
                                     std::move(rehearsal.remarks));
    if (edited) return;  // checkNow() comes
    check_timer_->stop();
    requestStartCheck();  // of the current deck
  };
  makeCentralWidget();
  makeDocks();
  makeFileMenu();
  makeOtherMenus();
  makeToolBar();
  new desktop::MenuKeys(*this);
  new TextKeys(*this);
  document_.meaning = [this](const Cell& cell, const std::string& typed) {
    return add_display_unit(document_, cell, typed);
  };
  document_.changed = [this] {
    check_timer_->start();
    refresh();
    emit documentChanged();
  };
  showRecord(document_.pages().front());
  checkNow();
}

DeckWindow::~DeckWindow() {
  time_scale_->found = nullptr;
  start_check_->found = nullptr;
  document_.changed = nullptr;
  delete compare_dialog_;
  delete centralWidget();  // its fields speak to the document when they lose the focus
}

void DeckWindow::makeCentralWidget() {
  list_ = new RecordList(document_, this);
  scroll_area_ = new QScrollArea(this);
  scroll_area_->setObjectName("form");
  scroll_area_->setAccessibleName(tr("Fields of the record"));
  scroll_area_->setWidgetResizable(true);
  scroll_area_->setFrameShape(QFrame::NoFrame);
  scroll_area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);  // below 1000 pixels
  problem_list_ = new QListWidget(this);
  problem_list_->setObjectName("problems");
  problem_list_->setAccessibleName(tr("Problems"));
  problem_list_->setWordWrap(true);
  problem_list_->setResizeMode(QListView::Adjust);
  problem_list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  problem_list_->setFrameShape(QFrame::NoFrame);
  connect(problem_list_, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { goToProblem(problem_list_->row(item)); });
  connect(problem_list_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { goToProblem(problem_list_->row(item)); });
  plan_panel_ =
      new EvaluationPanel(&evaluate_plan,
                          tr("Press F5 to list the effects that this deck simulates, with "
                             "reasons, and to estimate the computing time."),
                          this);
  plan_panel_->setObjectName("plan");
  plan_panel_->setTextAccessibleName(tr("Plan"));
  statics_panel_ = new EvaluationPanel(
      &evaluate_quasi_static,
      tr("Press F6 to compute the quasi-static equilibrium and the fatigue life of this deck."),
      this);
  statics_panel_->setObjectName("statics");
  statics_panel_->setTextAccessibleName(tr("Quasi-static solution"));
  for (const EvaluationPanel* panel : {plan_panel_, statics_panel_})
    connect(panel, &EvaluationPanel::findingChosen, this, &DeckWindow::goToFinding);
  run_panel_ = new RunPanel(this);
  connect(run_panel_, &RunPanel::wanted, this, &DeckWindow::runDeck);
  connect(run_panel_, &RunPanel::findingChosen, this, &DeckWindow::goToFinding);
  connect(run_panel_, &RunPanel::newFolderRequested, this, &DeckWindow::runInNewFolder);
  connect(run_panel_, &RunPanel::continueRequested, this, &DeckWindow::continueRun);
  connect(run_panel_, &RunPanel::sweepRequested, this, &DeckWindow::askForSweep);
  connect(run_panel_, &RunPanel::finished, this, [this] {
    start_check_->invalidateResult();  // it may have looked at files that the run has replaced
    document_.invalidate_start_check();
  });
  accuracy_panel_ = new AccuracyPanel(this);
  connect(accuracy_panel_, &AccuracyPanel::wanted, this, &DeckWindow::studyAccuracy);
  connect(accuracy_panel_, &AccuracyPanel::applyRequested, this,
          &DeckWindow::applyAccuracySettings);
  original_view_ = new QPlainTextEdit(this);
  original_view_->setObjectName("original");
  original_view_->setAccessibleName(tr("Deck file as opened"));
  original_view_->setReadOnly(true);
  original_view_->setLineWrapMode(QPlainTextEdit::NoWrap);
  original_view_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  original_view_->setFrameShape(QFrame::NoFrame);
  original_view_->setTabChangesFocus(true);
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("panels");
  tabs_->setDocumentMode(true);
  tabs_->addTab(problem_list_, tr("Problems"));
  tabs_->addTab(plan_panel_, tr("Plan"));
  tabs_->addTab(statics_panel_, tr("Quasi-static"));
  tabs_->addTab(scrolled(run_panel_), tr("Run"));
  tabs_->addTab(scrolled(accuracy_panel_), tr("Accuracy"));
  tabs_->addTab(original_view_, tr("File as opened"));
  connect(tabs_, &QTabWidget::currentChanged, this, [this](int now) {
    if (tabs_->widget(now)->isAncestorOf(accuracy_panel_))
      accuracy_panel_->setStoredAccuracy(QString::fromStdString(
          stored_accuracy(document_.path(), document_.deck(), document_.options())));
  });

  auto* form = new QWidget(this);
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  makeNotices(column);
  column->addWidget(scroll_area_, 1);
  column->addWidget(makeDesignPage(), 1);
  column->addWidget(buttons_ = makeButtons());
  list_->setMinimumWidth(kListWidth);
  auto* right = new QSplitter(Qt::Vertical, this);
  right->addWidget(form);
  right->addWidget(tabs_);
  constexpr int kRoomForUsual = 700;  // of the window; a screen of 640x480 has less
  right->setMinimumWidth(width() < kRoomForUsual ? kFormWidth : kUsualForm);
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
    list_->focusRecords();  // so that the arrow keys move through the records
  });
  connect(list_, &RecordList::stateClicked, this, [this] {
    tabs_->setCurrentWidget(problem_list_);
    if (document_.problems().empty()) return;
    problem_list_->setCurrentRow(0);
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
  search_notice_->hide();  // of the previous search
  if (document_.instances(cell.record) == 0) return goToEnablingOption(cell);
  showRecord(cell.record);
  const std::optional<Cell> count = count_of_none(document_, cell);
  record_page_->focusCell(count ? *count : cell);
  if (count)
    search_notice_->ask(
        tr("%1 has no fields because %2 (number of fields) is 0. Enter a larger %2.")
            .arg(QString::fromStdString(std::string(variable_of(cell)->name)),
                 QString::fromStdString(std::string(variable_of(*count)->name))),
        {{"leave-option", tr("Ignore"), nullptr}});
}

void DeckWindow::makeDocks() {
  lubricant_panel_ = LubricantPanel::createInDock(this);
  drawing_panel_ = new DrawingPanel(this);
  drawing_dock_ = new QDockWidget(tr("Drawing"), this);
  drawing_dock_->setObjectName("drawing-dock");
  drawing_dock_->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
  drawing_dock_->setWidget(drawing_panel_);
  addDockWidget(Qt::RightDockWidgetArea, drawing_dock_);
  resizeDocks({drawing_dock_}, {width() < kNarrow ? kDrawingWidth * 2 / 3 : kDrawingWidth},
              Qt::Horizontal);
  solution_charts_ = new SolutionCharts(this);
  charts_dock_ = new QDockWidget(tr("Solution"), this);
  charts_dock_->setObjectName("solution-dock");
  charts_dock_->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
  charts_dock_->setWidget(solution_charts_);
  addDockWidget(Qt::RightDockWidgetArea, charts_dock_);
  tabifyDockWidget(drawing_dock_, charts_dock_);
  // In one area with the others: below each other they are higher than a small screen.
  tabifyDockWidget(charts_dock_, findChild<QDockWidget*>("lubricant-dock"));
  charts_dock_->hide();  // until there is a solution
  drawing_dock_->raise();
  connect(statics_panel_, &EvaluationPanel::finished, this, &DeckWindow::showCharts);
  drawing_panel_->wording = [this](const std::string& name, int instance, int index) {
    const deck::VariableRef ref = deck::find_present_variable(document_.deck(), name, instance);
    if (ref.record == nullptr || document_.instances(ref.record->id) == 0) return QString();
    return name_and_value(document_, {std::string(ref.record->id), instance, ref.position,
                                      static_cast<std::size_t>(index - 1)});
  };
  connect(drawing_panel_, &DrawingPanel::fieldRequested, this,
          [this](const QString& name, int instance, int index) {
            const deck::VariableRef ref =
                deck::find_present_variable(document_.deck(), name.toStdString(), instance);
            if (ref.record == nullptr) return;
            showRecord(std::string(ref.record->id));
            record_page_->focusCell(
                {current_record_, instance, ref.position, static_cast<std::size_t>(index - 1)});
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
  row->addWidget(
      button(tr("Go &Back"), "back", tr("Previous record (Page Up)"), &DeckWindow::goBack));
  row->addWidget(
      button(tr("&Next Rec"), "next", tr("Next record (Page Down)"), &DeckWindow::nextRecord));
  row->addStretch();
  row->addWidget(
      button(tr("Run &quasi-static now"), "run-statics",
             tr("Compute equilibrium, contacts, stiffness and fatigue life for this deck (F6)"),
             &DeckWindow::runQuasiStatic));
  row->addWidget(
      button(tr("R&un"), "run-deck", tr("Save the deck and run it (F7)"), &DeckWindow::runDeck));
  row->addWidget(button(tr("Save && E&xit"), "save-exit", tr("Save the deck and close AdrInput"),
                        &DeckWindow::saveAndExit));
  return bar;
}

void DeckWindow::showRecord(const std::string& record) {
  hideDesign();
  buildRecordPage(record);
}

void DeckWindow::buildRecordPage(const std::string& record) {
  if (record == current_record_ && record_page_ != nullptr) return record_page_->sync(true);
  document_.end_undo_step();
  search_notice_->hide();
  current_record_ = record;
  if (scroll_area_->widget() != nullptr) scroll_area_->takeWidget()->deleteLater();
  record_page_ = new RecordPage(document_, record);
  connect(record_page_, &RecordPage::focusMoved, this,
          [this](QWidget* field) { scroll_area_->ensureWidgetVisible(field, 20, 60); });
  connect(record_page_, &RecordPage::otherUnitsToggled, other_units_, &QAction::setChecked);
  connect(record_page_, &RecordPage::unitChosen, this, [this] { showUnits(); });
  record_page_->setOtherUnitsShown(other_units_->isChecked());
  connect(record_page_, &RecordPage::cellFocused, this, [this](const Cell& cell) {
    drawing_panel_->setFocusOn({cell.record, std::string(variable_of(cell)->name), cell.instance,
                                static_cast<int>(cell.element) + 1});
  });
  scroll_area_->setWidget(record_page_);
  updateTabOrder();
  drawing_panel_->setFocusOn({record, "", 1, 1});
  list_->setCurrentRecord(currentPage());
  if (!isDesignShown()) record_page_->focusFirst();
  scroll_area_->ensureVisible(0, 0);
  requestTimeScales();
  emit pageShown();
}

/// Other units of view were chosen.
void DeckWindow::showUnits() {
  record_page_->sync(true);
  drawing_panel_->updateNames();
}

/// Tab moves from the last field of a page to the widgets below it; Qt puts a new page last.
void DeckWindow::updateTabOrder() {
  QWidget* last = nullptr;
  std::vector<QWidget*> behind;
  for (QWidget* widget = scroll_area_->nextInFocusChain();
       widget != scroll_area_ && widget != list_; widget = widget->nextInFocusChain()) {
    if (widget->focusPolicy() == Qt::NoFocus || widget->window() != this) continue;
    if (record_page_->isAncestorOf(widget))
      last = widget;
    else if (last == nullptr)
      behind.push_back(widget);
  }
  if (last == nullptr) return;
  const QWidget* form = scroll_area_->parentWidget();  // its buttons come before the panels below
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
  if (std::find(pages.begin(), pages.end(), current_record_) == pages.end()) {
    // The page was removed: show its successor.
    const auto spec_of = [](const std::string& id) { return deck::find_record(id); };
    std::string nearest = pages.front();
    for (const std::string& id : pages)
      if (id != kOptionsPage && spec_of(id) <= spec_of(current_record_)) nearest = id;
    buildRecordPage(nearest);
  } else if (record_page_ != nullptr) {
    list_->setCurrentRecord(currentPage());
    record_page_->sync();
  }
  design_page_->sync();
  refreshProblems();
  undo_->setEnabled(document_.can_undo());
  redo_->setEnabled(document_.can_redo());
  plan_panel_->setDeck(document_.deck(), document_.options());
  statics_panel_->setDeck(document_.deck(), document_.options());
  run_panel_->setDeck(document_.path(), document_.deck(), document_.options());
  accuracy_panel_->setDeck(document_.deck());
  solution_charts_->setStale(statics_panel_->stale());
  if (shown_original_ != document_.original()) {
    shown_original_ = document_.original();
    original_view_->setPlainText(text_in(shown_original_));
  }
  drawing_panel_->setDeck(document_.deck());
  lubricant_panel_->setDeck(document_.deck());
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

void DeckWindow::checkNow() {
  check_timer_->stop();
  apply_pending_times(document_);  // the scale may have been found while something was typed
  document_.check_model();
  check_timer_->stop();  // the change by this check needs no other check
  requestStartCheck();
  requestTimeScales();
}

void DeckWindow::requestStartCheck() {
  if (document_.needs_start_check()) start_check_->ask(document_.candidate());
}

void DeckWindow::requestTimeScales() {
  if (current_record_ != "2.1" && !has_pending_times(document_)) return;
  if (const auto deck = deck_without_scales(document_))
    time_scale_->ask(*deck, document_.options());
}

void DeckWindow::goBack() {
  if (isDesignShown()) return;
  const std::vector<std::string> pages = document_.pages();
  const auto here = std::find(pages.begin(), pages.end(), current_record_);
  if (here == pages.begin() || here == pages.end())
    return desktop::show_message(this, tr("This is the first record."));
  showRecord(*std::prev(here));
}

void DeckWindow::nextRecord() {
  if (isDesignShown()) return showRecord(document_.pages().front());
  document_.accept_defaults(current_record_);
  const std::vector<std::string> pages = document_.pages();
  const auto here = std::find(pages.begin(), pages.end(), current_record_);
  if (here == pages.end() || std::next(here) == pages.end())
    return desktop::show_message(
        this, tr("This is the last page. Save the deck with \"Save & Exit\" or in the menu File."));
  showRecord(*std::next(here));
}

void DeckWindow::undo() {
  design_page_->form().commitFields();
  showChangedRecord(document_.undo());
}

void DeckWindow::redo() { showChangedRecord(document_.redo()); }

/// The record of an undone change; the front page stays.
void DeckWindow::showChangedRecord(const std::string& record) {
  if (record.empty()) return;
  const std::vector<std::string> pages = document_.pages();
  if (std::find(pages.begin(), pages.end(), record) != pages.end()) buildRecordPage(record);
  record_page_->sync(true);
}

void DeckWindow::switchTheme() {
  using desktop::ThemeKind;
  desktop::apply_theme(desktop::current_theme().kind == ThemeKind::Dark ? ThemeKind::Light
                                                                        : ThemeKind::Dark);
  desktop::remember_theme(desktop::current_theme().kind);
  for (auto* chart : findChildren<desktop::ChartView*>())
    chart->chartScene().setTheme(desktop::current_theme());
  const std::string record = std::exchange(current_record_, {});
  buildRecordPage(record);
  refresh();
  design_page_->restyle();
}

}  // namespace adore::adrinput
