#include "signal/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace adore::signal {
namespace {

/// Grid with equal steps through as many stored times as possible: linear interpolation attenuates
/// fast motion at all other points.
struct Grid {
  double start = 0.0, step = 0.0;
  std::size_t count = 0;
};

Grid grid_through(const std::vector<double>& times) {
  const std::size_t n = times.size();
  std::vector<double> steps(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) steps[i] = times[i + 1] - times[i];
  std::vector<double> sorted = steps;
  std::nth_element(sorted.begin(), sorted.begin() + std::ssize(sorted) / 2, sorted.end());
  Grid out{times.front(), sorted[sorted.size() / 2], 0};
  // The longest stretch of steps of that length.
  constexpr double kEqual = 1e-3;
  std::size_t longest = 0, anchor = 0, equal = 0, run = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    run = std::abs(steps[i] - out.step) <= kEqual * out.step ? run + 1 : 0;
    equal += run > 0 ? 1 : 0;
    if (run > longest) {
      longest = run;
      anchor = i + 1 - run;
    }
  }
  const double whole = times.back() - times.front();
  if (10 * equal < 9 * steps.size()) {  // steps of all lengths
    out.step = whole / static_cast<double>(n - 1);
    out.count = n;
    return out;
  }
  // The mean of the stretch: times of a file have few digits.
  out.step = (times[anchor + longest] - times[anchor]) / static_cast<double>(longest);
  out.start = times[anchor] - std::floor((times[anchor] - times.front()) / out.step) * out.step;
  out.count = static_cast<std::size_t>((times.back() - out.start) / out.step * (1.0 + 1e-12)) + 1;
  return out;
}

std::pair<double, double> range_of_steps(const std::vector<double>& times) {
  double shortest = times[1] - times[0], longest = shortest;
  for (std::size_t i = 1; i < times.size(); ++i) {
    shortest = std::min(shortest, times[i] - times[i - 1]);
    longest = std::max(longest, times[i] - times[i - 1]);
  }
  return {shortest, longest};
}

bool has_equal_steps(const std::vector<double>& times, double rounding) {
  const auto [shortest, longest] = range_of_steps(times);
  const double mean = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  return longest - shortest <= 1e-3 * mean + rounding && rounding <= 0.5 * mean;
}

SamplingFault fault_of(const std::vector<double>& times, const std::vector<double>& values) {
  if (times.size() < kMinSamples) return SamplingFault::TooFew;
  if (values.size() != times.size() ||
      std::any_of(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }))
    return SamplingFault::MissingValues;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1])) return SamplingFault::TimesNotIncreasing;
  return SamplingFault::None;
}

void interpolate(const std::vector<double>& times, const std::vector<double>& values,
                 const Grid& grid, Samples& out) {
  const std::size_t n = times.size();
  std::size_t at = 0;
  for (std::size_t i = 0; i < grid.count; ++i) {
    const double t = grid.start + grid.step * static_cast<double>(i);
    while (at + 2 < n && times[at + 1] < t) ++at;
    const double part = std::clamp((t - times[at]) / (times[at + 1] - times[at]), 0.0, 1.0);
    out.values.push_back(values[at] + part * (values[at + 1] - values[at]));
  }
}

}  // namespace

Samples equally_spaced_samples(const std::vector<double>& all_times,
                               const std::vector<double>& values) {
  Samples out;
  out.fault = fault_of(all_times, values);
  if (out.fault != SamplingFault::None) return out;
  std::vector<double> times = all_times;
  const double rounding = 2e-7 * std::max(std::abs(times.front()), std::abs(times.back()));
  bool equal = has_equal_steps(times, rounding);
  if (!equal) {  // without the last one
    const double last = times.back();
    times.pop_back();
    equal = last - times.back() < times.back() - times[times.size() - 2] &&
            has_equal_steps(times, rounding);
    if (!equal) times.push_back(last);
  }
  const std::size_t n = times.size();
  out.start = times.front();
  out.step = (times.back() - times.front()) / static_cast<double>(n - 1);
  if (equal) {
    out.values.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n));
    out.last_dropped = n < values.size();
    return out;
  }
  out.resampled = true;
  std::tie(out.shortest, out.longest) = range_of_steps(times);
  const Grid grid = grid_through(times);
  out.start = grid.start;
  out.step = grid.step;
  interpolate(times, values, grid, out);
  return out;
}

std::vector<double> without_trend(const std::vector<double>& samples) {
  const auto n = static_cast<double>(samples.size());
  const double middle = 0.5 * (n - 1.0);
  double mean = 0.0, moment = 0.0;
  for (const double s : samples) mean += s / n;
  for (std::size_t i = 0; i < samples.size(); ++i)
    moment += (static_cast<double>(i) - middle) * (samples[i] - mean);
  // Sum of the squares of the indices about their mean: n (n^2 - 1) / 12.
  const double slope = samples.size() > 1 ? 12.0 * moment / (n * (n * n - 1.0)) : 0.0;
  std::vector<double> out(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    out[i] = samples[i] - mean - slope * (static_cast<double>(i) - middle);
  return out;
}

}  // namespace adore::signal
