#pragma once

#include "adrinput/background.hpp"
#include "runs/run.hpp"
#include "studies/sweep.hpp"

#include <QObject>

#include <functional>
#include <optional>
#include <string>

namespace adore::adrinput {

/// How a run ended: with an outcome, or before it had any with the reason.
struct RunEnd {
  std::optional<runs::RunOutcome> outcome;
  std::optional<studies::SweepOutcome> sweep;  ///< of a request with a range
  std::string reason;                          ///< input wrong, no start state
  bool results_exist =
      false;  ///< the reason: results of an earlier run, which may be allowed to go
};

/// One run of the solver in the background, as by `adore run`. Its reports arrive in the thread of
/// this object.
/// Its end stops an active run and waits for it; its files are valid.
class SolverRun : public QObject {
  Q_OBJECT
 public:
  explicit SolverRun(QObject* parent = nullptr) : QObject(parent) {}

  std::function<void(const runs::Progress&)> progressed;
  std::function<void(const RunEnd&)> ended;

  void start(runs::RunRequest request);
  /// Asks the run to end after the present step; `ended` follows.
  void stop() { background_task_.stop(); }
  [[nodiscard]] bool busy() const { return background_task_.busy(); }

 private:
  BackgroundTask background_task_;
};

}  // namespace adore::adrinput
