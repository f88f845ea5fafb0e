#include "studies/statistics.hpp"

#include "studies/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace adore::studies {
namespace {

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  std::vector<double> out(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    for (std::size_t k = i; k < end; ++k) out[order[k]] = 0.5 * static_cast<double>(i + end - 1);
    i = end;
  }
  return out;
}

}  // namespace

Summary summarize(const std::vector<double>& values, const std::vector<double>& percents) {
  Summary out;
  std::vector<double> known;
  for (const double value : values) {
    if (std::isfinite(value)) known.push_back(value);
    if (std::isinf(value)) ++out.infinite;
  }
  out.count = known.size();
  if (known.empty()) return out;
  std::sort(known.begin(), known.end());
  out.least = known.front();
  out.largest = known.back();
  const auto n = static_cast<double>(known.size());
  for (const double value : known) out.mean += value / n;
  if (known.size() > 1) {
    double squares = 0.0;
    for (const double value : known) squares += (value - out.mean) * (value - out.mean);
    out.deviation = std::sqrt(squares / (n - 1.0));
  }
  for (const double percent : percents) {
    constexpr double kNormal95 = 1.96;
    const double p = percent / 100.0, spread = kNormal95 * std::sqrt(n * p * (1.0 - p));
    const auto at = [&](double rank) {
      return known[static_cast<std::size_t>(std::clamp(rank, 0.0, n - 1.0))];
    };
    out.percentiles.push_back({percent, percentile_of_sorted(known, percent),
                               at(std::floor(n * p - spread) - 1.0),
                               at(std::ceil(n * p + spread))});
  }
  return out;
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (!std::isnan(a[i]) && !std::isnan(b[i])) {
      x.push_back(a[i]);
      y.push_back(b[i]);
    }
  const std::vector<double> rx = ranks(x), ry = ranks(y);
  const double middle = 0.5 * (static_cast<double>(rx.size()) - 1.0);
  double xy = 0.0, xx = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < rx.size(); ++i) {
    xy += (rx[i] - middle) * (ry[i] - middle);
    xx += (rx[i] - middle) * (rx[i] - middle);
    yy += (ry[i] - middle) * (ry[i] - middle);
  }
  return xx > 0.0 && yy > 0.0 ? xy / std::sqrt(xx * yy) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace adore::studies
