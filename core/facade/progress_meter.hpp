#pragma once

#include "facade/run_span.hpp"

#include <chrono>
#include <functional>

/// Progress as a live display wants it: at most about 20 reports a second.
namespace adore::facade {

class ProgressMeter {
 public:
  /// @param start time that the run begins at [s]; @param turns of the shaft, now
  ProgressMeter(const ProgressSink& sink, double start, const RunSpan& span,
                std::function<double()> turns)
      : sink_(sink), start_(start), span_(span), turns_(std::move(turns)) {}

  void update(double time, long step, long first_step) {
    if (sink_ && elapsed() - sent_ >= 0.05) send(time, step, first_step, false);
  }
  /// The last report; `done`: the run came to its end.
  void finish(double time, long step, long first_step, bool done) {
    if (sink_) send(time, step, first_step, done);
  }

 private:
  [[nodiscard]] double elapsed() const;
  void send(double time, long step, long first_step, bool done);

  const ProgressSink& sink_;
  double start_;
  RunSpan span_;
  std::function<double()> turns_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double sent_ = -1.0;
};

/// Shows a table over speed as pieces of work. `sink` outlives what is returned.
[[nodiscard]] std::function<void(long, long)> table_meter(const ProgressSink& sink);

}  // namespace adore::facade
