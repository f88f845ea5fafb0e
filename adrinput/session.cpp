#include "adrinput/session.hpp"

#include "adrinput/deck_window.hpp"
#include "adrinput/file_names.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/settings.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/write_folder.hpp"
#include "desktop/dialogs.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTimer>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace adore::adrinput {
namespace {

namespace fs = std::filesystem;

constexpr int kStoragePause = 500;  // ms from a change to its storage
constexpr std::string_view kSuffix = ".unsaved";

fs::path lock_of(const fs::path& file) {
  fs::path lock = file;
  lock += ".lock";
  return lock;
}

std::string session_bytes(const fs::path& path) {
  InputFile file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// If it cannot be created, store() reports it.
void make_own_folder(const fs::path& folder) {
  try {
    (void)make_folders(folder);
  } catch (const InputError&) {
  }
}

void remove_both(const fs::path& file) {
  remove_file(file);
  remove_file(lock_of(file));
}

}  // namespace

QString Session::defaultFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/unsaved";
}

Session::Session(DeckWindow& window, const QString& folder)
    : QObject(&window),
      window_(window),
      folder_(folder.toStdString()),
      store_timer_(new QTimer(this)) {
  // Another program may clean up at the same time: a lock on a deleted file protects nothing.
  for (int number = 1; number < 1000 && !lock_; ++number) {
    make_own_folder(folder_);
    file_ = folder_ / fmt::format("{}-{}{}", QCoreApplication::applicationPid(), number, kSuffix);
    if (fs::exists(file_)) continue;  // of an earlier program, still to be answered
    lock_ = desktop::InstanceLock::take(lock_of(file_));
    if (lock_ && !fs::exists(lock_of(file_))) lock_.reset();
  }
  store_timer_->setSingleShot(true);
  store_timer_->setInterval(kStoragePause);
  connect(store_timer_, &QTimer::timeout, this, [this] {
    store();
    saveWindowState();
  });
  // Not restarted by the next change: who types without a pause is safe too.
  const auto soon = [this] {
    if (!store_timer_->isActive()) store_timer_->start();
  };
  connect(&window_, &DeckWindow::documentChanged, this, soon);
  connect(&window_, &DeckWindow::pageShown, this, soon);
  connect(&window_, &DeckWindow::recoveryRequested, this, &Session::offerUnsaved);
}

Session::~Session() {
  saveWindowState();
  if (window_.document().modified() && window_.isVisible()) {
    store();  // the user was not asked whether to save
  } else if (lock_) {
    remove_both(file_);
  }
}

void Session::store() {
  if (!window_.document().modified()) {
    if (lock_) remove_file(file_);
    return;
  }
  try {
    if (!lock_) throw InputError(fmt::format("cannot create a file in {}", folder_.string()));
    (void)make_folders(folder_);
    write_file_atomically(file_, window_.document().snapshot(window_.currentPage()));
    storing_failed_ = false;
  } catch (const std::exception& reason) {
    if (!storing_failed_)
      window_.statusBar()->showMessage(
          tr("Crash recovery is not available: %1").arg(QString::fromUtf8(reason.what())));
    storing_failed_ = true;
  }
}

void Session::saveWindowState() {
  QSettings store = settings();
  const fs::path& path = window_.document().path();
  store.setValue("session/geometry", window_.saveGeometry());
  store.setValue("session/docks", window_.dockState());
  store.setValue("session/deck", QString::fromStdString(path.string()));
  store.setValue("session/page", QString::fromStdString(window_.currentPage()));
}

void Session::begin(bool deck_named) {
  const QByteArray geometry = settings().value("session/geometry").toByteArray();
  if (!geometry.isEmpty()) window_.restoreGeometry(geometry);
  window_.restoreState(settings().value("session/docks").toByteArray());
  window_.hideEmptyPanels();
  window_.showDesign();
  if (!deck_named && settings().value("session/reopen", true).toBool()) reopenLastDeck();
  lookForOrphans();
  offerNextOrphan();
}

void Session::reopenLastDeck() {
  const QString deck = settings().value("session/deck").toString();
  const std::string page = settings().value("session/page").toString().toStdString();
  if (deck.isEmpty()) return;
  if (!QFileInfo::exists(deck)) {
    window_.statusBar()->showMessage(tr("The last deck, %1, does not exist.").arg(deck));
    return;
  }
  if (!window_.openFile(deck.toStdString())) return;
  window_.showPage(page);
}

/// Files of programs that have ended.
void Session::lookForOrphans() {
  orphans_.clear();
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    fs::path file = entry.path();
    if (file.extension() == kSuffix && file != file_) files.push_back(file);
    // The lock of a program that was cut off with nothing to lose.
    if (file.extension() == ".lock" && !fs::exists(file.replace_extension(), error) &&
        desktop::InstanceLock::take(entry.path()))
      remove_file(entry.path());
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return fs::last_write_time(a, ignored) > fs::last_write_time(b, ignored);
  });
  for (const fs::path& file : files) {
    std::optional<desktop::InstanceLock> lock = desktop::InstanceLock::take(lock_of(file));
    if (lock && fs::exists(file, error)) orphans_.push_back({file, std::move(*lock)});
  }
}

void Session::offerUnsaved() {
  lookForOrphans();
  if (!offerNextOrphan())
    desktop::show_message(&window_, tr("There are no unsaved decks from earlier sessions."));
}

bool Session::offerNextOrphan() {
  NoticeBar& bar = window_.sessionNotice();
  bar.hide();
  if (orphans_.empty()) return false;
  const fs::path file = orphans_.front().file;
  const QDateTime time = QFileInfo(QString::fromStdString(file.string())).lastModified();
  const QString when = QLocale::c().toString(time, "d MMM yyyy, HH:mm");
  const auto later = [this] {
    orphans_.erase(orphans_.begin());
    offerNextOrphan();
  };
  const auto discard = [this] {
    deleteOrphan(orphans_.front());
    orphans_.erase(orphans_.begin());
    offerNextOrphan();
  };
  try {
    Document left;
    left.restore(session_bytes(file));
    const QString name = left.path().empty() ? tr("an unnamed deck")
                                             : QString::fromStdString(shortened_path(left.path()));
    bar.setToolTip(QString::fromStdString(left.path().string()));
    bar.ask(tr("AdrInput ended before %1 was saved. The changes made until %2 can be restored.")
                .arg(name, when),
            {{"restore", tr("Res&tore"), [this] { restore(); }},
             {"later", tr("Later"), later},
             {"discard", tr("Discard"), discard}});
  } catch (const std::exception& reason) {
    bar.ask(tr("The unsaved deck from %1 cannot be restored: %2. The deck is in the file %3.")
                .arg(when, QString::fromUtf8(reason.what()), QString::fromStdString(file.string())),
            {{"later", tr("Keep"), later}, {"discard", tr("Discard"), discard}});
  }
  return true;
}

/// The old file is deleted only after its content is stored under the name of this program.
void Session::restore() {
  window_.restoreDeck(session_bytes(orphans_.front().file), [this] {
    store();
    std::error_code error;
    if (!storing_failed_ && (fs::exists(file_, error) || !window_.document().modified()))
      deleteOrphan(orphans_.front());
    orphans_.erase(orphans_.begin());
    offerNextOrphan();
  });
}

void Session::deleteOrphan(const Orphan& orphan) { remove_both(orphan.file); }

}  // namespace adore::adrinput
