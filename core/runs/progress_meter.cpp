#include "runs/progress_meter.hpp"

#include <algorithm>
#include <utility>

namespace adore::runs {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

double ProgressMeter::elapsed() const { return seconds_since(start_clock_); }

/// A run that began as the continuation of another one (kIcOpt = 1) does not know when that was:
/// its own part counts from here.
ProgressMeter::ProgressMeter(const ProgressSink& sink, const StartPoint& start, bool completes,
                             const RunSpan& span, std::function<double()> turns)
    : sink_(sink),
      span_(span),
      start_simulated_time_(start.time),
      start_step_(start.step),
      fraction_start_time_(completes && start.segment == 0 ? 0.0 : start.time),
      first_step_(completes ? start.segment : start.step),
      fraction_before_(fraction(start.time, start.step)),
      turns_(std::move(turns)) {}

double ProgressMeter::fraction_by_time(double time) const {
  return span_.end > fraction_start_time_
             ? (time - fraction_start_time_) / (span_.end - fraction_start_time_)
             : 1.0;
}

double ProgressMeter::fraction_by_steps(long step) const {
  return static_cast<double>(step - first_step_) /
         static_cast<double>(std::max(1L, span_.max_steps));
}

/// Remaining part of both, at the pace since this program began.
bool ProgressMeter::ends_by_steps(double time, long step) const {
  const double last = static_cast<double>(first_step_) + static_cast<double>(span_.max_steps);
  return (last - static_cast<double>(step)) * (time - start_simulated_time_) <
         (span_.end - time) * static_cast<double>(step - start_step_);
}

double ProgressMeter::fraction(double time, long step) const {
  return std::clamp(std::max(fraction_by_time(time), fraction_by_steps(step)), 0.0, 0.9999);
}

void ProgressMeter::send(double time, long step, bool done) {
  const double elapsed = this->elapsed();
  last_sent_seconds_ = elapsed;
  Progress p;
  p.fraction = done ? 1.0 : fraction(time, step);
  p.revolutions = turns_();
  p.time = time;
  p.end_time = span_.end;
  p.step = step;
  if (ends_by_steps(time, step)) p.last_step = first_step_ + span_.max_steps;
  p.elapsed = elapsed;
  const double here = p.fraction - fraction_before_;
  p.remaining = here > 0.0 ? elapsed * (1.0 - p.fraction) / here : 0.0;
  p.speed_up = elapsed > 0.0 ? (time - start_simulated_time_) / elapsed : 0.0;
  sink_(p);
}

std::function<void(long, long)> table_meter(const ProgressSink& sink) {
  return [&sink, begin = Clock::now(), sent = -1.0](long done, long total) mutable {
    Progress p;
    p.elapsed = seconds_since(begin);
    if (p.elapsed - sent < 0.05 && done < total) return;
    sent = p.elapsed;
    p.fraction = static_cast<double>(done) / static_cast<double>(total);
    p.step = done;
    p.runs = total;
    p.piece = "speed";
    p.remaining = p.elapsed * (1.0 - p.fraction) / p.fraction;
    sink(p);
  };
}

}  // namespace adore::runs
