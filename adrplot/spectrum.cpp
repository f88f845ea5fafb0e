#include "adrplot/spectrum.hpp"

#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace adore::adrplot {
namespace {

constexpr std::size_t kFewest = 16;

double weight(Window window, std::size_t i, std::size_t n) {
  const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
  switch (window) {
    case Window::Hann:
      return 1.0 - std::cos(a);
    case Window::FlatTop:
      return 1.0 - 1.93 * std::cos(a) + 1.29 * std::cos(2.0 * a) - 0.388 * std::cos(3.0 * a) +
             0.0322 * std::cos(4.0 * a);
    case Window::None:
      break;
  }
  return 1.0;
}

}  // namespace

std::string window_name(Window window) {
  switch (window) {
    case Window::Hann:
      return "Hann window";
    case Window::FlatTop:
      return "flat top window";
    case Window::None:
      break;
  }
  return "no window";
}

namespace {

/// Grid with equal steps through as many stored times as possible: linear interpolation attenuates
/// fast motion at all other points.
struct Grid {
  double start = 0.0, step = 0.0;
  std::size_t count = 0;
};
Grid grid_through(const std::vector<double>& times) {
  const std::size_t n = times.size();
  std::vector<double> apart(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) apart[i] = times[i + 1] - times[i];
  std::vector<double> sorted = apart;
  std::nth_element(sorted.begin(), sorted.begin() + std::ssize(sorted) / 2, sorted.end());
  Grid out{times.front(), sorted[sorted.size() / 2], 0};
  // The longest stretch of steps of that length.
  constexpr double kAlike = 1e-3;
  std::size_t longest = 0, anchor = 0, alike = 0, run = 0;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    run = std::abs(apart[i] - out.step) <= kAlike * out.step ? run + 1 : 0;
    alike += run > 0 ? 1 : 0;
    if (run > longest) {
      longest = run;
      anchor = i + 1 - run;
    }
  }
  const double whole = times.back() - times.front();
  if (10 * alike < 9 * apart.size()) {  // steps of all lengths
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

}  // namespace

Samples equal_samples(const std::vector<double>& all_times, const std::vector<double>& values) {
  Samples out;
  std::vector<double> times = all_times;
  if (times.size() < kFewest) {
    out.note = fmt::format("The frequency spectrum needs at least {} stored steps; {} {} loaded.",
                           kFewest, times.size(), times.size() == 1 ? "is" : "are");
    return out;
  }
  if (values.size() != times.size() ||
      std::any_of(values.begin(), values.end(), [](double v) { return !std::isfinite(v); })) {
    out.note = "No frequency spectrum: some values are missing.";
    return out;
  }
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1])) {
      out.note = "No frequency spectrum: the stored times do not increase.";
      return out;
    }
  const auto increments = [&times] {
    double smallest = times[1] - times[0], largest = smallest;
    for (std::size_t i = 1; i < times.size(); ++i) {
      smallest = std::min(smallest, times[i] - times[i - 1]);
      largest = std::max(largest, times[i] - times[i - 1]);
    }
    return std::pair(smallest, largest);
  };
  const double rounding = 2e-7 * std::max(std::abs(times.front()), std::abs(times.back()));
  const auto equal = [&](const std::pair<double, double>& range) {
    const double mean = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    return range.second - range.first <= 1e-3 * mean + rounding && rounding <= 0.5 * mean;
  };
  bool same = equal(increments());
  if (!same) {  // without the last one
    const double last = times.back();
    times.pop_back();
    const double before = times.back() - times[times.size() - 2];
    same = last - times.back() < before && equal(increments());
    if (!same) times.push_back(last);
  }
  const std::size_t n = times.size();
  out.start = times.front();
  out.step = (times.back() - times.front()) / static_cast<double>(n - 1);
  if (same) {
    out.values.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n));
    if (n < values.size()) out.note = "The shorter last step is not included.";
    return out;
  }
  const auto [smallest, largest] = increments();
  out.resampled = true;
  const Grid grid = grid_through(times);
  out.start = grid.start;
  out.step = grid.step;
  const auto seconds = [](double value) { return desktop::pretty_quantity(value, "s", 3); };
  // Straight lines over steps of h leave (sin(pi f h) / (pi f h))^2 of a tone of frequency f.
  out.note = fmt::format(
      "Resampled every {} by linear interpolation (steps of {} to {}): amplitudes are up to 20 % "
      "too low at {} "
      "and unreliable above {}.",
      seconds(out.step), seconds(smallest), seconds(largest),
      desktop::pretty_quantity(0.25 / largest, "Hz", 3),
      desktop::pretty_quantity(0.5 / largest, "Hz", 3));
  std::size_t at = 0;
  for (std::size_t i = 0; i < grid.count; ++i) {
    const double t = grid.start + grid.step * static_cast<double>(i);
    while (at + 2 < n && times[at + 1] < t) ++at;
    const double part = std::clamp((t - times[at]) / (times[at + 1] - times[at]), 0.0, 1.0);
    out.values.push_back(values[at] + part * (values[at + 1] - values[at]));
  }
  return out;
}

