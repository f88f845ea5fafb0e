#pragma once

#include "studies/accuracy.hpp"

#include <cstddef>
#include <vector>

/// The one rule by which rows of an accuracy study are ordered, and with which a row keeps to its
/// target: each quantity by what can be known of it.
namespace adore::studies {

constexpr double kBeyondNoise = 1.5;  ///< multiple of the noise above which an error is significant
constexpr double kAtLongest = 0.98;   ///< mean step over longest: it never took another

/// Errors above `kBeyondNoise` times the noise of their own quantity; others are 0:
/// over this span they cannot be resolved. Values that were not computed stay negative.
[[nodiscard]] results::AccuracyErrors significant_errors(const results::AccuracyErrors& errors,
                                                         const results::AccuracyErrors& noise);

/// The largest of them over its limit, the larger of `target` and `kBeyondNoise` times its noise:
/// up to 1 a row keeps to the target, of two rows the one with less is the better.
[[nodiscard]] double error_to_limit_ratio(const results::AccuracyErrors& errors,
                                          const results::AccuracyErrors& noise, double target);

/// Runs of one method from nearly identical starts.
using NearbyRuns = std::vector<results::KeyResults>;

/// Noise of means as such runs tell it, of one method or of two with three runs each: the root mean
/// square of the differences of two runs of one method, times Student's t for 95 % of so few runs
/// (4.30 with 2 degrees of freedom, 2.78 with 4) over kBeyondNoise. A run of another method then
/// differs by more than kBeyondNoise times that in one case of twenty only, unless the method is
/// off. Errors of a method do not count, since its runs all have them; one method alone may cross
/// a sudden motion (a cage that passes its axis) alike in all of its runs.
/// Negative where it was not computed.
[[nodiscard]] results::AccuracyErrors estimate_noise(const std::vector<NearbyRuns>& methods);

/// Front (no row of the round is cheaper and as good) and observed order of the rows of one round.
void judge_rows(std::vector<AccuracyRow>& rows, const results::AccuracyErrors& noise,
                double target);

/// Rows of the first round that may be the cheapest of their accuracy, at most `most`, those of
/// the deck's own settings left out: by time, those that keep to the target or are on the front
/// first, those more than five times above it last.
[[nodiscard]] std::vector<std::size_t> candidates(const std::vector<AccuracyRow>& rows,
                                                  const results::AccuracyErrors& noise,
                                                  double target, std::size_t most);

}  // namespace adore::studies
