#pragma once

#include "runs/run.hpp"
#include "runs/run_outputs.hpp"

#include <string>

/// From where to where a run goes.
namespace adore::runs {

/// Steps and end time of a run in seconds.
struct RunSpan {
  double end = 0.0;    ///< [s]
  long max_steps = 0;  ///< counted steps
};

/// Does a race turn at another speed than the deck's constant one? Then turns give no end time.
[[nodiscard]] bool speeds_vary(const Prepared& prepared);

/// The end that the request or the deck asks for. @throws InputError
[[nodiscard]] RunSpan run_span(const RunRequest& request, const Prepared& prepared,
                               double time_scale);

/// Number of the last counted step of a run that continues or starts at `start`.
[[nodiscard]] long last_step(const RunRequest& request, const RunSpan& span,
                             const StartPoint& start);

/// Delay of the end of a continued run compared with its present speeds, because
/// its speeds were different before [s].
[[nodiscard]] double end_time_delay(const RunRequest& request, const StartPoint& start,
                                    double turned, double turns_per_second);

/// A continued run must have its end before it.
/// @param turned of the shaft until now
/// @return true when it has reached it already
/// @throws InputError
[[nodiscard]] bool has_reached_end(const RunSpan& span, long last_step, const StartPoint& start,
                                   double turned, double turns_per_second);

}  // namespace adore::runs
