#include "adrplot/spectrum_page.hpp"

#include "adrplot/known_values.hpp"
#include "adrplot/sentence_words.hpp"
#include "base/counted.hpp"
#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace adore::adrplot {
namespace {

using desktop::ChartCurve;
using desktop::ChartPage;
using desktop::ChartPanel;

constexpr std::string_view kHere = "No vibration: ";
constexpr std::string_view kSo = ", so there is no frequency spectrum.";
constexpr auto kStill = "No vibration: the value is constant.";
constexpr auto kAllStill = "No vibration: all values of this page are constant.";
constexpr auto kRounding = "No vibration: the value changes only by rounding errors.";

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
  return "there are no values " + where + std::string(kSo);
}

/// Why a curve has no spectrum.
struct Reason {
  std::string curve, why;
};

/// Without "here": the curve, or the panel for all curves.
std::string named(const std::string& name, std::string why) {
  if (!name.empty() && why.starts_with(kHere)) why.erase(0, kHere.size());
  return capital(name.empty() ? why : name + ": " + why);
}

/// Curves without a spectrum in panels with other spectra.
struct Aside {
  Reason reason;
  std::string panels;
};

/// Equal reasons of several curves or panels are given once.
void add_aside(std::vector<Aside>& asides, const Reason& reason, const std::string& panel) {
  const auto same = std::find_if(asides.begin(), asides.end(), [&](const Aside& aside) {
    return aside.reason.curve == reason.curve && aside.reason.why == reason.why;
  });
  if (same == asides.end())
    asides.push_back({reason, panel});
  else
    same->panels += " and " + small(panel);
}

/// In the panel if none of its curves is drawn, else for the note.
void tell_reasons(ChartPanel& panel, const std::vector<Reason>& reasons,
                  std::vector<Aside>& asides) {
  const bool drawn = std::any_of(panel.curves.begin(), panel.curves.end(),
                                 [](const ChartCurve& curve) { return !curve.y.empty(); });
  if (drawn) {
    for (const Reason& reason : reasons) add_aside(asides, reason, panel.title);
    return;
  }
  if (reasons.empty() && panel.message.empty())
    panel.message = "No values, so there is no frequency spectrum.";
  const bool same = std::all_of(reasons.begin(), reasons.end(), [&](const Reason& reason) {
    return reason.why == reasons.front().why;
  });
  if (!reasons.empty() && same) panel.message = capital(reasons.front().why);
  if (same) return;
  panel.message.clear();
  for (const Reason& reason : reasons) {
    std::string why = reason.why;
    if (&reason != &reasons.back() && why.ends_with(kSo))  // the last one has it
      why.replace(why.size() - kSo.size(), kSo.size(), ".");
    panel.message += (panel.message.empty() ? "" : " ") + named(reason.curve, why);
  }
}

constexpr double kVisible = 0.01;  ///< of a curve's largest amplitude

/// Does the first line, which is high, result from monotonic motion over the whole run? Removing a
/// linear trend leaves less than half of it; for a sine of one period more remains.
bool first_line_is_drift(const signal::Spectrum& spectrum, const signal::Samples& samples,
                         Window window) {
  constexpr double kTall = 0.1, kLost = 0.5;
  const auto& all = spectrum.amplitude;
  if (all.empty() || all.front() < kTall * *std::max_element(all.begin(), all.end())) return false;
  const signal::Spectrum level =
      signal::amplitude_spectrum(signal::without_trend(samples.values), samples.step, window);
  return level.amplitude.front() < kLost * all.front();
}

/// Relative to the largest value.
std::vector<double> relative_amplitude(const std::vector<double>& y, SpectrumScale scale) {
  std::vector<double> out = y;
  if (scale == SpectrumScale::Decibel)
    for (double& a : out) a = std::pow(10.0, a / 20.0);
  double largest = 0.0;
  for (const double a : out)
    if (a > largest) largest = a;  // missing values are skipped
  for (double& a : out) a = largest > 0.0 ? a / largest : 0.0;
  return out;
}

}  // namespace

double last_above(const std::vector<double>& frequency, const std::vector<double>& amplitude,
                  double level) {
  for (std::size_t k = std::min(frequency.size(), amplitude.size()); k-- > 0;)
    if (amplitude[k] > level) return frequency[k];
  return 0.0;
}

