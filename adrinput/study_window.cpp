#include "adrinput/study_window.hpp"

#include "adrinput/notice_bar.hpp"
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

const QString kApp = "adrinput-studies";  // separate list of recent files
constexpr int kStorePause = 500;          // [ms] from a change to its backup next to the file

QString from(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

StudyWindow::StudyWindow(QWidget* parent) : QMainWindow(parent) {
  setObjectName("study-window");
  desktop::open_at_size(*this, {1280, 800});
  desktop::take_files_anywhere(*this, [this](const QStringList& files) {
    leave([this, name = files.front()] { openFile(name.toStdString()); });
  });
  form_ = new StudyForm(document_, this);
  scroll_ = new QScrollArea(this);
  scroll_->setObjectName("study-form");
  scroll_->setAccessibleName(tr("Fields of the study"));
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setWidget(form_);
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
  tabs_->addTab(scroll_, tr("Form"));
  tabs_->addTab(text_, tr("File"));
  panel_ = new StudyPanel(document_, this);
  connect(panel_, &StudyPanel::planWanted, this, &StudyWindow::plan);
  connect(panel_, &StudyPanel::runWanted, this, &StudyWindow::run);
  connect(panel_, &StudyPanel::retryWanted, this,
          [this] { withSavedStudy([this] { panel_->startRun(true); }); });
  connect(panel_, &StudyPanel::overBudgetWanted, this,
          [this] { withSavedStudy([this] { panel_->startRun(false, true); }); });
  connect(panel_, &StudyPanel::checked, this, &StudyWindow::showFinding);
  connect(form_, &StudyForm::chooseDeck, this, &StudyWindow::askForDeck);
  auto* splitter = new QSplitter(this);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(tabs_);
  splitter->addWidget(panel_);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  splitter->setSizes({780, 500});
  notice_ = new NoticeBar("study-notice", this);
  auto* centre = new QWidget(this);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(notice_);
  column->addWidget(splitter, 1);
  setCentralWidget(centre);
  makeMenus();
  new desktop::MenuKeys(*this);
  store_ = new QTimer(this);
  store_->setSingleShot(true);
  store_->setInterval(kStorePause);
  connect(store_, &QTimer::timeout, this, [this] {
    try {
      document_.store_unsaved();
    } catch (const std::exception& error) {
      statusBar()->showMessage(tr("Crash recovery is not available: %1").arg(error.what()));
    }
  });
  document_.changed = [this] {
    sync();
    if (document_.comments_went())
      statusBar()->showMessage(
          tr("This change removed the comments after values and in lists. Undo restores them. To "
             "keep comments, edit the text in the tab File."));
    panel_->changed();
    if (!store_->isActive()) store_->start();
  };
  sync();
}

StudyWindow::~StudyWindow() {
  document_.changed = nullptr;
  delete centralWidget();  // its fields speak to the document when they lose the focus
}

void StudyWindow::addKinds(QMenu& menu, const std::function<void(const QString&)>& chosen) {
  constexpr std::array<const char*, studies::kKinds> kWhat{
      "grids, lists and samples",
      "effect of part tolerances (Monte Carlo)",
      "regions where the cage rests, whirls or moves irregularly",
      "derivatives of all quantities with respect to all variables",
      "worst case within given ranges",
      "named changes of the deck, compared one at a time"};
  for (int k = 0; k < studies::kKinds; ++k) {
    const QString kind = from(studies::kind_name(static_cast<studies::Kind>(k)));
    QAction* action =
        menu.addAction(QString("%1 — %2").arg(kind, kWhat[static_cast<std::size_t>(k)]));
    action->setData(kind);
    QObject::connect(action, &QAction::triggered, &menu, [chosen, kind] { chosen(kind); });
  }
}

void StudyWindow::makeMenus() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  QMenu* fresh = file->addMenu(tr("&New study"));
  addKinds(*fresh, [this](const QString& kind) {
    leave([this, kind] {
      const fs::path beside = document_.path().parent_path();
      std::string deck;
      if (document_.values() && document_.values()->contains("deck"))
        deck = shown_value(document_.values()->at("deck"));
      newStudy(beside / (kind.toStdString() + ".json"), kind,
               deck.empty() ? fs::path() : beside / deck);
    });
  });
  file->addAction(tr("&Open study …"), QKeySequence::Open, this, &StudyWindow::askForFile);
  desktop::add_recent_menu(*file, kApp, [this](const QString& name) {
    leave([this, name] { openFile(name.toStdString()); });
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
    if (!form_->goTo(panel_->finding().key)) tabs_->setCurrentIndex(1);
  });
  QMenu* study = menuBar()->addMenu(tr("&Study"));
  study->addAction(tr("&Plan"), QKeySequence(Qt::Key_F5), this, &StudyWindow::plan);
  study->addAction(tr("&Run or resume"), QKeySequence(Qt::Key_F7), this, &StudyWindow::run);
  study->addAction(tr("&Cancel"), panel_, &StudyPanel::cancel);
  study->addAction(tr("R&esults in AdrPlot"), panel_, &StudyPanel::openResults);
  QMenu* view = menuBar()->addMenu(tr("&View"));
  view->addAction(tr("&Dark or light"), QKeySequence(Qt::CTRL | Qt::Key_D), this,
                  &StudyWindow::switchTheme);
}

