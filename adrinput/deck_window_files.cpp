#include "adrinput/accuracy_panel.hpp"
#include "adrinput/calculator_dialog.hpp"
#include "adrinput/catalogue_dialog.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/file_names.hpp"
#include "adrinput/help_text.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_list.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/replace_question.hpp"
#include "adrinput/run_panel.hpp"
#include "adrinput/run_time_bar.hpp"
#include "adrinput/settings.hpp"
#include "adrinput/solution_charts.hpp"
#include "adrinput/study_menu.hpp"
#include "base/version.hpp"
#include "deck/catalogue.hpp"
#include "deck/templates.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/link_action.hpp"
#include "runs/prepare.hpp"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QToolBar>

#include <exception>
#include <memory>
#include <utility>

/// Menus, files and questions of the window.
namespace adore::adrinput {
namespace {

const QString kApp = "adrinput";

QString from(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

/// Shows and hides a dock; a covered dock is raised first.
QAction* dock_action(QDockWidget* dock, const QString& text) {
  QAction* action = dock->toggleViewAction();
  action->setText(text);
  auto in_front = std::make_shared<bool>(false);
  QObject::connect(dock, &QDockWidget::visibilityChanged, dock, [dock, in_front](bool visible) {
    if (!dock->isHidden()) *in_front = visible;
  });
  QObject::connect(action, &QAction::triggered, dock, [dock, in_front](bool on) {
    if (!on && *in_front) return;
    dock->show();
    dock->raise();
  });
  return action;
}

/// Wait cursor for decks of many megabytes.
class Waiting {
 public:
  Waiting() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
  ~Waiting() { QGuiApplication::restoreOverrideCursor(); }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;
};

}  // namespace

void DeckWindow::makeFileMenu() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  QMenu* fresh = file->addMenu(tr("&New"));
  fresh->setObjectName("new");
  int number = 0;
  for (const deck::TemplateInfo& info : deck::templates()) {
    constexpr int kTypes = 5;  // the types first, then variants
    if (number++ == kTypes) fresh->addSeparator();
    const QString name = QString::fromStdString(std::string(info.name));
    QAction* action = fresh->addAction(
        QString("%1 — %2").arg(name, QString::fromStdString(std::string(info.description))));
    action->setData(name);
    connect(action, &QAction::triggered, this, [this, name] { newDeck(name); });
  }
  fresh->addSeparator();
  fresh->addAction(tr("From the &catalog …"), QKeySequence::New, this,
                   &DeckWindow::newFromCatalogue);
  file->addAction(tr("&Open …"), QKeySequence::Open, this, &DeckWindow::askForFile);
  desktop::add_recent_menu(*file, kApp, [this](const QString& name) {
    resolveUnsavedChanges([this, name] { openFile(name.toStdString()); });
  });
  makeCompareMenu(file);
  file->addSeparator();
  file->addAction(tr("&Save"), QKeySequence::Save, this, &DeckWindow::save);
  file->addAction(tr("Save &As …"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), this,
                  &DeckWindow::saveAs);
  file->addAction(tr("Add to pro&ject …"), this, &DeckWindow::addToProject);
  file->addAction(tr("Open dec&k of a project …"), this, &DeckWindow::askForProject);
  file->addAction(tr("Save as &draft …"), this, &DeckWindow::saveDraft);
  file->addAction(tr("Recover &unsaved decks …"), this, &DeckWindow::recoveryRequested);
  file->addSeparator();
  file->addAction(tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), this, &DeckWindow::close);
}

