#include "adrinput/design_solver.hpp"

#include "adrinput/window_words.hpp"

#include <QTimer>

#include <exception>
#include <memory>
#include <utility>

namespace adore::adrinput {
namespace {

constexpr int kSolverPause = 120;  // ms without a change

}  // namespace

DesignSolver::DesignSolver(QObject* parent) : QObject(parent), delay_timer_(new QTimer(this)) {
  delay_timer_->setSingleShot(true);
  delay_timer_->setInterval(kSolverPause);
  connect(delay_timer_, &QTimer::timeout, this, &DesignSolver::start);
}

void DesignSolver::ask(Request request) {
  if (pending_request_  ? *pending_request_ == request
      : active_request_ ? *active_request_ == request
                        : solved_request_ && *solved_request_ == request)
    return;
  pending_request_ = std::move(request);
  active_request_.reset();
  background_task_.stop();
  delay_timer_->start();
}

void DesignSolver::cancel() {
  delay_timer_->stop();
  pending_request_.reset();
  active_request_.reset();
  solved_request_.reset();
  background_task_.stop();
}

bool DesignSolver::pending() const { return pending_request_ || active_request_; }

void DesignSolver::start() {
  if (!pending_request_ || background_task_.busy())
    return;  // the end of the canceled one starts it
  active_request_ = std::exchange(pending_request_, std::nullopt);
  struct Answer {
    std::optional<design::DesignSummary> summary;
    QString failure;
  };
  auto answer = std::make_shared<Answer>();
  background_task_.start(
      [request = *active_request_, answer](const std::stop_token& stop) {
        try {
          answer->summary = design::design_summary(request.deck, request.options, stop);
          for (Finding& one : answer->summary->findings) {
            one.message = replace_cli_terms(std::move(one.message));
            one.remedy = replace_cli_terms(std::move(one.remedy));
          }
        } catch (const std::exception& error) {
          answer->failure = QString::fromStdString(replace_cli_terms(error.what()));
        }
      },
      [this, answer] {
        const bool current = active_request_.has_value();
        if (current) solved_request_ = std::exchange(active_request_, std::nullopt);
        if (pending_request_ && !delay_timer_->isActive()) start();
        if (current && found) found(std::move(answer->summary), answer->failure);
      });
}

}  // namespace adore::adrinput
