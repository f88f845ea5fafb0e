#include "adrinput/solver_run.hpp"

#include "base/errors.hpp"
#include "facade/output_folder.hpp"

#include <QThread>

#include <exception>
#include <memory>
#include <utility>

namespace adore::adrinput {

SolverRun::~SolverRun() {
  stop();
  if (thread_ != nullptr) thread_->wait();
}

void SolverRun::stop() { stop_.request_stop(); }

void SolverRun::start(facade::RunRequest request) {
  demand(!busy(), "one run at a time");
  stop_ = {};
  auto end = std::make_shared<RunEnd>();
  const auto report = [this](const facade::Progress& progress) {
    QMetaObject::invokeMethod(
        this,
        [this, progress] {
          if (progressed) progressed(progress);
        },
        Qt::QueuedConnection);
  };
  thread_ = QThread::create([request = std::move(request), report, token = stop_.get_token(), end] {
    try {
      if (facade::is_sweep(request))
        end->sweep = facade::run_sweep(request, 0, report, token);
      else
        end->outcome = facade::run(request, report, token);
    } catch (const facade::ResultsExist& found) {
      end->reason = found.what();
      end->results_exist = true;
    } catch (const std::exception& error) {
      end->reason = error.what();
    }
  });
  thread_->setParent(this);
  connect(thread_, &QThread::finished, this, [this, end] {
    std::exchange(thread_, nullptr)->deleteLater();
    if (ended) ended(*end);
  });
  thread_->start();
}

}  // namespace adore::adrinput