void DeckWindow::makeOtherMenus() {
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  undo_ = edit->addAction(tr("&Undo"), QKeySequence::Undo, this, &DeckWindow::undo);
  redo_ = edit->addAction(tr("&Redo"), this, &DeckWindow::redo);
  redo_->setShortcuts(
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  edit->addSeparator();
  edit->addAction(tr("Estimate &internal geometry from bore, outside diameter and width"), this,
                  &DeckWindow::estimateInternalGeometry);
  edit->addAction(tr("&Find variable"), QKeySequence::Find, this, [this] { list_->startSearch(); });

  QMenu* go = menuBar()->addMenu(tr("&Go"));
  go->addAction(tr("&Design page"), QKeySequence(Qt::CTRL | Qt::Key_B), this,
                &DeckWindow::showDesign);
  QAction* back = go->addAction(tr("Go &Back"), this, &DeckWindow::goBack);
  back->setShortcuts({QKeySequence(Qt::Key_PageUp), QKeySequence(Qt::ALT | Qt::Key_Left)});
  QAction* next = go->addAction(tr("&Next Rec"), this, &DeckWindow::nextRecord);
  next->setShortcuts({QKeySequence(Qt::Key_PageDown), QKeySequence(Qt::ALT | Qt::Key_Right)});
  go->addSeparator();
  go->addAction(tr("Next &problem"), QKeySequence(Qt::Key_F8), this, &DeckWindow::nextProblem);
  go->addAction(tr("Previous pr&oblem"), QKeySequence(Qt::SHIFT | Qt::Key_F8), this,
                &DeckWindow::previousProblem);

  QMenu* run = menuBar()->addMenu(tr("&Run"));
  run->setObjectName("run-menu");
  run->addAction(tr("&Plan"), QKeySequence(Qt::Key_F5), this, &DeckWindow::showPlan);
  run->addAction(tr("&Quasi-static solution"), QKeySequence(Qt::Key_F6), this,
                 &DeckWindow::runQuasiStatic);
  run->addSeparator();
  run->addAction(tr("&Run"), QKeySequence(Qt::Key_F7), this, &DeckWindow::runDeck);
  run->addAction(tr("Run in a &new folder"), QKeySequence(Qt::SHIFT | Qt::Key_F7), this,
                 &DeckWindow::runInNewFolder);
  QAction* go_on = run->addAction(tr("&Continue the run"), this, &DeckWindow::continueRun);
  run->setToolTipsVisible(true);
  connect(run, &QMenu::aboutToShow, this,
          [this, go_on] { run_panel_->updateContinueAction(*go_on); });
  run->addSeparator();
  run->addAction(tr("S&weep a variable …"), this, &DeckWindow::askForSweep);
  run->addAction(tr("&Find the value of an input …"), this, &DeckWindow::openFindDialog);
  run->addAction(tr("Study &accuracy"), QKeySequence(Qt::Key_F9), this, &DeckWindow::studyAccuracy);
  run->addSeparator();
  run->addAction(tr("Ca&lculators …"), this, [this] { (new CalculatorDialog(this))->show(); })
      ->setObjectName("calculators");

  makeStudyMenu();

  QMenu* view = menuBar()->addMenu(tr("&View"));
  QAction* drawing = dock_action(drawing_dock_, tr("Drawin&g"));
  drawing->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_G));
  view->addAction(drawing);
  view->addAction(dock_action(findChild<QDockWidget*>("lubricant-dock"), tr("&Lubricant")));
  QAction* charts = dock_action(charts_dock_, tr("Charts of the &solution"));
  charts->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_T));
  // In a wide window the whole chart is visible.
  connect(charts, &QAction::triggered, this, [this] {
    const int wanted = solution_charts_->fullChartWidth();
    if (!charts_dock_->isHidden() && width() >= kNarrow && charts_dock_->width() < wanted)
      resizeDocks({charts_dock_}, {wanted}, Qt::Horizontal);
  });
  view->addAction(charts);
  view->addAction(tr("&Dark or light"), QKeySequence(Qt::CTRL | Qt::Key_D), this,
                  &DeckWindow::switchTheme);
  desktop::add_link_action(*view, run_panel_->timeBar().link(), "adrinput");
  view->addSeparator();
  makeUnitsMenu(view);
  makeUnitChoices(view);

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  help->setObjectName("help");
  help->addAction(tr("This &record"), QKeySequence(Qt::Key_F1), this, [this] {
    const deck::RecordSpec& record = *page_record(current_record_);
    desktop::show_help(this, page_heading(record), record_help(document_.deck(), record));
  });
  help->addAction(tr("&Deck format"), this,
                  [this] { desktop::show_help(this, tr("Deck format"), format_help()); });
  help->addAction(tr("&Keys and Mouse"), this,
                  [this] { desktop::show_help(this, tr("Keys and Mouse"), keyboard_help()); });
  help->addAction(tr("&About AdrInput"), this, [this] {
    desktop::show_help(
        this, tr("About AdrInput"),
        tr("<h2>AdrInput</h2><p>Editor for decks of Adore. Version %1.</p><p>Free software under "
           "the GNU General Public License, version 3 or later, without any warranty.</p>")
            .arg(QString::fromStdString(std::string(kVersionNumber))));
  });
}

