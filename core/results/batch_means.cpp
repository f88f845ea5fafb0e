#include "results/batch_means.hpp"

#include <algorithm>
#include <numeric>

namespace adore::results {
namespace {

constexpr std::size_t kMinBatches = 8;  ///< batches

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

double sum_of(std::span<const double> x) { return std::accumulate(x.begin(), x.end(), 0.0); }

/// Neighbors joined until a batch is as long as `seconds`; false: not a multiple.
bool join(RatioSeries& series, double seconds) {
  const double ratio = seconds / series.seconds;
  const double whole = std::round(ratio);
  if (!(whole >= 1.0) || std::abs(ratio - whole) > 1e-9 * ratio) return false;
  const auto join = static_cast<std::size_t>(whole);
  const std::size_t count = series.a.size() / join;
  for (std::vector<double>* x : {&series.a, &series.s}) {
    for (std::size_t b = 0; b < count; ++b)
      (*x)[b] = sum_of(std::span<const double>(*x).subspan(b * join, join));
    x->resize(count);
  }
  series.seconds = seconds;
  return true;
}

/// Sums of d over m blocks as equal as possible.
std::vector<double> blocks_of(std::span<const double> d, std::size_t m) {
  std::vector<double> out(m);
  for (std::size_t b = 0; b < m; ++b) {
    const std::size_t begin = b * d.size() / m, end = (b + 1) * d.size() / m;
    out[b] = sum_of(d.subspan(begin, end - begin));
  }
  return out;
}

double squares_of(std::span<const double> x) {
  return std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
}

/// Error ε(L) of a span L by the fit ε = whole (L / span)^-exponent.
struct Fall {
  double whole = 0.0;     ///< ε of the whole span
  double exponent = 0.5;  ///< p, from 0 to 1
};

/// Line through ln ε(1/m of the span) over ln m, m = 1, 2, 4, 8, 16 with weights m: the scatter of
/// ln(mean of m squares) falls with m.
Fall fall_of(std::span<const double> d) {
  double w = 0.0, wx = 0.0, wy = 0.0, wxx = 0.0, wxy = 0.0;
  for (std::size_t m = 1; m <= 16 && m <= d.size(); m *= 2) {
    const auto blocks = static_cast<double>(m);
    const double mean = squares_of(blocks_of(d, m)) / blocks;
    if (!(mean > 0.0)) return {};
    const double x = std::log(blocks), y = 0.5 * std::log(mean) + x;
    w += blocks, wx += blocks * x, wy += blocks * y, wxx += blocks * x * x, wxy += blocks * x * y;
  }
  const double p = std::clamp((w * wxy - wx * wy) / (w * wxx - wx * wx), 0.0, 1.0);
  return {std::exp((wy - p * wx) / w), p};
}

}  // namespace

PairedScatter paired_scatter(const RatioSeries& one, const RatioSeries& other) {
  PairedScatter out;
  if (!(one.seconds > 0.0) || !(other.seconds > 0.0)) return out;
  RatioSeries p = one, q = other;
  const double seconds = std::max(p.seconds, q.seconds);
  if (!join(p, seconds) || !join(q, seconds)) return out;
  const std::size_t n = std::min(p.a.size(), q.a.size());
  if (n < kMinBatches) return out;
  for (RatioSeries* x : {&p, &q}) {
    x->a.resize(n);
    x->s.resize(n);
  }
  const double s1 = sum_of(p.s), s2 = sum_of(q.s);
  if (!(std::abs(s1) > 0.0) || !(std::abs(s2) > 0.0)) return out;
  const double ratio = 0.5 * (sum_of(p.a) / s1 + sum_of(q.a) / s2);
  std::vector<double> d(n);
  for (std::size_t b = 0; b < n; ++b)
    d[b] = (p.a[b] - ratio * p.s[b]) / s1 - (q.a[b] - ratio * q.s[b]) / s2;
  constexpr double kStudent8 = 2.306, kStudent3 = 3.182;
  const std::vector<double> blocks = blocks_of(d, 8);
  const double squares = squares_of(blocks);
  out.half_width =
      std::max(kStudent8 * std::sqrt(squares), static_cast<double>(n) * by_initial_sequence(d));
  const Fall fall = fall_of(d);
  if (fall.exponent > 0.5) out.half_width = std::min(out.half_width, kStudent3 * fall.whole);
  out.fall = std::clamp(fall.exponent, kLeastFall, 0.5);
  if (squares > 0.0)
    out.late = std::max(1.0, 2.0 * squares_of(std::span(blocks).last(4)) / squares);
  return out;
}

double ratio_half_width(std::span<const double> a, std::span<const double> s) {
  if (a.size() < kMinBatches || a.size() != s.size())
    return std::numeric_limits<double>::quiet_NaN();
  const double sum = std::accumulate(s.begin(), s.end(), 0.0);
  if (!(std::abs(sum) > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  const double ratio = std::accumulate(a.begin(), a.end(), 0.0) / sum;
  std::vector<double> e(a.size());
  for (std::size_t b = 0; b < e.size(); ++b) e[b] = a[b] - ratio * s[b];
  const double mean = std::abs(sum) / static_cast<double>(s.size());
  return std::max(by_batch_means(e), by_initial_sequence(e)) / mean;
}

}  // namespace adore::results
