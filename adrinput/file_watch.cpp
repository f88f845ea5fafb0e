#include "adrinput/file_watch.hpp"

#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QTimer>

namespace adore::adrinput {
namespace {

constexpr int kWritePause = 150;  // ms, for a program to finish writing

}  // namespace

FileWatch::FileWatch(QObject* parent)
    : QObject(parent), watcher_(new QFileSystemWatcher(this)), delay_timer_(new QTimer(this)) {
  delay_timer_->setSingleShot(true);
  delay_timer_->setInterval(kWritePause);
  connect(delay_timer_, &QTimer::timeout, this, &FileWatch::checkForChange);
  connect(watcher_, &QFileSystemWatcher::fileChanged, delay_timer_, qOverload<>(&QTimer::start));
  connect(watcher_, &QFileSystemWatcher::directoryChanged, delay_timer_,
          qOverload<>(&QTimer::start));
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
  delay_timer_->stop();
  const QStringList old = watcher_->files() + watcher_->directories();
  if (!old.isEmpty()) watcher_->removePaths(old);
  if (file_.isEmpty()) return;
  last_stamp_ = stamp();
  watcher_->addPath(QFileInfo(file_).absolutePath());
  if (last_stamp_.there) watcher_->addPath(file_);
}

void FileWatch::checkForChange() {
  const Stamp now = stamp();
  if (now.there && !watcher_->files().contains(file_)) watcher_->addPath(file_);
  if (now == last_stamp_) return;
  last_stamp_ = now;
  emit fileModified();
}

}  // namespace adore::adrinput
