#include "adrinput/time_scale.hpp"

#include <QThread>

#include <exception>
#include <memory>
#include <utility>

namespace adore::adrinput {

TimeScale::~TimeScale() {
  if (thread_ != nullptr) thread_->wait();
}

void TimeScale::ask(const deck::Deck& deck, const RunOptionValues& options) {
  if (busy()) return;
  auto scales = std::make_shared<std::optional<facade::RunScales>>();
  thread_ = QThread::create([deck, options, scales] {
    try {
      *scales = facade::run_scales(deck, options);
    } catch (const std::exception&) {
      scales->reset();  // the checks say what is wrong with the deck
    }
  });
  thread_->setParent(this);
  connect(thread_, &QThread::finished, this, [this, deck, scales] {
    std::exchange(thread_, nullptr)->deleteLater();
    if (found) found(deck, *scales);
  });
  thread_->start();
}

}  // namespace adore::adrinput
