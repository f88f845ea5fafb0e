#pragma once

#include "runs/run_span.hpp"

#include <chrono>
#include <functional>

/// Progress as a live display wants it: at most about 20 reports a second.
namespace adore::runs {

class ProgressMeter {
 public:
  /// @param start where this process takes the run over; @param completes a run that began before:
  /// its part counts as done; @param turns shaft revolutions so far
  ProgressMeter(const ProgressSink& sink, const StartPoint& start, bool completes,
                const RunSpan& span, std::function<double()> turns);

  void update(double time, long step) {
    if (sink_ && elapsed() - last_sent_seconds_ >= 0.05) send(time, step, false);
  }
  /// The last report; `done`: the run came to its end.
  void finish(double time, long step, bool done) {
    if (sink_) send(time, step, done);
  }

 private:
  [[nodiscard]] double elapsed() const;
  void send(double time, long step, bool done);
  /// How much of the whole run is done then, by its end in time and by its most steps.
  [[nodiscard]] double fraction_by_time(double time) const;
  [[nodiscard]] double fraction_by_steps(long step) const;
  /// Does the run end by its most steps, not by its time?
  [[nodiscard]] bool ends_by_steps(double time, long step) const;
  /// By what ends the run.
  [[nodiscard]] double fraction(double time, long step) const;

  const ProgressSink& sink_;
  RunSpan span_;
  double start_simulated_time_;  ///< of this process [s]
  long start_step_;              ///< the same
  double fraction_start_time_;   ///< of the run [s]
  long first_step_;              ///< of the run
  double fraction_before_;       ///< fraction at start_simulated_time_
  std::function<double()> turns_;
  std::chrono::steady_clock::time_point start_clock_ = std::chrono::steady_clock::now();
  double last_sent_seconds_ = -1.0;
};

/// Shows a table over speed as pieces of work. `sink` outlives what is returned.
[[nodiscard]] std::function<void(long, long)> table_meter(const ProgressSink& sink);

}  // namespace adore::runs