Bridged bridge_gaps(const std::vector<double>& t, const std::vector<double>& values,
                    Window window) {
  constexpr double kMost = 0.01;   // of the steps
  constexpr double kStrong = 0.1;  // of the largest amplitude
  Bridged out;
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
  const signal::Samples samples = signal::equal_samples(t, out.values);
  const signal::Spectrum spectrum =
      signal::amplitude_spectrum(samples.values, samples.step, window);
  const double largest = spectrum.amplitude.empty() ? 0.0
                                                    : *std::max_element(spectrum.amplitude.begin(),
                                                                        spectrum.amplitude.end());
  const double highest = last_above(spectrum.frequency, spectrum.amplitude, kStrong * largest);
  if (2.0 * longest * highest > 1.0) {
    std::string why = out.why_none;
    why.replace(why.size() - kSo.size(), kSo.size(),
                fmt::format(" (gaps up to {} are too long for lines up to {})",
                            desktop::pretty_quantity(longest, "s", 3),
                            desktop::pretty_quantity(highest, "Hz", 3)));
    return {{}, {}, why + std::string(kSo)};
  }
  out.why_none.clear();
  out.told =
      fmt::format("{} of {} steps {} no value: interpolated linearly (longest gap {}).", missing, n,
                  missing == 1 ? "has" : "have", desktop::pretty_quantity(longest, "s", 3));
  return out;
}

void add_note(ChartPage& chart, const std::string& text) {
  if (text.empty() || chart.note.find(text) != std::string::npos) return;
  chart.note += (chart.note.empty() ? "" : " ") + text;
}

bool only_rounding(const std::vector<double>& values, const std::string& unit, double known) {
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
      {known, kDigits * size, pure_or_power ? kSmall : kPart * desktop::least_span_of(unit)});
  if (!(high - low > least)) return true;
  if (high - low > kLastDigit * size) return false;
  return std::all_of(values.begin(), values.end(), [](double v) {
    const std::string text = fmt::format("{:.7e}", v);
    double read = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    return !std::isfinite(v) || read == v;
  });
}

/// No two of them differ.
static bool one_value(const std::vector<double>& values) {
  const auto number = [](double v) { return std::isfinite(v); };
  const auto first = std::find_if(values.begin(), values.end(), number);
  return std::all_of(first, values.end(), [&](double v) { return !number(v) || v == *first; });
}

static void tell_drift(ChartPage& chart, const std::vector<std::string>& drifting,
                       std::size_t drawn) {
  if (drifting.empty()) return;
  std::string of =
      drifting.size() == drawn ? "" : "For " + counted(drifting.size(), "curve") + ", ";
  if (drifting.size() < drawn && drifting.size() < 3)
    of = drifting.front() + (drifting.size() > 1 ? "; " + drifting.back() : "") + ": ";
  add_note(chart,
           fmt::format("{}{} first line is drift, not vibration.", of, of.empty() ? "The" : "the"));
}

void to_spectra(ChartPage& chart, const std::vector<double>& t, const SpectrumOptions& options) {
  const SpectrumScale scale = drawn_scale(options.scale, SpectrumScale::Units);
  std::vector<double> frequency;
  std::vector<Aside> asides;
  std::vector<std::string> drifting;
  std::size_t drawn = 0;
  for (ChartPanel& panel : chart.panels) {
    std::vector<Reason> reasons;  // of the curves without a spectrum
    for (ChartCurve& curve : panel.curves) {
      std::vector<double> stored = std::move(curve.y);
      curve.low.clear(), curve.high.clear();
      curve.y.clear();
      const auto none = [&](const std::string& why) { reasons.push_back({curve.name, why}); };
      if (!any_value(stored)) continue;  // the panel has its reason
      Bridged bridged = bridge_gaps(t, stored, options.window);
      if (!bridged.why_none.empty()) {
        none(bridged.why_none);
        continue;
      }
      stored = std::move(bridged.values);
      const signal::Samples samples = signal::equal_samples(t, stored);
      if (samples.values.empty()) {
        none(sampling_note(samples, t.size()));
        continue;
      }
      signal::Spectrum spectrum =
          signal::amplitude_spectrum(samples.values, samples.step, options.window);
      frequency = spectrum.frequency;
      if (std::all_of(spectrum.amplitude.begin(), spectrum.amplitude.end(),
                      [](double a) { return a == 0.0; })) {
        none(kStill);
        continue;
      }
      if (only_rounding(stored, panel.unit, panel.least_span)) {
        none(one_value(stored) ? kStill : kRounding);
        continue;
      }
      if (first_line_is_drift(spectrum, samples, options.window))
        drifting.push_back(panel.title + (curve.name.empty() ? "" : ", " + curve.name));
      ++drawn;
      scale_spectrum(spectrum, scale);
      curve.y = std::move(spectrum.amplitude);
      add_note(chart, sampling_note(samples, t.size()));  // of the drawn curves
      if (!bridged.told.empty()) add_aside(asides, {curve.name, bridged.told}, panel.title);
    }
    tell_reasons(panel, reasons, asides);
    panel.wraps = false;
    panel.least_span = 0.0;
    panel.unit = spectrum_unit(scale, panel.unit);
  }
  const bool all_still =
      chart.panels.size() > 1 &&
      std::all_of(chart.panels.begin(), chart.panels.end(),
                  [](const ChartPanel& panel) { return panel.message == kStill; });
  for (ChartPanel& panel : chart.panels)
    if (all_still) panel.message = kAllStill;
  tell_drift(chart, drifting, drawn);
  // One sentence for panels with the same remark.
  for (const Aside& aside : asides)
    add_note(chart,
             named(aside.panels + (aside.reason.curve.empty() ? "" : ", ") + aside.reason.curve,
                   aside.reason.why));
  if (chart.title.find("pectrum") == std::string::npos)
    chart.title = without_colon(chart.title) + ": amplitude spectrum";
  chart.x = std::move(frequency);
  chart.x_title = "Frequency";
  chart.x_unit = "Hz";
  if (chart.x.empty()) {  // of no curve
    for (const ChartPanel& panel : chart.panels) add_note(chart, panel.message);
    chart.panels.clear();
  }
}