void StudyWindow::sync() {
  syncing_ = true;
  form_->sync();
  const QString text = from(document_.text());
  if (text_->toPlainText() != text) text_->setPlainText(text);
  undo_->setEnabled(document_.can_undo());
  redo_->setEnabled(document_.can_redo());
  const QString name = from(document_.path().filename().string());
  setWindowTitle((name.isEmpty() ? tr("study") : name) + "[*] — AdrInput");
  setWindowModified(document_.modified());
  syncing_ = false;
}

void StudyWindow::showFinding() {
  const StudyDocument::Finding& found = panel_->finding();
  form_->showProblem(found.key, from(found.problem));
}

void StudyWindow::showText(bool text) { tabs_->setCurrentIndex(text ? 1 : 0); }

bool StudyWindow::openFile(const fs::path& path) {
  try {
    document_.open(fs::absolute(path));
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
  desktop::remember_file(kApp, from(document_.path().string()));
  panel_->checkNow();
  panel_->showStatus();
  showText(!document_.values());
  offerUnsaved();
  return true;
}

void StudyWindow::offerUnsaved() {
  notice_->hide();
  const std::optional<std::string> left = document_.unsaved_text();
  if (!left) return;
  notice_->ask(tr("AdrInput ended before this study was saved. The changes can be restored."),
               {{"restore", tr("Res&tore"), [this, left] { document_.set_text(*left); }},
                {"discard", tr("&Discard"), [this] { document_.forget_unsaved(); }}});
}

void StudyWindow::newStudy(const fs::path& file, const QString& kind, const fs::path& deck) {
  fs::path name = fs::absolute(file);
  std::error_code error;  // never replaces another study
  for (int number = 2; fs::exists(name, error); ++number)
    name.replace_filename(file.stem().string() + "-" + std::to_string(number) +
                          file.extension().string());
  notice_->hide();
  document_.start_new(name, kind.toStdString(), deck);
  panel_->checkNow();
  panel_->showStatus();
  showText(false);
}

void StudyWindow::askForFile() {
  leave([this] {
    auto* dialog = new QFileDialog(this, tr("Open study"), from(document_.path().parent_path()),
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
  auto* dialog = new QFileDialog(this, tr("Base deck"), from(document_.path().parent_path()),
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
    store_->stop();
    desktop::remember_file(kApp, from(path.string()));
    statusBar()->showMessage(tr("Saved %1").arg(from(path.string())), 5000);
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
  auto* dialog = new QFileDialog(this, tr("Save study"), from(document_.path().parent_path()),
                                 tr("Studies (*.json *.toml);;All files (*)"));
  dialog->setObjectName("save");
  desktop::delete_when_done(*dialog);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("json");
  dialog->selectFile(from(document_.path().filename().string()));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& name) {
    saveTo(name.toStdString(), [this] {
      panel_->checkNow();
      panel_->showStatus();
    });
  });
  dialog->open();
}

void StudyWindow::withSavedStudy(std::function<void()> then) {
  if (panel_->busy()) return;
  panel_->checkNow();
  if (!panel_->finding().problem.empty())
    return desktop::show_message(this,
                                 tr("The study has an error. Press F8 to go to the field.\n\n%1")
                                     .arg(from(panel_->finding().problem)),
                                 true);
  if (document_.modified()) return saveTo(document_.path(), std::move(then));
  then();
}

void StudyWindow::plan() {
  withSavedStudy([this] { panel_->startPlan(); });
}

void StudyWindow::run() {
  withSavedStudy([this] { panel_->startRun(); });
}

void StudyWindow::switchTheme() {
  using desktop::ThemeKind;
  desktop::apply_theme(desktop::current_theme().kind == ThemeKind::Dark ? ThemeKind::Light
                                                                        : ThemeKind::Dark);
  desktop::remember_theme(desktop::current_theme().kind);
  panel_->checkNow();
}

void StudyWindow::leave(std::function<void()> then) {
  if (panel_->busy()) {
    auto* box =
        new QMessageBox(QMessageBox::Warning, "AdrInput",
                        tr("The study is running. Closing the window stops the active runs. "
                           "Finished runs are kept. \"Resume\" makes the remaining runs."),
                        QMessageBox::Cancel, this);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setObjectName("running");
    desktop::delete_when_done(*box);
    QPushButton* quit = box->addButton(tr("Stop the runs"), QMessageBox::DestructiveRole);
    connect(box, &QMessageBox::buttonClicked, this, [this, quit, then](QAbstractButton* button) {
      if (button != quit) return;
      // The next action waits for the workers.
      connect(
          panel_, &StudyPanel::finished, this, [this, then] { leave(then); },
          Qt::SingleShotConnection);
      panel_->cancel();
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
      store_->stop();
      document_.forget_unsaved();
      then();
    }
    if (answer == QMessageBox::Save) saveTo(document_.path(), then);
  });
  box->open();
}

void StudyWindow::closeEvent(QCloseEvent* event) {
  if (std::exchange(leaving_, false) ||
      (!panel_->busy() && (!document_.modified() || document_.path().empty())))
    return event->accept();
  event->ignore();
  leave([this] {
    leaving_ = true;
    close();
  });
}

}  // namespace adore::adrinput
