#include "adrinput/study_window.hpp"

#include "adrinput/notice_bar.hpp"
#include "adrinput/qt_text.hpp"
#include "adrinput/replace_question.hpp"
#include "adrinput/study_form.hpp"
#include "adrinput/study_panel.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/file_drops.hpp"
#include "desktop/menu_keys.hpp"
#include "desktop/theme.hpp"
#include "desktop/window_place.hpp"

#include <QAction>
#include <QBoxLayout>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QTabWidget>
#include <QTimer>

#include <array>
#include <exception>
#include <utility>

namespace adore::adrinput {
namespace {

namespace fs = std::filesystem;

const QString kStudyApp = "adrinput-studies";  // separate list of recent files
constexpr int kStorePause = 500;               // [ms] from a change to its backup next to the file

}  // namespace

StudyWindow::StudyWindow(QWidget* parent) : QMainWindow(parent) {
  setObjectName("study-window");
  desktop::resize_to_fit_screen(*this, {1280, 800});
  desktop::accept_file_drops(*this, [this](const QStringList& files) {
    confirmLeave([this, name = files.front()] { openFile(name.toStdString()); });
  });
  form_ = new StudyForm(document_, this);
  scroll_area_ = new QScrollArea(this);
  scroll_area_->setObjectName("study-form");
  scroll_area_->setAccessibleName(tr("Fields of the study"));
  scroll_area_->setWidgetResizable(true);
  scroll_area_->setFrameShape(QFrame::NoFrame);
  scroll_area_->setWidget(form_);
  text_ = new QPlainTextEdit(this);
  text_->setObjectName("study-file");
  text_->setAccessibleName(tr("Text of the study file"));
  text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  text_->setUndoRedoEnabled(false);  // one history for form and text
  text_->setTabChangesFocus(true);
  connect(text_, &QPlainTextEdit::textChanged, this, [this] {
    if (!syncing_) document_.set_text(text_->toPlainText().toStdString());
  });
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("study-tabs");
  tabs_->setDocumentMode(true);
  tabs_->addTab(scroll_area_, tr("Form"));
  tabs_->addTab(text_, tr("File"));
  study_panel_ = new StudyPanel(document_, this);
  connect(study_panel_, &StudyPanel::planRequested, this, &StudyWindow::plan);
  connect(study_panel_, &StudyPanel::runRequested, this, &StudyWindow::run);
  connect(study_panel_, &StudyPanel::retryRequested, this,
          [this] { withSavedStudy([this] { study_panel_->startRun(true); }); });
  connect(study_panel_, &StudyPanel::overBudgetRunRequested, this,
          [this] { withSavedStudy([this] { study_panel_->startRun(false, true); }); });
  connect(study_panel_, &StudyPanel::checkFinished, this, &StudyWindow::showFinding);
  connect(form_, &StudyForm::deckChoiceRequested, this, &StudyWindow::askForDeck);
  auto* splitter = new QSplitter(this);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(tabs_);
  splitter->addWidget(study_panel_);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  splitter->setSizes({780, 500});
  notice_bar_ = new NoticeBar("study-notice", this);
  auto* centre = new QWidget(this);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(notice_bar_);
  column->addWidget(splitter, 1);
  setCentralWidget(centre);
  makeMenus();
  new desktop::MenuKeys(*this);
  store_timer_ = new QTimer(this);
  store_timer_->setSingleShot(true);
  store_timer_->setInterval(kStorePause);
  connect(store_timer_, &QTimer::timeout, this, [this] {
    try {
      document_.store_unsaved();
    } catch (const std::exception& error) {
      statusBar()->showMessage(tr("Crash recovery is not available: %1").arg(error.what()));
    }
  });
  document_.changed = [this] {
    sync();
    if (document_.comments_lost())
      statusBar()->showMessage(
          tr("This change removed the comments after values and in lists. Undo restores them. To "
             "keep comments, edit the text in the tab \"File\"."));
    study_panel_->changed();
    if (!store_timer_->isActive()) store_timer_->start();
  };
  sync();
}

StudyWindow::~StudyWindow() {
  document_.changed = nullptr;
  delete centralWidget();  // its fields speak to the document when they lose the focus
}

void StudyWindow::addKindActions(QMenu& menu, const std::function<void(const QString&)>& chosen) {
  constexpr std::array<const char*, studies::kKinds> kWhat{
      "Sweep — grids, lists and samples",
      "Part tolerances — effect on the results (Monte Carlo)",
      "Cage map — regions where the cage rests, whirls or moves irregularly",
      "Sensitivity — derivatives of all quantities with respect to all variables",
      "Worst case — within given ranges",
      "Comparison — named changes of the deck, one at a time (what-if)"};
  for (int k = 0; k < studies::kKinds; ++k) {
    const QString kind = text_of(studies::kind_name(static_cast<studies::Kind>(k)));
    QAction* action = menu.addAction(tr(kWhat[static_cast<std::size_t>(k)]));
    action->setData(kind);
    QObject::connect(action, &QAction::triggered, &menu, [chosen, kind] { chosen(kind); });
  }
}

void StudyWindow::makeMenus() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  QMenu* fresh = file->addMenu(tr("&New study"));
  addKindActions(*fresh, [this](const QString& kind) {
    confirmLeave([this, kind] {
      const fs::path beside = document_.path().parent_path();
      std::string deck;
      if (document_.values() && document_.values()->contains("deck"))
        deck = shown_value(document_.values()->at("deck"));
      newStudy(beside / (kind.toStdString() + ".json"), kind,
               deck.empty() ? fs::path() : beside / deck);
    });
  });
  file->addAction(tr("&Open study …"), QKeySequence::Open, this, &StudyWindow::askForFile);
  desktop::add_recent_menu(*file, kStudyApp, [this](const QString& name) {
    confirmLeave([this, name] { openFile(name.toStdString()); });
  });
  file->addSeparator();
  file->addAction(tr("&Save"), QKeySequence::Save, this, &StudyWindow::save);
  file->addAction(tr("Save &As …"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), this,
                  &StudyWindow::saveAs);
  file->addSeparator();
  file->addAction(tr("&Close"), QKeySequence(Qt::CTRL | Qt::Key_W), this, &StudyWindow::close);
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  undo_ = edit->addAction(tr("&Undo"), QKeySequence::Undo, this, [this] { document_.undo(); });
  redo_ = edit->addAction(tr("&Redo"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), this,
                          [this] { document_.redo(); });
  edit->addAction(tr("Go to the &problem"), QKeySequence(Qt::Key_F8), this, [this] {
    tabs_->setCurrentIndex(0);
    if (!form_->goTo(study_panel_->finding().key)) tabs_->setCurrentIndex(1);
  });
  QMenu* study = menuBar()->addMenu(tr("&Study"));
  study->addAction(tr("&Plan"), QKeySequence(Qt::Key_F5), this, &StudyWindow::plan);
  study->addAction(tr("&Run or resume"), QKeySequence(Qt::Key_F7), this, &StudyWindow::run);
  study->addAction(tr("&Cancel"), study_panel_, &StudyPanel::cancel);
  study->addAction(tr("R&esults in AdrPlot"), study_panel_, &StudyPanel::openResults);
  QMenu* view = menuBar()->addMenu(tr("&View"));
  view->addAction(tr("&Dark or light"), QKeySequence(Qt::CTRL | Qt::Key_D), this,
                  &StudyWindow::switchTheme);
}

