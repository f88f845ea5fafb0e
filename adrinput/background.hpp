#pragma once

#include <QObject>

#include <functional>
#include <stop_token>

class QThread;

namespace adore::adrinput {

/// A task in a separate thread. Its reports and its end arrive in the thread of this object.
class BackgroundTask : public QObject {
  Q_OBJECT
 public:
  explicit BackgroundTask(QObject* parent = nullptr) : QObject(parent) {}
  /// Stops active work and waits for it.
  ~BackgroundTask() override;

  /// `work` in the other thread, then `ended` here.
  void start(std::function<void(std::stop_token)> work, std::function<void()> ended);
  /// From the other thread: does it here, if this still lives then.
  void report(std::function<void()> act);
  /// Asks the work to end; `ended` follows.
  void stop() { stop_source_.request_stop(); }
  [[nodiscard]] bool busy() const { return thread_ != nullptr; }

 private:
  QThread* thread_ = nullptr;
  std::stop_source stop_source_;
};

}  // namespace adore::adrinput