std::string without_colon(std::string title) {
  if (const auto colon = title.find(": "); colon != std::string::npos)
    title.replace(colon, 2, ", ");
  return title;
}

void drop_low_marks(ChartPage& chart) {
  if (chart.x.empty() || chart.x_unit != "Hz") return;
  const double first = chart.x.front();
  std::string names;
  for (desktop::ChartMark& mark : chart.marks) {
    std::erase_if(mark.way, [first](const auto& place) { return place.first < first; });
    if (!mark.way.empty()) mark.x = mark.way.back().first;
    if (mark.x < first) names += (names.empty() ? "" : ", ") + mark.label;
  }
  std::erase_if(chart.marks, [first](const desktop::ChartMark& mark) { return mark.x < first; });
  if (!names.empty())
    add_note(chart, fmt::format("Frequencies below the first line are not marked: {}.", names));
}

void tell_lines(ChartPage& chart, const std::vector<double>& distances,
                const SpectrumOptions& options) {
  if (distances.empty()) return;
  const auto [low, high] = std::minmax_element(distances.begin(), distances.end());
  std::string apart = desktop::pretty_quantity(*low, "Hz", 3);
  if (*high > 1.001 * *low) apart += " to " + desktop::pretty_quantity(*high, "Hz", 3);
  const char* over = options.scale == SpectrumScale::Relative  ? "1 is the maximum of the curve. "
                     : options.scale == SpectrumScale::Decibel ? "Level of the amplitude. "
                                                               : "";
  add_note(chart, fmt::format("{}{}, mean removed, line spacing {}.", over,
                              capital(signal::window_name(options.window)), apart));
}

void choose_frequency_axis(ChartPage& chart, const std::vector<double>& ends, double visible) {
  constexpr double kSqueezed = 8.0;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const double end : ends) {
    if (!(end > 0.0)) continue;
    least = std::min(least, end);
    most = std::max(most, end);
  }
  if (!(most > kSqueezed * least)) return;
  chart.log_x = true;
  add_note(chart, fmt::format("Logarithmic frequency axis: one curve has lines above {} % of the "
                              "maximum up to {}, another up to {}.",
                              desktop::pretty_number(100.0 * visible, 2),
                              desktop::pretty_quantity(least, "Hz", 3),
                              desktop::pretty_quantity(most, "Hz", 3)));
}

void first_view_of_spectra(ChartPage& chart, SpectrumScale scale) {
  if (chart.panels.empty() || chart.x.empty()) return;
  std::vector<std::vector<double>> relative;
  std::vector<double> ends;
  for (const ChartPanel& panel : chart.panels)
    for (const ChartCurve& curve : panel.curves) {
      if (curve.y.empty()) continue;
      relative.push_back(relative_amplitude(curve.y, scale));
      ends.push_back(last_above(chart.x, relative.back(), kVisible));
    }
  choose_frequency_axis(chart, ends, kVisible);
  if (scale == SpectrumScale::Decibel) return;  // everything is visible
  // A little beyond the last visible line, and at least ten lines.
  const double beside = chart.log_x ? 1.4 : 1.15;
  double shown = beside * chart.x[std::min<std::size_t>(10, chart.x.size() - 1)];
  for (const double end : ends) shown = std::max(shown, beside * end);
  for (const auto& mark : chart.marks)
    if (mark.label == "shaft" || mark.label == "rotation" || mark.label == "inner race")
      shown = std::max(shown, 1.5 * mark.x);
  chart.view_low = 0.0;
  chart.view_high = std::min(shown, chart.x.back());
  double beyond = 0.0, at = 0.0;
  for (const std::vector<double>& y : relative) {
    for (std::size_t k = 0; k < std::min(y.size(), chart.x.size()); ++k)
      if (chart.x[k] > chart.view_high && y[k] > beyond) beyond = y[k], at = chart.x[k];
  }
  if (beyond > 0.0)
    add_note(chart,
             fmt::format("Lines outside the initial view are at most {} % of the maximum (at {}).",
                         desktop::pretty_number(100.0 * beyond, 2),
                         desktop::pretty_quantity(at, "Hz", 3)));
}

}  // namespace adore::adrplot
