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
  if (document.is_draft(at) || document.deck().integer(count->name) != 0) return std::nullopt;
  return at;
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
  scale_->found = [this](const deck::Deck& of, const std::optional<runs::RunScales>& scales) {
    const bool edited = check_->isActive();
    document_.set_scales(of, scales);
    const bool taken = take_waiting_times(document_);
    if (!edited && !taken) check_->stop();  // nothing of the deck changed
  };
  start_check_ = new StartCheck(this);
  start_check_->found = [this](const Document::Candidate& of, runs::Rehearsal rehearsal) {
    const bool edited = check_->isActive();
    document_.set_rehearsal(of, std::move(rehearsal.refusals), std::move(rehearsal.remarks));
    if (edited) return;  // checkNow() comes
    check_->stop();
    askForStart();  // of the current deck
  };
  makeCentre();
  makeDrawing();
  makeFileMenu();
  makeOtherMenus();
  makeToolBar();
  new desktop::MenuKeys(*this);
  new TextKeys(*this);
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
  scroll_->setAccessibleName(tr("Fields of the record"));
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
  plan_ = new EvaluationPanel(&plan_of,
                              tr("Press F5 to list the effects that this deck simulates, with "
                                 "reasons, and to estimate the computing time."),
                              this);
  plan_->setObjectName("plan");
  plan_->setTextName(tr("Plan"));
  statics_ = new EvaluationPanel(
      &quasi_static_of,
      tr("Press F6 to compute the quasi-static equilibrium and the fatigue life of this deck."),
      this);
  statics_->setObjectName("statics");
  statics_->setTextName(tr("Quasi-static solution"));
  for (const EvaluationPanel* panel : {plan_, statics_})
    connect(panel, &EvaluationPanel::findingChosen, this, &DeckWindow::goToFinding);
  run_ = new RunPanel(this);
  connect(run_, &RunPanel::wanted, this, &DeckWindow::runDeck);
  connect(run_, &RunPanel::findingChosen, this, &DeckWindow::goToFinding);
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
  original_->setAccessibleName(tr("Deck file as opened"));
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
  connect(tabs_, &QTabWidget::currentChanged, this, [this](int now) {
    if (tabs_->widget(now)->isAncestorOf(accuracy_))
      accuracy_->setStored(QString::fromStdString(
          stored_accuracy(document_.path(), document_.deck(), document_.options())));
  });

  auto* form = new QWidget(this);
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  makeNotices(column);
  column->addWidget(scroll_, 1);
  column->addWidget(makeDesign(), 1);
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
  search_notice_->hide();  // of the previous search
  if (document_.instances(cell.record) == 0) return goToOptionOf(cell);
  showRecord(cell.record);
  const std::optional<Cell> count = count_of_none(document_, cell);
  page_->focusCell(count ? *count : cell);
  if (count)
    search_notice_->ask(
        tr("%1 has no fields because %2 (number of fields) is 0. Enter a larger %2.")
            .arg(QString::fromStdString(std::string(variable_of(cell)->name)),
                 QString::fromStdString(std::string(variable_of(*count)->name))),
        {{"leave-option", tr("Ignore"), nullptr}});
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
  // In one area with the others: below each other they are higher than a small screen.
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
  row->addWidget(
      button(tr("Go &Back"), "back", tr("Previous record (Page Up)"), &DeckWindow::goBack));
  row->addWidget(
      button(tr("&Next Rec"), "next", tr("Next record (Page Down)"), &DeckWindow::nextRecord));
  row->addStretch();
  row->addWidget(button(tr("Run &quasi-static now"), "run-statics",
                        tr("Equilibrium, contacts, stiffness and life of this deck (F6)"),
                        &DeckWindow::runQuasiStatic));
  row->addWidget(
      button(tr("R&un"), "run-deck", tr("Save the deck and run it (F7)"), &DeckWindow::runDeck));
  row->addWidget(button(tr("Save && E&xit"), "save-exit", tr("Save the deck and close AdrInput"),
                        &DeckWindow::saveAndExit));
  return bar;
}

void DeckWindow::showRecord(const std::string& record) {
  leaveDesign();
  loadRecord(record);
}

void DeckWindow::loadRecord(const std::string& record) {
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
  list_->setCurrent(currentPage());
  if (!designShown()) page_->focusFirst();
  scroll_->ensureVisible(0, 0);
  askForScales();
  emit pageShown();
}

/// Other units of view were chosen.
void DeckWindow::showUnits() {
  page_->sync(true);
  drawing_->nameAnew();
}

/// Tab moves from the last field of a page to the widgets below it; Qt puts a new page last.
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
    // The page was removed: show its successor.
    const auto spec_of = [](const std::string& id) { return deck::find_record(id); };
    std::string nearest = pages.front();
    for (const std::string& id : pages)
      if (id != kOptionsPage && spec_of(id) <= spec_of(current_)) nearest = id;
    loadRecord(nearest);
  } else if (page_ != nullptr) {
    list_->setCurrent(currentPage());
    page_->sync();
  }
  design_->sync();
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

void DeckWindow::checkNow() {
  check_->stop();
  take_waiting_times(document_);  // the scale may have been found while something was typed
  document_.check_model();
  check_->stop();  // the change by this check needs no other check
  askForStart();
  askForScales();
}

void DeckWindow::askForStart() {
  if (document_.wants_rehearsal()) start_check_->ask(document_.candidate());
}

void DeckWindow::askForScales() {
  if (current_ != "2.1" && !has_waiting_times(document_)) return;
  if (const auto deck = deck_without_scales(document_)) scale_->ask(*deck, document_.options());
}

void DeckWindow::goBack() {
  if (designShown()) return;
  const std::vector<std::string> pages = document_.pages();
  const auto here = std::find(pages.begin(), pages.end(), current_);
  if (here == pages.begin() || here == pages.end())
    return desktop::show_message(this, tr("This is the first record."));
  showRecord(*std::prev(here));
}

void DeckWindow::nextRecord() {
  if (designShown()) return showRecord(document_.pages().front());
  document_.accept_defaults(current_);
  const std::vector<std::string> pages = document_.pages();
  const auto here = std::find(pages.begin(), pages.end(), current_);
  if (here == pages.end() || std::next(here) == pages.end())
    return desktop::show_message(
        this, tr("This is the last page. Save the deck with \"Save & Exit\" or in the menu File."));
  showRecord(*std::next(here));
}

void DeckWindow::undo() {
  design_->form().finish();
  showChanged(document_.undo());
}

void DeckWindow::redo() { showChanged(document_.redo()); }

/// The record of an undone change; the front page stays.
void DeckWindow::showChanged(const std::string& record) {
  if (record.empty()) return;
  const std::vector<std::string> pages = document_.pages();
  if (std::find(pages.begin(), pages.end(), record) != pages.end()) loadRecord(record);
  page_->sync(true);
}

void DeckWindow::switchTheme() {
  using desktop::ThemeKind;
  desktop::apply_theme(desktop::current_theme().kind == ThemeKind::Dark ? ThemeKind::Light
                                                                        : ThemeKind::Dark);
  desktop::remember_theme(desktop::current_theme().kind);
  for (auto* chart : findChildren<desktop::ChartView*>())
    chart->chartScene().setTheme(desktop::current_theme());
  const std::string record = std::exchange(current_, {});
  loadRecord(record);
  refresh();
  design_->restyle();
}

}  // namespace adore::adrinput