/// Results of the previous deck do not belong to the new one.
/// `reread`: the same file, changed by another program.
void DeckWindow::invalidateResults(bool reread) {
  plan_panel_->invalidateResult();
  statics_panel_->invalidateResult();
  solution_charts_->invalidateResult();
  accuracy_panel_->invalidateResult(reread);
  run_panel_->setOpenedFile(document_.path());
}

bool DeckWindow::openFile(const std::filesystem::path& path) {
  const Waiting sign;
  try {
    // Paths relative to the start folder have no meaning in its dialogs.
    const std::filesystem::path file = normalized_path(runs::deck_path(path));
    const bool reread = file == document_.path();
    document_.open(file);
    invalidateResults(reread);
    checkNow();
    addRecentFile(file);
    current_record_.clear();
    buildRecordPage(document_.pages().front());
    return true;
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

void DeckWindow::newDeck(const QString& template_name) {
  resolveUnsavedChanges([this, template_name] {
    document_.start_new(template_name.toStdString());
    invalidateResults();
    checkNow();
    current_record_.clear();
    buildRecordPage(document_.pages().front());
  });
}

void DeckWindow::newFromCatalogue() {
  auto* dialog = new CatalogueDialog(this);
  connect(dialog, &CatalogueDialog::deckCreated, this, [this](const QString& text) {
    resolveUnsavedChanges([this, text] {
      document_.start_from_text(text.toStdString());
      invalidateResults();
      checkNow();
      current_record_.clear();
      buildRecordPage(document_.pages().front());
      if (!isDesignShown()) showPage("4");
    });
  });
  dialog->open();
}

void DeckWindow::estimateInternalGeometry() {
  document_.end_undo_step();
  try {
    const deck::Deck& deck = document_.deck();
    const deck::ProposedInternalGeometry inner = deck::propose_internal_geometry(deck);
    document_.change(inner.sets);
    record_page_->sync(true);
    desktop::show_message(this,
                          tr("The deck now contains estimated values. Undo with Ctrl+Z.\n\n%1.")
                              .arg(QString::fromStdString(inner.reasons)));
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
}

void DeckWindow::askForFile() {
  resolveUnsavedChanges([this] {
    auto* dialog =
        new QFileDialog(this, tr("Open deck"), settings().value("folder").toString(),
                        tr("Decks and drafts (*.txt *.TXT *.dat *.DAT *.draft);;All files (*)"));
    dialog->setObjectName("open");
    desktop::delete_when_done(*dialog);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& name) { openFile(name.toStdString()); });
    dialog->open();
  });
}

void DeckWindow::addRecentFile(const std::filesystem::path& path) {
  const QString name = QFileInfo(QString::fromStdString(path.string())).absoluteFilePath();
  desktop::remember_file(kApp, name);
  settings().setValue("folder", QFileInfo(name).absolutePath());
}

/// The same row of buttons as the other programs have.
void DeckWindow::makeToolBar() {
  QToolBar* bar = addToolBar(tr("Buttons"));
  bar->setObjectName("buttons");
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  const auto button = [&](const QString& text, const QString& help, auto slot) {
    QAction* action = bar->addAction(text, this, slot);
    action->setToolTip(help);
  };
  button(tr("Open Deck"), tr("Open a deck or a draft (Ctrl+O)"), &DeckWindow::askForFile);
  button(tr("Save"), tr("Save the deck (Ctrl+S)"), &DeckWindow::save);
  bar->addAction(undo_);
  bar->addAction(redo_);
  bar->addSeparator();
  button(tr("Plan"), tr("List the simulated effects, with reasons (F5)"), &DeckWindow::showPlan);
  button(tr("Quasi-static"), tr("Compute equilibrium, contacts and fatigue life (F6)"),
         &DeckWindow::runQuasiStatic);
  button(tr("Run"), tr("Save the deck and run it (F7)"), &DeckWindow::runDeck);
  button(tr("Accuracy"), tr("Compare integrators, tolerances and step sizes for this deck (F9)"),
         &DeckWindow::studyAccuracy);
  bar->addSeparator();
  button(tr("Dark/Light"), tr("Dark or light theme (Ctrl+D)"), &DeckWindow::switchTheme);
  button(tr("Quit"), tr("Quit AdrInput (Ctrl+Q)"), &DeckWindow::close);
}

/// Saves and continues, unless the deck has errors or the user cancels.
void DeckWindow::saveTo(const std::filesystem::path& path, std::function<void()> then) {
  if (!document_.changed_on_disk(path)) {
    if (writeTo(path) && then) then();
    return;
  }
  ask_to_replace(this, path, [this, path, then = std::move(then)] {
    if (writeTo(path) && then) then();
  });
}

bool DeckWindow::writeTo(const std::filesystem::path& path) {
  const Waiting sign;
  try {
    const std::filesystem::path draft = document_.draft();
    document_.save(path);
    addRecentFile(document_.path());
    QString said = tr("Saved %1").arg(QString::fromStdString(path.string()));
    if (!document_.kept_copy().empty())
      said += tr("; the previous file is kept as %1")
                  .arg(QString::fromStdString(document_.kept_copy().filename().string()));
    std::error_code unknown;
    if (!draft.empty() && document_.draft().empty() && !std::filesystem::exists(draft, unknown))
      said +=
          tr("; the draft %1 was deleted").arg(QString::fromStdString(draft.filename().string()));
    statusBar()->showMessage(said, 8000);
    return true;
  } catch (const InputError& error) {
    showSaveErrors(error.issues(), QString::fromUtf8(error.what()));
  } catch (const std::exception& error) {
    desktop::show_message(
        this, tr("The deck was not saved.\n\n%1").arg(QString::fromUtf8(error.what())), true);
  }
  return false;
}

/// The reasons, and the offer to park the deck.
void DeckWindow::showSaveErrors(const std::vector<Issue>& issues, const QString& otherwise) {
  QString text = tr("The deck was not saved.");
  for (const Issue& issue : issues) text += "\n\n" + QString::fromStdString(issue.text());
  if (issues.empty()) text += "\n\n" + otherwise;
  auto* box = new QMessageBox(QMessageBox::Warning, "AdrInput", text, QMessageBox::Ok, this);
  box->setObjectName("message");
  box->setTextFormat(Qt::PlainText);
  desktop::delete_when_done(*box);
  box->setEscapeButton(QMessageBox::Ok);  // of two buttons Qt would find none for Esc
  QPushButton* park = box->addButton(tr("Save as draft …"), QMessageBox::ActionRole);
  park->setObjectName("park-draft");
  connect(box, &QMessageBox::buttonClicked, this, [this, park](QAbstractButton* button) {
    if (button == park) saveDraft();
  });
  box->open();
}

void DeckWindow::askForName(std::function<void()> then) {
  // Another name does not remove errors.
  if (const std::vector<Issue> errors = document_.errors(); !errors.empty())
    return showSaveErrors(errors, {});
  auto* dialog = new QFileDialog(this, tr("Save deck"), settings().value("folder").toString(),
                                 tr("Decks (*.txt);;All files (*)"));
  dialog->setObjectName("save");
  desktop::delete_when_done(*dialog);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("txt");
  dialog->selectFile(document_.path().empty() ? QString("DATA.txt") : from(document_.path()));
  connect(
      dialog, &QFileDialog::fileSelected, this,
      [this, then = std::move(then)](const QString& name) { saveTo(name.toStdString(), then); });
  dialog->open();
}

void DeckWindow::saveDraft() {
  document_.end_undo_step();
  auto* dialog =
      new QFileDialog(this, tr("Save the deck as a draft"), settings().value("folder").toString(),
                      tr("Drafts of AdrInput (*.draft);;All files (*)"));
  dialog->setObjectName("save-draft");
  desktop::delete_when_done(*dialog);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("draft");
  std::filesystem::path name = document_.draft();
  if (name.empty())
    name = document_.path().empty()
               ? std::filesystem::path("DATA.draft")
               : std::filesystem::path(document_.path()).replace_extension("draft");
  dialog->selectFile(document_.path().empty() && document_.draft().empty()
                         ? QString::fromStdString(name.string())
                         : from(name));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    try {
      document_.save_draft(file.toStdString());
      statusBar()->showMessage(tr("Saved as draft %1. To run it, save it as a deck.").arg(file),
                               8000);
    } catch (const std::exception& error) {
      desktop::show_message(this, QString::fromUtf8(error.what()), true);
    }
  });
  dialog->open();
}

