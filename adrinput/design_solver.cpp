#include "adrinput/design_solver.hpp"

#include "adrinput/window_words.hpp"

#include <QTimer>

#include <exception>
#include <memory>
#include <utility>

namespace adore::adrinput {
namespace {

constexpr int kPause = 120;  // ms without a change

}  // namespace

DesignSolver::DesignSolver(QObject* parent) : QObject(parent), pause_(new QTimer(this)) {
  pause_->setSingleShot(true);
  pause_->setInterval(kPause);
  connect(pause_, &QTimer::timeout, this, &DesignSolver::start);
}

void DesignSolver::ask(Request request) {
  if (wanted_ ? *wanted_ == request : running_ ? *running_ == request : done_ && *done_ == request)
    return;
  wanted_ = std::move(request);
  running_.reset();
  background_.stop();
  pause_->start();
}

void DesignSolver::cancel() {
  pause_->stop();
  wanted_.reset();
  running_.reset();
  done_.reset();
  background_.stop();
}

bool DesignSolver::pending() const { return wanted_ || running_; }

void DesignSolver::start() {
  if (!wanted_ || background_.busy()) return;  // the end of the canceled one starts it
  running_ = std::exchange(wanted_, std::nullopt);
  struct Answer {
    std::optional<design::DesignSummary> summary;
    QString failure;
  };
  auto answer = std::make_shared<Answer>();
  background_.start(
      [request = *running_, answer](const std::stop_token& stop) {
        try {
          answer->summary = design::design_summary(request.deck, request.options, stop);
          for (Finding& one : answer->summary->findings) {
            one.message = in_window_words(std::move(one.message));
            one.remedy = in_window_words(std::move(one.remedy));
          }
        } catch (const std::exception& error) {
          answer->failure = QString::fromStdString(in_window_words(error.what()));
        }
      },
      [this, answer] {
        const bool current = running_.has_value();
        if (current) done_ = std::exchange(running_, std::nullopt);
        if (wanted_ && !pause_->isActive()) start();
        if (current && found) found(std::move(answer->summary), answer->failure);
      });
}

}  // namespace adore::adrinput
