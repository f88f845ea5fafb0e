#include "adrinput/deck_window.hpp"
#include "adrinput/help_text.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_list.hpp"
#include "adrinput/run_panel.hpp"
#include "base/version.hpp"
#include "deck/templates.hpp"
#include "desktop/dialogs.hpp"
#include "facade/prepare.hpp"

#include <QAction>
#include <QCloseEvent>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <exception>
#include <utility>

/// Menus, files and questions of the window.
namespace adore::adrinput {
namespace {

constexpr int kMostRecent = 10;

QSettings settings() { return QSettings("Adore", "adrinput"); }

}  // namespace

void DeckWindow::makeFileMenu() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  QMenu* fresh = file->addMenu(tr("&New"));
  fresh->setObjectName("new");
  int number = 0;
  for (const deck::TemplateInfo& info : deck::templates()) {
    constexpr int kTypes = 5;  // the types come first, then variants
    if (number++ == kTypes) fresh->addSeparator();
    const QString name = QString::fromStdString(std::string(info.name));
    QAction* action = fresh->addAction(
        QString("%1 — %2").arg(name, QString::fromStdString(std::string(info.description))));
    action->setData(name);
    connect(action, &QAction::triggered, this, [this, name] { newDeck(name); });
  }
  file->addAction(tr("&Open …"), QKeySequence::Open, this, &DeckWindow::askForFile);
  recent_ = file->addMenu(tr("&Recent"));
  recent_->setObjectName("recent");
  connect(recent_, &QMenu::aboutToShow, this, &DeckWindow::fillRecent);
  makeCompareMenu(file);
  file->addSeparator();
  file->addAction(tr("&Save"), QKeySequence::Save, this, &DeckWindow::save);
  file->addAction(tr("Save &As …"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), this,
                  &DeckWindow::saveAs);
  file->addAction(tr("Decks left &unsaved …"), this, &DeckWindow::unsavedWanted);
  file->addSeparator();
  file->addAction(tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), this, &DeckWindow::close);
}

void DeckWindow::makeOtherMenus() {
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  undo_ = edit->addAction(tr("&Undo"), QKeySequence::Undo, this, &DeckWindow::undo);
  redo_ = edit->addAction(tr("&Redo"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), this,
                          &DeckWindow::redo);
  edit->addSeparator();
  edit->addAction(tr("&Find variable"), QKeySequence::Find, this, [this] { list_->startSearch(); });

  QMenu* go = menuBar()->addMenu(tr("&Go"));
  QAction* back = go->addAction(tr("Go &Back"), this, &DeckWindow::goBack);
  back->setShortcuts({QKeySequence(Qt::Key_PageUp), QKeySequence(Qt::ALT | Qt::Key_Left)});
  QAction* next = go->addAction(tr("&Next Rec"), this, &DeckWindow::nextRecord);
  next->setShortcuts({QKeySequence(Qt::Key_PageDown), QKeySequence(Qt::ALT | Qt::Key_Right)});
  go->addSeparator();
  go->addAction(tr("Next &problem"), QKeySequence(Qt::Key_F8), this, &DeckWindow::nextProblem);
  go->addAction(tr("Previous pr&oblem"), QKeySequence(Qt::SHIFT | Qt::Key_F8), this,
                &DeckWindow::previousProblem);

  QMenu* view = menuBar()->addMenu(tr("&View"));
  view->addAction(tr("&Plan of this deck"), QKeySequence(Qt::Key_F5), this, &DeckWindow::showPlan);
  view->addAction(tr("&Quasi-static solution"), QKeySequence(Qt::Key_F6), this,
                  &DeckWindow::runQuasiStatic);
  view->addAction(tr("&Run"), QKeySequence(Qt::Key_F7), this, &DeckWindow::runDeck);
  QAction* drawing = drawing_dock_->toggleViewAction();
  drawing->setText(tr("Dra&wing"));
  drawing->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_G));
  view->addAction(drawing);
  QAction* lubricant = findChild<QDockWidget*>("lubricant-dock")->toggleViewAction();
  lubricant->setText(tr("&Lubricant"));
  view->addAction(lubricant);
  view->addAction(tr("&Dark or light"), QKeySequence(Qt::CTRL | Qt::Key_D), this,
                  &DeckWindow::switchTheme);
  view->addSeparator();
  makeUnitsMenu(view);

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  help->setObjectName("help");
  help->addAction(tr("This &record"), QKeySequence(Qt::Key_F1), this, [this] {
    const deck::RecordSpec& record = *page_record(current_);
    showHelp(page_heading(record), record_help(document_.deck(), record));
  });
  help->addAction(tr("How a &deck is written"), this,
                  [this] { showHelp(tr("How a deck is written"), format_help()); });
  help->addAction(tr("&Keyboard"), this, [this] { showHelp(tr("Keyboard"), keyboard_help()); });
  help->addAction(tr("&About AdrInput"), this, [this] {
    showHelp(
        tr("About AdrInput"),
        tr("<h2>AdrInput</h2><p>Prepares data decks for Adore, version %1.</p><p>Free software "
           "under the GNU General Public License, version 3 or later, without any "
           "warranty.</p>")
            .arg(QString::fromStdString(std::string(kVersionNumber))));
  });
}

void DeckWindow::showHelp(const QString& title, const QString& text) {
  auto* dialog = new QDialog(this);
  dialog->setObjectName("help-window");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  dialog->resize(680, 560);
  auto* browser = new QTextBrowser(dialog);
  browser->setHtml(text);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok, dialog);
  connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  auto* layout = new QVBoxLayout(dialog);
  layout->addWidget(browser, 1);
  layout->addWidget(buttons);
  dialog->open();
}

