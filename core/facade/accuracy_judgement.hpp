#pragma once

#include "facade/accuracy.hpp"

#include <cstddef>
#include <vector>

/// The one rule by which rows of an accuracy study are ordered, and with which a row keeps to its
/// target: each quantity by what can be known of it.
namespace adore::facade {

/// Errors that stand out of 1.5 times the noise of their own quantity; others are 0: over this
/// span nobody can tell whether a row has them.
[[nodiscard]] AccuracyErrors standing_out(const AccuracyErrors& errors,
                                          const AccuracyErrors& noise);

/// The largest of them over its limit, the larger of `target` and 1.5 times its noise: up to 1 a
/// row keeps to the target, of two rows the one with less is the better.
[[nodiscard]] double over_limits(const AccuracyErrors& errors, const AccuracyErrors& noise,
                                 double target);

/// Front (no row of the round is cheaper and as good) and observed order of the rows of one round.
void judge_rows(std::vector<AccuracyRow>& rows, const AccuracyErrors& noise, double target);

/// Rows of the first round that may be the cheapest of their accuracy, at most `most`, those of
/// the deck's own settings left out: by time, those that keep to the target or are on the front
/// first, those more than five times above it last.
[[nodiscard]] std::vector<std::size_t> candidates(const std::vector<AccuracyRow>& rows,
                                                  const AccuracyErrors& noise, double target,
                                                  std::size_t most);

}  // namespace adore::facade
