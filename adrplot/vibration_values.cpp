#include "adrplot/vibration_values.hpp"

#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace adore::adrplot {
namespace {

/// Position of missing values, which prevent a spectrum; empty: no values are missing.
std::string missing_values(const std::vector<double>& t, const std::vector<double>& values) {
  const auto missing = static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }));
  if (missing == 0 || values.size() != t.size()) return {};
  const auto known = [](double v) { return std::isfinite(v); };
  const auto first =
      static_cast<std::size_t>(std::find_if(values.begin(), values.end(), known) - values.begin());
  const auto behind =
      static_cast<std::size_t>(values.rend() - std::find_if(values.rbegin(), values.rend(), known));
  const auto seconds = [&](std::size_t i) { return desktop::pretty_quantity(t[i], "s", 3); };
  std::string where = fmt::format("at {} of {} steps", missing, values.size());
  if (missing == values.size() - behind) where = "after " + seconds(behind - 1);
  if (missing == first) where = "before " + seconds(first);
  return "there are no values " + where + std::string(kNoSpectrum);
}

}  // namespace

double highest_frequency_above(const std::vector<double>& frequency,
                               const std::vector<double>& amplitude, double level) {
  for (std::size_t k = std::min(frequency.size(), amplitude.size()); k-- > 0;)
    if (amplitude[k] > level) return frequency[k];
  return 0.0;
}

BridgedValues bridge_gaps(const std::vector<double>& t, const std::vector<double>& values,
                          Window window) {
  constexpr double kMost = 0.01;   // of the steps
  constexpr double kStrong = 0.1;  // of the largest amplitude
  BridgedValues out;
  const auto known = [&](std::size_t i) { return std::isfinite(values[i]); };
  const std::size_t n = std::min(t.size(), values.size());
  std::size_t missing = 0;
  for (std::size_t i = 0; i < n; ++i) missing += known(i) ? 0 : 1;
  out.values = values;
  if (missing == 0 || values.size() != t.size()) return out;
  out.why_none = missing_values(t, values);
  if (static_cast<double>(missing) > kMost * static_cast<double>(n)) return {{}, {}, out.why_none};
  double longest = 0.0;
  for (std::size_t i = 0; i < n;) {
    if (known(i)) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < n && !known(end)) ++end;
    if (i == 0 || end == n)
      return {{}, {}, out.why_none};  // a gap at an end cannot be interpolated
    const std::size_t from = i - 1;
    longest = std::max(longest, t[end] - t[from]);
    for (; i < end; ++i)
      out.values[i] =
          values[from] + (t[i] - t[from]) / (t[end] - t[from]) * (values[end] - values[from]);
  }
  const signal::Samples samples = signal::equally_spaced_samples(t, out.values);
  const signal::Spectrum spectrum =
      signal::amplitude_spectrum(samples.values, samples.step, window);
  const double largest = spectrum.amplitude.empty() ? 0.0
                                                    : *std::max_element(spectrum.amplitude.begin(),
                                                                        spectrum.amplitude.end());
  const double highest =
      highest_frequency_above(spectrum.frequency, spectrum.amplitude, kStrong * largest);
  if (2.0 * longest * highest > 1.0) {
    std::string why = out.why_none;
    why.replace(why.size() - kNoSpectrum.size(), kNoSpectrum.size(),
                fmt::format(" (a gap of {} is too long for vibrations up to {})",
                            desktop::pretty_quantity(longest, "s", 3),
                            desktop::pretty_quantity(highest, "Hz", 3)));
    return {{}, {}, why + std::string(kNoSpectrum)};
  }
  out.why_none.clear();
  out.told =
      fmt::format("{} of {} steps {} no value: interpolated linearly (longest gap {}).", missing, n,
                  missing == 1 ? "has" : "have", desktop::pretty_quantity(longest, "s", 3));
  return out;
}

bool is_only_rounding(const std::vector<double>& values, const std::string& unit, double known) {
  constexpr double kSmall = 1e-12, kPart = 1e-3, kDigits = 2e-13, kLastDigit = 1.1e-7;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  const double size = std::max(std::abs(low), std::abs(high));
  const bool pure_or_power = unit.empty() || unit == "W" || unit == "in.lbf/s";
  const double least = std::max(
      {known, kDigits * size, pure_or_power ? kSmall : kPart * desktop::min_axis_span(unit)});
  if (!(high - low > least)) return true;
  if (high - low > kLastDigit * size) return false;
  return std::all_of(values.begin(), values.end(), [](double v) {
    const std::string text = fmt::format("{:.7e}", v);
    double read = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    return !std::isfinite(v) || read == v;
  });
}

}  // namespace adore::adrplot
