#include "runs/race_watch.hpp"

#include "base/errors.hpp"
#include "results/mean_load.hpp"

#include <fmt/format.h>

namespace adore::runs {

void RaceWatch::begin(double t) noexcept {
  begun_ = true;
  start_ = last_ = t;
  off_ = asked_ = 0.0;
  steps_ = 0;
}

void RaceWatch::look(double t, const dynamics::RaceLoad& load, double contact) {
  const double asked = std::max(load.asked.norm(), results::kLoadFloor * contact);
  if (!(load.asked.norm() > 0.0)) {
    begun_ = false;  // a window is of one time without a gap
    return;
  }
  if (!begun_) return begin(t);
  const double step = t - last_;
  last_ = t;
  off_ += step * (load.asked - load.carried).norm();
  asked_ += step * asked;
  ++steps_;
  const double length = t - start_;
  if (length < window_) return;
  const bool crowded = static_cast<double>(steps_) * longest_ > kCrowded * length;
  windows_ = crowded && off_ > kMost * asked_ ? windows_ + 1 : 0;
  const double off = off_ / length, whole = asked_ / length;
  begin(t);
  if (windows_ < kWindows) return;
  throw SolverError(
      fmt::format("at t = {:.9g} s the inner race is not in balance (mode = 2): its specified "
                  "load is {:.4g} N, but the load of the elements differs by {:.4g} N on average "
                  "over the last {:.3g} s. Elements with little contact cannot support a race "
                  "without inertia. Increase load or preload, or set mode to 0 with kDCR = 1 and "
                  "kFD = 0",
                  t, whole, off, length));
}

}  // namespace adore::runs
