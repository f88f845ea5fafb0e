#pragma once

#include <QDateTime>
#include <QObject>

#include <filesystem>

class QFileSystemWatcher;
class QTimer;

namespace adore::adrinput {

/// Notices that a file was written, replaced or removed. Programs that replace a file make a new
/// one, so its folder is watched too.
class FileWatch : public QObject {
  Q_OBJECT
 public:
  explicit FileWatch(QObject* parent = nullptr);
  /// Empty: nothing is watched.
  void setPath(const std::filesystem::path& file);

 signals:
  void fileModified();

 private:
  struct Stamp {
    bool there = false;
    qint64 size = 0;
    QDateTime time;
    bool operator==(const Stamp&) const = default;
  };
  [[nodiscard]] Stamp stamp() const;
  void checkForChange();

  QString file_;
  Stamp last_stamp_;
  QFileSystemWatcher* watcher_;
  QTimer* delay_timer_;
};

}  // namespace adore::adrinput
