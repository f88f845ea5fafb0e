#pragma once

#include <vector>

/// Statistics of one column, without its missing and infinite values.
namespace adore::studies {

struct Percentile {
  double percent = 0.0, value = 0.0;
  /// 95 % confidence interval of a percentile, for any distribution: order statistics with the
  /// ranks n p ± 1.96 √(n p (1 - p)), at most the ends of the sample. For independent samples;
  /// Latin and Sobol samples are better.
  double low = 0.0, high = 0.0;
};

struct Summary {
  std::size_t count = 0, infinite = 0;
  double mean = 0.0, deviation = 0.0;  ///< with n - 1; 0 for one value
  double least = 0.0, largest = 0.0;
  std::vector<Percentile> percentiles;
};
[[nodiscard]] Summary summarize(const std::vector<double>& values,
                                const std::vector<double>& percents);

/// Spearman's rank correlation, ties with their mean rank; pairs with a missing value are left out.
/// NaN where one side does not vary.
[[nodiscard]] double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace adore::studies
