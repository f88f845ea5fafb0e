#pragma once

#include <cstddef>
#include <vector>

/// Samples at equal intervals from stored values.
namespace adore::signal {

/// Fewer stored steps have no spectrum.
inline constexpr std::size_t kMinSamples = 16;

enum class SamplingFault : unsigned char { None, TooFew, MissingValues, TimesNotIncreasing };

struct Samples {
  std::vector<double> values;
  double start = 0.0, step = 0.0;  ///< [s]
  bool resampled = false;          ///< between stored steps of unequal length, by straight lines
  bool last_dropped = false;       ///< the last step is shorter than the others
  double shortest = 0.0, longest = 0.0;       ///< stored steps [s]; of resampled ones only
  SamplingFault fault = SamplingFault::None;  ///< reason for no values
};

/// Stored values at equal intervals. Increments are equal if they agree to 0.1 % of their mean plus
/// the rounding of seven digits of the times; a shorter last one (the end of a run is seldom a
/// multiple of the step) is dropped. Otherwise the values are interpolated linearly on a grid
/// through as many stored times as possible. A tone of frequency f keeps
/// (sin(pi f h) / (pi f h))^2 of its amplitude over steps of h: frequencies above half the inverse
/// of the longest increment are lost.
[[nodiscard]] Samples equally_spaced_samples(const std::vector<double>& times,
                                             const std::vector<double>& values);

/// Less the straight line of least squares: mean and trend.
[[nodiscard]] std::vector<double> without_trend(const std::vector<double>& samples);

}  // namespace adore::signal