bool DeckWindow::openFile(const std::filesystem::path& path) {
  try {
    const std::filesystem::path file = facade::deck_path(path);
    document_.open(file);
    checkNow();
    remember(file);
    current_.clear();
    showRecord(document_.pages().front());
    return true;
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

void DeckWindow::newDeck(const QString& template_name) {
  leaveDeck([this, template_name] {
    document_.start_new(template_name.toStdString());
    checkNow();
    current_.clear();
    showRecord(document_.pages().front());
  });
}

void DeckWindow::askForFile() {
  leaveDeck([this] {
    auto* dialog = new QFileDialog(this, tr("Open deck"), settings().value("folder").toString(),
                                   tr("Decks (*.txt *.TXT *.dat *.DAT);;All files (*)"));
    dialog->setObjectName("open");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& name) { openFile(name.toStdString()); });
    dialog->open();
  });
}

void DeckWindow::remember(const std::filesystem::path& path) {
  const QString name = QFileInfo(QString::fromStdString(path.string())).absoluteFilePath();
  QSettings store = settings();
  QStringList names = store.value("recent").toStringList();
  names.removeAll(name);
  names.prepend(name);
  while (names.size() > kMostRecent) names.removeLast();
  store.setValue("recent", names);
  store.setValue("folder", QFileInfo(name).absolutePath());
}

void DeckWindow::fillRecent() {
  recent_->clear();
  const QStringList names = settings().value("recent").toStringList();
  for (const QString& name : names)
    recent_->addAction(name, this,
                       [this, name] { leaveDeck([this, name] { openFile(name.toStdString()); }); });
  if (names.isEmpty()) recent_->addAction(tr("No deck was opened yet"))->setEnabled(false);
}

/// Saves and goes on, unless the deck is refused or the user does not want it.
void DeckWindow::saveTo(const std::filesystem::path& path, std::function<void()> then) {
  if (!document_.changed_on_disk(path)) {
    if (writeTo(path) && then) then();
    return;
  }
  auto* box = new QMessageBox(QMessageBox::Warning, "AdrInput",
                              tr("Another program changed %1 since it was opened here. Saving "
                                 "replaces what it wrote.")
                                  .arg(QString::fromStdString(path.string())),
                              QMessageBox::Save | QMessageBox::Cancel, this);
  box->setObjectName("changed");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setDefaultButton(QMessageBox::Cancel);
  connect(box, &QMessageBox::buttonClicked, this, [this, box, path, then](QAbstractButton* button) {
    if (box->standardButton(button) == QMessageBox::Save && writeTo(path) && then) then();
  });
  box->open();
}

bool DeckWindow::writeTo(const std::filesystem::path& path) {
  try {
    document_.save(path);
    remember(path);
    statusBar()->showMessage(tr("Saved %1").arg(QString::fromStdString(path.string())), 5000);
    return true;
  } catch (const InputError& error) {
    QString text = tr("The deck was not saved.");
    for (const Issue& issue : error.issues()) text += "\n\n" + QString::fromStdString(issue.text());
    if (error.issues().empty()) text += "\n\n" + QString::fromUtf8(error.what());
    desktop::show_message(this, text, true);
  } catch (const std::exception& error) {
    desktop::show_message(
        this, tr("The deck was not saved.\n\n%1").arg(QString::fromUtf8(error.what())), true);
  }
  return false;
}

void DeckWindow::askForName(std::function<void()> then) {
  auto* dialog = new QFileDialog(this, tr("Save deck"), settings().value("folder").toString(),
                                 tr("Decks (*.txt);;All files (*)"));
  dialog->setObjectName("save");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("txt");
  dialog->selectFile(document_.path().empty() ? QString("DATA.txt")
                                              : QString::fromStdString(document_.path().string()));
  connect(
      dialog, &QFileDialog::fileSelected, this,
      [this, then = std::move(then)](const QString& name) { saveTo(name.toStdString(), then); });
  dialog->open();
}

void DeckWindow::save() {
  if (document_.path().empty()) return askForName(nullptr);
  saveTo(document_.path());
}

void DeckWindow::saveAs() { askForName(nullptr); }

void DeckWindow::saveAndExit() {
  if (document_.path().empty()) return askForName([this] { close(); });
  saveTo(document_.path(), [this] { close(); });
}

void DeckWindow::leaveDeck(std::function<void()> then) {
  if (!document_.modified()) return then();
  auto* box = new QMessageBox(QMessageBox::Warning, "AdrInput",
                              tr("The deck has changes that are not saved; they will be lost."),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box->setObjectName("unsaved");
  box->setAttribute(Qt::WA_DeleteOnClose);
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

void DeckWindow::leaveRun(std::function<void()> then) {
  if (!run_->busy()) return then();
  auto* box = new QMessageBox(QMessageBox::Warning, "AdrInput",
                              tr("A run is going on. Quitting ends it; its files are valid up to "
                                 "the last stored step."),
                              QMessageBox::Cancel, this);
  box->setObjectName("running");
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* quit = box->addButton(tr("End the run"), QMessageBox::DestructiveRole);
  connect(box, &QMessageBox::buttonClicked, this, [quit, then](QAbstractButton* button) {
    if (button == quit) then();
  });
  box->open();
}

void DeckWindow::closeEvent(QCloseEvent* event) {
  if (std::exchange(leaving_, false) || (!document_.modified() && !run_->busy())) {
    run_->cancel();
    return event->accept();
  }
  event->ignore();
  leaveRun([this] {
    leaveDeck([this] {
      leaving_ = true;
      close();
    });
  });
}

void DeckWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void DeckWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.isEmpty()) return;
  event->acceptProposedAction();
  const QString name = urls.front().toLocalFile();
  leaveDeck([this, name] { openFile(name.toStdString()); });
}

}  // namespace adore::adrinput