void StudyWindow::sync() {
  syncing_ = true;
  form_->sync();
  const QString text = text_of(document_.text());
  if (text_->toPlainText() != text) text_->setPlainText(text);
  undo_->setEnabled(document_.can_undo());
  redo_->setEnabled(document_.can_redo());
  const QString name = text_of(document_.path().filename().string());
  setWindowTitle((name.isEmpty() ? tr("study") : name) + "[*] — AdrInput");
  setWindowModified(document_.modified());
  syncing_ = false;
}

void StudyWindow::showFinding() {
  const StudyDocument::Finding& found = study_panel_->finding();
  form_->showProblem(found.key, text_of(found.problem));
}

void StudyWindow::showText(bool text) { tabs_->setCurrentIndex(text ? 1 : 0); }

bool StudyWindow::openFile(const fs::path& path) {
  try {
    document_.open(fs::absolute(path));
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
  desktop::remember_file(kStudyApp, text_of(document_.path().string()));
  study_panel_->checkNow();
  study_panel_->showStatus();
  showText(!document_.values());
  offerUnsaved();
  return true;
}

void StudyWindow::offerUnsaved() {
  notice_bar_->hide();
  const std::optional<std::string> left = document_.unsaved_text();
  if (!left) return;
  notice_bar_->ask(tr("AdrInput ended before this study was saved. The changes can be restored."),
                   {{"restore", tr("Res&tore"), [this, left] { document_.set_text(*left); }},
                    {"discard", tr("&Discard"), [this] { document_.delete_unsaved_copy(); }}});
}

void StudyWindow::newStudy(const fs::path& file, const QString& kind, const fs::path& deck) {
  fs::path name = fs::absolute(file);
  std::error_code error;  // never replaces another study
  for (int number = 2; fs::exists(name, error); ++number)
    name.replace_filename(file.stem().string() + "-" + std::to_string(number) +
                          file.extension().string());
  notice_bar_->hide();
  document_.start_new(name, kind.toStdString(), deck);
  study_panel_->checkNow();
  study_panel_->showStatus();
  showText(false);
}

void StudyWindow::askForFile() {
  confirmLeave([this] {
    auto* dialog =
        new QFileDialog(this, tr("Open study"), text_of(document_.path().parent_path().string()),
                        tr("Studies (*.json *.toml);;All files (*)"));
    dialog->setObjectName("open");
    desktop::delete_when_done(*dialog);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& name) { openFile(name.toStdString()); });
    dialog->open();
  });
}