Spectrum amplitude_spectrum(const std::vector<double>& samples, double step, Window window) {
  Spectrum spectrum;
  const std::size_t n = samples.size();
  if (n < 4 || !(step > 0.0)) return spectrum;
  double mean = 0.0, size = 0.0, weights = 0.0;
  for (const double s : samples) {
    mean += s / static_cast<double>(n);
    size = std::max(size, std::abs(s));
  }
  std::vector<double> centred(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double w = weight(window, i, n);
    weights += w;
    centred[i] = w * (samples[i] - mean);
  }
  std::vector<std::complex<double>> transform;
  Eigen::FFT<double> fft;
  fft.fwd(transform, centred);
  double largest = 0.0;
  for (std::size_t k = 1; k <= n / 2; ++k) {
    const double once = 2 * k == n ? 1.0 : 2.0;
    spectrum.frequency.push_back(static_cast<double>(k) / (static_cast<double>(n) * step));
    spectrum.amplitude.push_back(once * std::abs(transform[k]) / weights);
    largest = std::max(largest, spectrum.amplitude.back());
  }
  // A constant leaves rounding errors of the mean only: about 1e-16 of its size.
  if (!(largest > 2e-13 * size))
    std::fill(spectrum.amplitude.begin(), spectrum.amplitude.end(), 0.0);
  return spectrum;
}

void scale_spectrum(Spectrum& spectrum, SpectrumScale scale) {
  if (scale == SpectrumScale::Units || spectrum.amplitude.empty()) return;
  constexpr double kFloor = -160.0;  // [dB]: rounding of sixteen digits
  const double largest = *std::max_element(spectrum.amplitude.begin(), spectrum.amplitude.end());
  for (double& a : spectrum.amplitude) {
    const double part = largest > 0.0 ? a / largest : 0.0;
    a = scale == SpectrumScale::Relative ? part
        : part > 0.0                     ? std::max(kFloor, 20.0 * std::log10(part))
                                         : kFloor;
  }
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

Waterfall waterfall(const Samples& samples, Window window, std::size_t pieces) {
  Waterfall out;
  const std::size_t n = samples.values.size();
  if (n < kFewest || pieces == 0) return out;
  // Pieces of length L that overlap by half: n = L (pieces + 1) / 2.
  const std::size_t length = std::max(kFewest, 2 * n / (pieces + 1));
  const std::size_t hop = std::max<std::size_t>(1, length / 2);
  for (std::size_t first = 0; first + length <= n; first += hop) {
    const auto begin = samples.values.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<double> values(begin, begin + static_cast<std::ptrdiff_t>(length));
    Spectrum piece = amplitude_spectrum(without_trend(values), samples.step, window);
    double size = 0.0;
    for (const double v : values) size = std::max(size, std::abs(v));
    // After a linear trend only rounding remains.
    if (*std::max_element(piece.amplitude.begin(), piece.amplitude.end()) <= 2e-13 * size)
      std::fill(piece.amplitude.begin(), piece.amplitude.end(), 0.0);
    out.frequency = piece.frequency;
    out.amplitude.push_back(piece.amplitude);
    out.time.push_back(samples.start + samples.step * (static_cast<double>(first) +
                                                       0.5 * static_cast<double>(length - 1)));
  }
  return out;
}

}  // namespace adore::adrplot
