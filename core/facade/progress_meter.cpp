#include "facade/progress_meter.hpp"

#include <algorithm>

namespace adore::facade {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

double ProgressMeter::elapsed() const { return seconds_since(begin_); }

void ProgressMeter::send(double time, long step, long first_step, bool done) {
  const double elapsed = this->elapsed();
  sent_ = elapsed;
  Progress p;
  const double by_time = span_.end > start_ ? (time - start_) / (span_.end - start_) : 1.0;
  const double by_steps =
      static_cast<double>(step - first_step) / static_cast<double>(std::max(1L, span_.max_steps));
  p.fraction = done ? 1.0 : std::clamp(std::max(by_time, by_steps), 0.0, 0.9999);
  p.revolutions = turns_();
  p.time = time;
  p.end_time = span_.end;
  p.step = step;
  p.elapsed = elapsed;
  p.remaining = p.fraction > 0.0 ? elapsed * (1.0 - p.fraction) / p.fraction : 0.0;
  p.speed_up = elapsed > 0.0 ? (time - start_) / elapsed : 0.0;
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

}  // namespace adore::facade
