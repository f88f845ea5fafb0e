#include "adrplot/folder_files.hpp"
#include "adrplot/plot_pages.hpp"
#include "adrplot/plot_window.hpp"
#include "adrplot/run_dialog.hpp"
#include "adrplot/session.hpp"
#include "adrplot/study_document.hpp"
#include "base/errors.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/window_place.hpp"

#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QProgressDialog>
#include <QScopedValueRollback>
#include <QStatusBar>
#include <QTimer>
#include <QTreeWidget>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <set>

/// Files of the window: read, listed in the tree, read again, closed.
namespace adore::adrplot {
namespace {

/// Changes whenever the file does, also into one of the same size.
std::string state_of(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  const auto time = std::filesystem::last_write_time(path, ignored);
  return fmt::format("{} {}", size, time.time_since_epoch().count());
}

/// Does the tree show the current state of the file?
bool names_hold(const PlotDocument& doc) {
  const results::SolFile now = results::read_sol(doc.path, {1, 1, 1});
  const std::vector<PageSpec> pages = plot_pages(now.kind, now.header);
  return subject(now.kind, now.header) == doc.subject &&
         std::equal(pages.begin(), pages.end(), doc.pages.begin(), doc.pages.end(),
                    [](const auto& a, const auto& b) { return a.title == b.title; });
}

}  // namespace

bool PlotWindow::showReadingProgress(double part) {
  if (part >= 1.0) {
    reading_progress_dialog_.reset();
    return true;
  }
  if (!reading_progress_dialog_) {
    reading_progress_dialog_ =
        std::make_unique<QProgressDialog>(tr("Reading ..."), tr("Stop"), 0, 1000, this);
    reading_progress_dialog_->setObjectName("reading");
    reading_progress_dialog_->setWindowTitle("AdrPlot");
    reading_progress_dialog_->setWindowModality(Qt::WindowModal);
    // A run that is followed is read again and again: its box would flicker.
    constexpr int kPatience = 400, kPatienceWhileFollowing = 3000;  // ms
    reading_progress_dialog_->setMinimumDuration(
        file_check_timer_->isActive() ? kPatienceWhileFollowing : kPatience);
    reading_progress_dialog_->setAutoClose(false);
    reading_progress_dialog_->setAutoReset(false);
  }
  reading_progress_dialog_->setValue(static_cast<int>(1000.0 * part));  // lets the window live
  if (!reading_progress_dialog_ || !reading_progress_dialog_->wasCanceled()) return true;
  reading_progress_dialog_.reset();
  return false;
}

bool PlotWindow::openFile(const std::filesystem::path& path, const results::SolRange& range) {
  if (path.filename() == desktop::kProjectFile) return openProject(path);
  if (is_session(path)) return openSession(QString::fromStdString(path.string()));
  try {
    addDocument(open_document(path, range, kMostValues,
                              [this](double part) { return showReadingProgress(part); }),
                range);
    desktop::add_recent_run_file(kApp, QString::fromStdString(path.string()));
    return true;
  } catch (const results::ReadStopped&) {
    return false;  // as specified
  } catch (const std::exception& error) {
    reading_progress_dialog_.reset();
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

void PlotWindow::addFile(results::SolFile file, const results::SolRange& range) {
  addDocument(make_document(std::move(file)), range);
}

void PlotWindow::addDocument(PlotDocument document, const results::SolRange& range, bool on_disk,
                             std::shared_ptr<UserChart> own) {
  std::string seen = on_disk ? state_of(document.path) : std::string();
  documents_.push_back(std::make_unique<Document>(
      Document{std::move(document), range, on_disk, std::move(seen), std::move(own)}));
  current_ = fileCount() - 1;
  page_ = 1;
  view_->zoomAll();                                 // a new file begins whole
  const QScopedValueRollback quiet(taking_, true);  // opened, not selected
  fillTree();
}

void PlotWindow::fillTree() {
  const int file = current_, page = page_;
  std::set<std::filesystem::path> folders;
  for (const auto& doc : documents_)
    if (doc->on_disk) folders.insert(run_folder(doc->path));
  {
    const QSignalBlocker quiet(tree_);
    tree_->clear();
    for (int d = 0; d < fileCount(); ++d) {
      const Document& doc = *documents_[static_cast<std::size_t>(d)];
      QString name = QString::fromStdString(doc.path.filename().string());
      if (folders.size() > 1 && doc.on_disk)  // runs told apart
        name = QString::fromStdString(run_folder(doc.path).filename().string()) + "/" + name;
      auto* root = new QTreeWidgetItem(tree_, {name + " — " + QString::fromStdString(doc.subject)});
      root->setToolTip(0, QString::fromStdString(doc.path.string()));
      // The name of a file shows its first page.
      root->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
      root->setData(0, kPageRole, doc.pages.empty() ? 0 : 1);
      root->setData(0, kFileRole, d);
      for (std::size_t p = 0; p < doc.pages.size(); ++p) {
        auto* item = new QTreeWidgetItem(
            root, {QString("%1  %2").arg(p + 1).arg(QString::fromStdString(doc.pages[p].title))});
        item->setData(0, kPageRole, static_cast<int>(p + 1));
        item->setData(0, kFileRole, d);
      }
      root->setExpanded(d == file);
    }
  }
  current_ = file;
  fillChannels();
  showPage(page);
  markPagesWithWarnings();
}

void PlotWindow::closeFile() {
  if (!document()) return;
  if (current_ == formulaDocumentIndex()) formulas_.clear();
  documents_.erase(documents_.begin() + current_);
  current_ = std::min(current_, fileCount() - 1);
  page_ = current_ >= 0 ? 1 : 0;
  if (current_ < 0) {
    const QSignalBlocker quiet(tree_);
    tree_->clear();
    fillChannels();
  } else {
    fillTree();
  }
  showCurrentPage();
}

void PlotWindow::openFolder(const QString& folder, const results::SolRange& range) {
  if (is_study(folder.toStdString())) {
    openFile(folder.toStdString(), range);
    return;
  }
  if (desktop::opens_as_project(folder.toStdString())) {
    openProject(folder.toStdString());
    return;
  }
  std::vector<std::filesystem::path> files;
  try {
    files = plot_files_of(folder.toStdString());
  } catch (const InputError& error) {
    return desktop::show_message(this, QString::fromUtf8(error.what()) + ".");
  }
  desktop::remember_as_folder(kApp, folder, [&] {
    for (const std::filesystem::path& file : files) openFile(file, range);
  });
}

void PlotWindow::openFiles(const QStringList& paths) {
  if (paths.size() == 1) {
    if (QFileInfo(paths.front()).isDir()) return openFolder(paths.front());
    return askForRange(paths.front());
  }
  for (const QString& path : paths) {
    if (QFileInfo(path).isDir())
      openFolder(path);
    else
      openFile(path.toStdString());
  }
}

void PlotWindow::showFiles(const QStringList& paths, bool to_front) {
  if (reading_progress_dialog_) {  // requested while another file is read: that one is finished
                                   // first
    constexpr int kLater = 300;    // ms
    QTimer::singleShot(kLater, this, [this, paths, to_front] { showFiles(paths, to_front); });
    return;
  }
  for (const QString& name : paths) {
    const std::filesystem::path path = name.toStdString();
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
      openFolder(name, {});
      continue;
    }
    const auto open = std::find_if(documents_.begin(), documents_.end(), [&](const auto& doc) {
      return doc->on_disk && std::filesystem::equivalent(doc->path, path, ignored);
    });
    if (open == documents_.end()) {
      openFile(path, {});
      continue;
    }
    current_ = static_cast<int>(open - documents_.begin());
    reload();
  }
  if (!to_front) return QApplication::alert(this);
  raise();
  activateWindow();
}

void PlotWindow::reload() {
  reloadCurrentFile(true);
  reloadReplacedFiles();
  reloadProject();
}

/// A followed file may be invalid for a moment: the status bar shows this, without a dialog, until
/// the file is valid again.
void PlotWindow::reloadCurrentFile(bool asked) {
  Document* doc = document();
  if (!doc || !doc->on_disk) return;
  doc->seen = state_of(doc->path);
  try {
    static_cast<PlotDocument&>(*doc) =
        open_document(doc->path, doc->range, kMostValues,
                      [this](double part) { return showReadingProgress(part); });
    page_ = std::min(page_, pageCount());
    fillTree();
    if (unreadable_) statusBar()->clearMessage();
    unreadable_ = false;
  } catch (const results::ReadStopped&) {
    follow(false);  // as specified
  } catch (const std::exception& error) {
    reading_progress_dialog_.reset();
    if (asked) return desktop::show_message(this, QString::fromUtf8(error.what()), true);
    unreadable_ = true;
    statusBar()->showMessage(tr("The file cannot be read at the moment: %1").arg(error.what()));
  }
}

void PlotWindow::reloadReplacedFiles() {
  bool any = false;
  for (int d = 0; d < fileCount(); ++d) {
    Document& doc = *documents_[static_cast<std::size_t>(d)];
    if (d == current_ || !doc.on_disk || doc.seen == state_of(doc.path)) continue;
    try {
      if (names_hold(doc)) continue;
      std::string seen = state_of(doc.path);
      static_cast<PlotDocument&>(doc) =
          open_document(doc.path, doc.range, kMostValues,
                        [this](double part) { return showReadingProgress(part); });
      doc.seen = std::move(seen);
      any = true;
    } catch (const std::exception&) {
      reading_progress_dialog_.reset();  // reported when the file is read
    }
  }
  if (any) fillTree();
}

void PlotWindow::follow(bool on) {
  if (follow_action_->isChecked() != on) follow_action_->setChecked(on);
  on ? file_check_timer_->start() : file_check_timer_->stop();
}

void PlotWindow::checkForFileChanges() {
  Document* doc = document();
  if (!doc || !doc->on_disk || reading_progress_dialog_) return;
  std::error_code error;
  if (std::filesystem::exists(doc->path, error) && doc->seen != state_of(doc->path))
    reloadCurrentFile(false);
  reloadReplacedFiles();
}

void PlotWindow::showRuns(const std::vector<long>& runs) {
  Document* doc = document();
  if (!doc || !doc->about_run) return;
  auto* dialog = new RunDialog(runs, doc->about_run, doc->files_of_run, this);
  connect(dialog, &RunDialog::filesRequested, this,
          [this](const QString& folder) { openFolder(folder); });
  dialog->show();
}

}  // namespace adore::adrplot