void StudyWindow::askForDeck() {
  auto* dialog =
      new QFileDialog(this, tr("Base deck"), text_of(document_.path().parent_path().string()),
                      tr("Decks (*.txt *.TXT *.dat *.DAT);;All files (*)"));
  dialog->setObjectName("deck-dialog");
  desktop::delete_when_done(*dialog);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& name) {
    const fs::path deck =
        fs::proximate(name.toStdString(), fs::absolute(document_.path()).parent_path());
    document_.set_field(*find_study_field("deck"), deck.string());
  });
  dialog->open();
}

bool StudyWindow::writeTo(const fs::path& path) {
  try {
    document_.save(path);
    store_timer_->stop();
    desktop::remember_file(kStudyApp, text_of(path.string()));
    statusBar()->showMessage(tr("Saved %1").arg(text_of(path.string())), 5000);
    return true;
  } catch (const std::exception& error) {
    desktop::show_message(
        this, tr("The study was not saved.\n\n%1").arg(QString::fromUtf8(error.what())), true);
    return false;
  }
}

void StudyWindow::saveTo(const fs::path& path, std::function<void()> then) {
  if (path != document_.path() || !document_.changed_on_disk()) {
    if (writeTo(path) && then) then();
    return;
  }
  ask_to_replace(this, path, [this, path, then = std::move(then)] {
    if (writeTo(path) && then) then();
  });
}

void StudyWindow::save() { saveTo(document_.path(), nullptr); }

void StudyWindow::saveAs() {
  auto* dialog =
      new QFileDialog(this, tr("Save study"), text_of(document_.path().parent_path().string()),
                      tr("Studies (*.json *.toml);;All files (*)"));
  dialog->setObjectName("save");
  desktop::delete_when_done(*dialog);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("json");
  dialog->selectFile(text_of(document_.path().filename().string()));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& name) {
    saveTo(name.toStdString(), [this] {
      study_panel_->checkNow();
      study_panel_->showStatus();
    });
  });
  dialog->open();
}

void StudyWindow::withSavedStudy(std::function<void()> then) {
  if (study_panel_->busy()) return;
  study_panel_->checkNow();
  if (!study_panel_->finding().problem.empty())
    return desktop::show_message(
        this,
        tr("The study has an error. Press F8 to go to the field with the error.\n\n%1")
            .arg(text_of(study_panel_->finding().problem)),
        true);
  if (document_.modified()) return saveTo(document_.path(), std::move(then));
  then();
}

void StudyWindow::plan() {
  withSavedStudy([this] { study_panel_->startPlan(); });
}

void StudyWindow::run() {
  withSavedStudy([this] { study_panel_->startRun(); });
}

void StudyWindow::switchTheme() {
  using desktop::ThemeKind;
  desktop::apply_theme(desktop::current_theme().kind == ThemeKind::Dark ? ThemeKind::Light
                                                                        : ThemeKind::Dark);
  desktop::remember_theme(desktop::current_theme().kind);
  study_panel_->checkNow();
}

void StudyWindow::confirmLeave(std::function<void()> then) {
  if (study_panel_->busy()) {
    auto* box =
        new QMessageBox(QMessageBox::Warning, "AdrInput",
                        tr("The study is running. Closing the window stops the active runs. "
                           "Finished runs are kept. \"Resume\" starts the remaining runs."),
                        QMessageBox::Cancel, this);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setObjectName("running");
    desktop::delete_when_done(*box);
    QPushButton* quit = box->addButton(tr("Stop the runs"), QMessageBox::DestructiveRole);
    connect(box, &QMessageBox::buttonClicked, this, [this, quit, then](QAbstractButton* button) {
      if (button != quit) return;
      // The next action waits for the workers.
      connect(
          study_panel_, &StudyPanel::finished, this, [this, then] { confirmLeave(then); },
          Qt::SingleShotConnection);
      study_panel_->cancel();
    });
    return box->open();
  }
  if (!document_.modified() || document_.path().empty()) return then();
  auto* box = new QMessageBox(QMessageBox::Warning, "AdrInput",
                              tr("The study has unsaved changes. Save them?"),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box->setObjectName("unsaved");
  desktop::delete_when_done(*box);
  box->setDefaultButton(QMessageBox::Save);
  connect(box, &QMessageBox::buttonClicked, this, [this, box, then](QAbstractButton* button) {
    const QMessageBox::StandardButton answer = box->standardButton(button);
    if (answer == QMessageBox::Discard) {
      store_timer_->stop();
      document_.delete_unsaved_copy();
      then();
    }
    if (answer == QMessageBox::Save) saveTo(document_.path(), then);
  });
  box->open();
}

void StudyWindow::closeEvent(QCloseEvent* event) {
  if (std::exchange(close_confirmed_, false) ||
      (!study_panel_->busy() && (!document_.modified() || document_.path().empty())))
    return event->accept();
  event->ignore();
  confirmLeave([this] {
    close_confirmed_ = true;
    close();
  });
}

}  // namespace adore::adrinput
