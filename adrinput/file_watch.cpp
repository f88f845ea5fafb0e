#include "adrinput/file_watch.hpp"

#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QTimer>

namespace adore::adrinput {
namespace {

constexpr int kPause = 150;  // ms, for a program to finish writing

}  // namespace

FileWatch::FileWatch(QObject* parent)
    : QObject(parent), watcher_(new QFileSystemWatcher(this)), pause_(new QTimer(this)) {
  pause_->setSingleShot(true);
  pause_->setInterval(kPause);
  connect(pause_, &QTimer::timeout, this, &FileWatch::look);
  connect(watcher_, &QFileSystemWatcher::fileChanged, pause_, qOverload<>(&QTimer::start));
  connect(watcher_, &QFileSystemWatcher::directoryChanged, pause_, qOverload<>(&QTimer::start));
}

FileWatch::Stamp FileWatch::stamp() const {
  const QFileInfo info(file_);
  if (!info.exists()) return {};
  return {true, info.size(), info.lastModified()};
}

void FileWatch::setPath(const std::filesystem::path& file) {
  const QString name = file.empty()
                           ? QString()
                           : QFileInfo(QString::fromStdString(file.string())).absoluteFilePath();
  if (name == file_) return;
  file_ = name;
  pause_->stop();
  const QStringList old = watcher_->files() + watcher_->directories();
  if (!old.isEmpty()) watcher_->removePaths(old);
  if (file_.isEmpty()) return;
  seen_ = stamp();
  watcher_->addPath(QFileInfo(file_).absolutePath());
  if (seen_.there) watcher_->addPath(file_);
}

void FileWatch::look() {
  const Stamp now = stamp();
  if (now.there && !watcher_->files().contains(file_)) watcher_->addPath(file_);
  if (now == seen_) return;
  seen_ = now;
  emit touched();
}

}  // namespace adore::adrinput
