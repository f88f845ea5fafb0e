#pragma once

#include "facade/prepare.hpp"
#include "facade/run.hpp"
#include "integrators/stepper.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// All files of one run: which step goes where, restart, checkpoints, and the closing ledgers.
namespace adore::facade {

/// One instant of the run.
struct RunPoint {
  long step = 0;
  double time = 0.0, step_size = 0.0;  ///< [s]
  std::span<const double> y;
};

struct StartPoint {
  std::vector<double> y;
  double time = 0.0;
  long step = 0;
  double step_size = 0.0;  ///< last step of the run that is continued [s]; 0 for a new one
  bool continued = false;
  double turned_before = 0.0;  ///< shaft rotation beyond speed times time: of earlier speeds [rad]
};

struct RunEnd {
  RunStatus status = RunStatus::Done;
  std::string message;
  RunPoint point;
  integrators::Counters counters;
  long held_changes = 0;  ///< steps after which elements were held or released (qFac)
  double loop_seconds = 0.0;
};

class RunOutputs {
 public:
  RunOutputs(const Prepared& prepared, const std::filesystem::path& folder);
  ~RunOutputs();

  /// A quasi-static deck's only output: PRINT.txt and RUN.json. @return the results in a few lines
  std::vector<std::string> write_quasi_static();

  /// Finds the start state (statics, FINAL, or MASTER's run), opens every file, and writes the
  /// front part of PRINT.txt. Nothing of an earlier run is touched before everything has been
  /// checked.
  [[nodiscard]] StartPoint begin(dynamics::System& system, build::StartState start);
  /// Does any file store this step? (print, plot and animation intervals)
  [[nodiscard]] bool wants(long step) const;
  /// Stores a point in the files whose interval it meets; `always` in all of them (first and last
  /// step).
  void store(dynamics::System& system, const RunPoint& point, bool always);
  /// FINAL and MASTER of the start, so that none of an older run is left beside the new files.
  void write_first_checkpoint(dynamics::System& system);
  /// Writes FINAL and MASTER when the checkpoint interval of computing time has passed.
  void checkpoint_if_due(dynamics::System& system, const RunPoint& point);
  /// FINAL, MASTER, the ledgers of PRINT.txt, and RUN.json.
  void finish(dynamics::System& system, const RunEnd& end);

  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  [[nodiscard]] std::vector<std::pair<std::string, double>> summary() const;
  /// What turned up while the run started and ended: notes on the deck.
  [[nodiscard]] std::vector<Issue> remarks() const;
  [[nodiscard]] double energy_residual() const;  ///< [J]
  [[nodiscard]] double energy_scale() const;     ///< [J]

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace adore::facade