void DeckWindow::save() {
  document_.end_undo_step();
  if (document_.path().empty()) return askForName(nullptr);
  saveTo(document_.path());
}

void DeckWindow::saveAs() { askForName(nullptr); }

void DeckWindow::saveAndExit() {
  if (document_.path().empty()) return askForName([this] { close(); });
  saveTo(document_.path(), [this] { close(); });
}

void DeckWindow::resolveUnsavedChanges(std::function<void()> then) {
  document_.end_undo_step();
  if (!document_.modified()) return then();
  auto* box = new QMessageBox(
      QMessageBox::Warning, "AdrInput",
      tr("%1 has unsaved changes. Save them?")
          .arg(document_.path().empty() ? tr("The new deck")
                                        : QString::fromStdString(shortened_path(document_.path()))),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box->setObjectName("unsaved");
  desktop::delete_when_done(*box);
  box->setDefaultButton(QMessageBox::Save);
  connect(box, &QMessageBox::buttonClicked, this, [this, box, then](QAbstractButton* button) {
    const QMessageBox::StandardButton answer = box->standardButton(button);
    if (answer == QMessageBox::Discard) then();
    if (answer != QMessageBox::Save) return;
    if (document_.path().empty()) return askForName(then);
    saveTo(document_.path(), then);
  });
  box->open();
}

void DeckWindow::confirmStopRun(std::function<void()> then) {
  if (!run_panel_->busy()) return then();
  auto* box = new QMessageBox(QMessageBox::Warning, "AdrInput",
                              tr("A run is active. Quitting stops the run. The files are then "
                                 "valid up to the last stored step."),
                              QMessageBox::Cancel, this);
  box->setObjectName("running");
  desktop::delete_when_done(*box);
  box->setDefaultButton(QMessageBox::Cancel);
  QPushButton* quit = box->addButton(tr("Stop the run"), QMessageBox::DestructiveRole);
  connect(box, &QMessageBox::buttonClicked, this, [quit, then](QAbstractButton* button) {
    if (button == quit) then();
  });
  box->open();
}

void DeckWindow::closeEvent(QCloseEvent* event) {
  document_.end_undo_step();
  if (std::exchange(close_confirmed_, false) || (!document_.modified() && !run_panel_->busy())) {
    run_panel_->cancel();
    accuracy_panel_->cancel();
    return event->accept();
  }
  event->ignore();
  confirmStopRun([this] {
    resolveUnsavedChanges([this] {
      close_confirmed_ = true;
      close();
    });
  });
}

void DeckWindow::openDroppedFile(const QStringList& files) {
  const std::string name = files.front().toStdString();
  if (has_study_file_name(name)) return openStudyFile(name);
  resolveUnsavedChanges([this, name] { openFile(name); });
}

}  // namespace adore::adrinput
