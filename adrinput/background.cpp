#include "adrinput/background.hpp"

#include "base/errors.hpp"

#include <QThread>

#include <utility>

namespace adore::adrinput {

BackgroundTask::~BackgroundTask() {
  stop();
  if (thread_ != nullptr) thread_->wait();
}

void BackgroundTask::report(std::function<void()> act) {
  QMetaObject::invokeMethod(this, std::move(act), Qt::QueuedConnection);
}

void BackgroundTask::start(std::function<void(std::stop_token)> work, std::function<void()> ended) {
  demand(!busy(), "a background task is already active");
  stop_source_ = {};
  thread_ =
      QThread::create([work = std::move(work), token = stop_source_.get_token()] { work(token); });
  thread_->setParent(this);
  connect(thread_, &QThread::finished, this, [this, ended = std::move(ended)] {
    std::exchange(thread_, nullptr)->deleteLater();
    ended();
  });
  thread_->start();
}

}  // namespace adore::adrinput
