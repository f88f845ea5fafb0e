#include "results/batch_means.hpp"

#include <algorithm>
#include <numeric>

namespace adore::results {
namespace {

constexpr std::size_t kLeast = 8;  ///< batches

/// Two-sided 95 % quantile of Student's t for 3 to 7 degrees of freedom.
constexpr std::array<double, 5> kStudent{3.182, 2.776, 2.571, 2.447, 2.365};

/// Half of the 95 % interval of the mean of e by long batches.
double by_batch_means(std::span<const double> e) {
  const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(e.size())));
  const std::size_t batches = std::clamp<std::size_t>(root, 4, 8);
  const std::size_t length = e.size() / batches;
  // The oldest values that fill no batch are left out: they are closest to the start.
  const std::span<const double> used = e.last(batches * length);
  double mean = 0.0, squares = 0.0;
  std::vector<double> means(batches);
  for (std::size_t b = 0; b < batches; ++b) {
    const auto part = used.subspan(b * length, length);
    means[b] = std::accumulate(part.begin(), part.end(), 0.0) / static_cast<double>(length);
    mean += means[b] / static_cast<double>(batches);
  }
  for (const double one : means) squares += (one - mean) * (one - mean);
  const auto m = static_cast<double>(batches);
  return kStudent.at(batches - 4) * std::sqrt(squares / (m * (m - 1.0)));
}

/// The same by the initial monotone sequence of autocovariances.
double by_initial_sequence(std::span<const double> e) {
  const auto n = static_cast<double>(e.size());
  const auto covariance = [&](std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < e.size(); ++i) sum += e[i] * e[i - lag];
    return sum / n;
  };
  double variance = -covariance(0), before = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; 2 * k + 1 < e.size(); ++k) {
    const double pair = std::min(covariance(2 * k) + covariance(2 * k + 1), before);
    if (!(pair > 0.0)) break;
    variance += 2.0 * pair;
    before = pair;
  }
  return 2.0 * std::sqrt(std::max(variance, 0.0) / n);
}

}  // namespace

double ratio_half_width(std::span<const double> a, std::span<const double> s) {
  if (a.size() < kLeast || a.size() != s.size()) return std::numeric_limits<double>::quiet_NaN();
  const double sum = std::accumulate(s.begin(), s.end(), 0.0);
  if (!(std::abs(sum) > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  const double ratio = std::accumulate(a.begin(), a.end(), 0.0) / sum;
  std::vector<double> e(a.size());
  for (std::size_t b = 0; b < e.size(); ++b) e[b] = a[b] - ratio * s[b];
  const double mean = std::abs(sum) / static_cast<double>(s.size());
  return std::max(by_batch_means(e), by_initial_sequence(e)) / mean;
}

}  // namespace adore::results
