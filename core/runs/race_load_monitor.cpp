#include "runs/race_load_monitor.hpp"

#include "base/errors.hpp"
#include "results/mean_load.hpp"

#include <fmt/format.h>

namespace adore::runs {

void RaceLoadMonitor::begin(double t) noexcept {
  window_open_ = true;
  window_start_ = last_time_ = t;
  difference_integral_ = specified_load_integral_ = 0.0;
  window_steps_ = 0;
}

void RaceLoadMonitor::check(double t, const dynamics::RaceLoad& load, double contact) {
  const double asked = std::max(load.asked.norm(), results::kLoadFloor * contact);
  if (!(load.asked.norm() > 0.0)) {
    window_open_ = false;  // a window is of one time without a gap
    return;
  }
  if (!window_open_) return begin(t);
  const double step = t - last_time_;
  last_time_ = t;
  difference_integral_ += step * (load.asked - load.carried).norm();
  specified_load_integral_ += step * asked;
  ++window_steps_;
  const double length = t - window_start_;
  if (length < window_length_) return;
  const bool short_steps =
      static_cast<double>(window_steps_) * longest_step_ > kShortStepRatio * length;
  bad_windows_ = short_steps && difference_integral_ > kMaxDifference * specified_load_integral_
                     ? bad_windows_ + 1
                     : 0;
  const double difference = difference_integral_ / length,
               specified = specified_load_integral_ / length;
  begin(t);
  if (bad_windows_ < kMaxWindows) return;
  throw SolverError(fmt::format(
      "at t = {:.9g} s the inner race is not in balance (mode = 2): its specified load is {:.4g} "
      "N, but the load of the elements differs from it by {:.4g} N on average over the last {:.3g} "
      "s. Elements with little contact cannot support a race without inertia. Increase load or "
      "preload, or set mode to 0 with kDCR = 1 and kFD = 0",
      t, specified, difference, length));
}

}  // namespace adore::runs
