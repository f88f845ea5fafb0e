#include "adrinput/background.hpp"

#include "base/errors.hpp"

#include <QThread>

#include <utility>

namespace adore::adrinput {

Background::~Background() {
  stop();
  if (thread_ != nullptr) thread_->wait();
}

void Background::report(std::function<void()> act) {
  QMetaObject::invokeMethod(this, std::move(act), Qt::QueuedConnection);
}

void Background::start(std::function<void(std::stop_token)> work, std::function<void()> ended) {
  demand(!busy(), "a background task is already active");
  stop_ = {};
  thread_ = QThread::create([work = std::move(work), token = stop_.get_token()] { work(token); });
  thread_->setParent(this);
  connect(thread_, &QThread::finished, this, [this, ended = std::move(ended)] {
    std::exchange(thread_, nullptr)->deleteLater();
    ended();
  });
  thread_->start();
}

}  // namespace adore::adrinput
