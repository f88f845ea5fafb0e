#include "adrplot/spectrum_page.hpp"

#include "adrplot/known_values.hpp"
#include "adrplot/sentence_words.hpp"
#include "adrplot/spectrum_source.hpp"
#include "adrplot/vibration_values.hpp"
#include "base/counted.hpp"
#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

namespace adore::adrplot {
namespace {

using desktop::ChartCurve;
using desktop::ChartPage;
using desktop::ChartPanel;

constexpr std::string_view kHere = "No vibration: ";
constexpr auto kStill = "No vibration: the value is constant.";
constexpr auto kAllStill = "No vibration: all values of this page are constant.";
constexpr auto kRounding = "No vibration: the value changes only by rounding errors.";
constexpr auto kNoneInBand = "No vibration: the envelope of the band is constant.";

std::string name_of(const ChartPanel& panel, const ChartCurve& curve) {
  return panel.title + (curve.name.empty() ? "" : ", " + curve.name);
}

/// Why a curve has no spectrum.
struct Reason {
  std::string curve, why;
};

/// Without "here": the curve, or the panel for all curves.
std::string named(const std::string& name, std::string why) {
  if (!name.empty() && why.starts_with(kHere)) why.erase(0, kHere.size());
  return capitalize_first(name.empty() ? why : name + ": " + why);
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
    same->panels += " and " + lowercase_first(panel);
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
  if (!reasons.empty() && same) panel.message = capitalize_first(reasons.front().why);
  if (same) return;
  panel.message.clear();
  for (const Reason& reason : reasons) {
    std::string why = reason.why;
    if (&reason != &reasons.back() && why.ends_with(kNoSpectrum))  // the last one has it
      why.replace(why.size() - kNoSpectrum.size(), kNoSpectrum.size(), ".");
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

void add_note(ChartPage& chart, const std::string& text) {
  if (text.empty() || chart.note.find(text) != std::string::npos) return;
  chart.note += (chart.note.empty() ? "" : " ") + text;
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

/// Of a curve: its values with bridged gaps.
struct StoredCurve {
  ChartPanel* panel = nullptr;
  ChartCurve* curve = nullptr;
  BridgedValues bridged;
  bool still = false;
};

/// Takes the values of all curves, for which there will be spectra.
static std::vector<StoredCurve> take_values(ChartPage& chart, const std::vector<double>& t,
                                            const SpectrumOptions& options) {
  std::vector<StoredCurve> out;
  for (ChartPanel& panel : chart.panels)
    for (ChartCurve& curve : panel.curves) {
      const std::vector<double> stored = std::move(curve.y);
      curve.low.clear(), curve.high.clear();
      curve.y.clear();
      if (!has_number(stored)) continue;  // the panel has its reason
      out.push_back({&panel, &curve, bridge_gaps(t, stored, options.window)});
      const std::vector<double>& values = out.back().bridged.values;
      out.back().still = !values.empty() && is_only_rounding(values, panel.unit, panel.least_span);
    }
  return out;
}

/// Lines above are not valid.
static void cut_spectrum(signal::Spectrum& spectrum, double highest) {
  constexpr double kRounding = 1.0 + 1e-9;
  const auto end =
      std::upper_bound(spectrum.frequency.begin(), spectrum.frequency.end(), highest * kRounding);
  const auto count = static_cast<std::size_t>(end - spectrum.frequency.begin());
  spectrum.frequency.resize(count);
  spectrum.amplitude.resize(count);
}

void to_spectra(ChartPage& chart, const RunMotion& motion, const SpectrumOptions& options,
                Domain domain) {
  const std::vector<double>& t = motion.times;
  const SpectrumScale scale = resolved_scale(options.scale, SpectrumScale::Units);
  SpectrumSource source(motion, options, domain);
  std::vector<StoredCurve> stored = take_values(chart, t, options);
  for (const StoredCurve& one : stored)
    if (one.bridged.why_none.empty() && !one.still)
      source.consider_band(stored.size() > 1 ? name_of(*one.panel, *one.curve) : std::string(),
                           one.bridged.values);
  std::vector<double> frequency;
  std::vector<Aside> asides;
  std::vector<std::string> drifting;
  std::map<const ChartPanel*, std::vector<Reason>> reasons;  // of the curves without a spectrum
  std::size_t drawn = 0;
  for (StoredCurve& one : stored) {
    ChartPanel& panel = *one.panel;
    ChartCurve& curve = *one.curve;
    const auto none = [&](const std::string& why) { reasons[&panel].push_back({curve.name, why}); };
    if (!one.bridged.why_none.empty()) {
      none(one.bridged.why_none);
      continue;
    }
    const SpectrumSamples of = source.samples_of(one.bridged.values, one.still);
    if (!of.why_none.empty()) {
      none(of.why_none);
      continue;
    }
    const signal::Samples& samples = of.samples;
    signal::Spectrum spectrum =
        signal::amplitude_spectrum(samples.values, samples.step, options.window);
    cut_spectrum(spectrum, of.highest);
    if (domain != Domain::Envelope || !one.still) frequency = spectrum.frequency;
    const bool flat = std::all_of(spectrum.amplitude.begin(), spectrum.amplitude.end(),
                                  [](double a) { return a == 0.0; });
    if (flat || one.still) {
      none(flat || one_value(one.bridged.values) ? kStill : kRounding);
      continue;
    }
    if (domain == Domain::Envelope &&
        is_only_rounding(samples.values, panel.unit, panel.least_span)) {
      none(kNoneInBand);
      continue;
    }
    if (domain != Domain::Envelope && first_line_is_drift(spectrum, samples, options.window))
      drifting.push_back(name_of(panel, curve));
    ++drawn;
    scale_spectrum(spectrum, scale);
    curve.y = std::move(spectrum.amplitude);
    add_note(chart, sampling_note(samples, t.size()));  // of the drawn curves
    if (!one.bridged.told.empty()) add_aside(asides, {curve.name, one.bridged.told}, panel.title);
  }
  for (ChartPanel& panel : chart.panels) {
    tell_reasons(panel, reasons[&panel], asides);
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
  if (drawn > 0) add_note(chart, source.note());
  tell_drift(chart, drifting, drawn);
  // One sentence for panels with the same remark.
  for (const Aside& aside : asides)
    add_note(chart,
             named(aside.panels + (aside.reason.curve.empty() ? "" : ", ") + aside.reason.curve,
                   aside.reason.why));
  if (chart.title.find("pectrum") == std::string::npos)
    chart.title = without_colon(chart.title) + ": " + spectrum_title(domain);
  chart.x = std::move(frequency);
  chart.x_title = "Frequency";
  chart.x_unit = source.unit();
  chart.marks = source.marks();
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
  if (chart.x.empty() || chart.x_title != "Frequency") return;
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

void note_spectrum_lines(ChartPage& chart, const std::vector<double>& distances,
                         const SpectrumOptions& options) {
  if (distances.empty()) return;
  const auto [low, high] = std::minmax_element(distances.begin(), distances.end());
  std::string apart = desktop::pretty_quantity(*low, chart.x_unit, 3);
  if (*high > 1.001 * *low) apart += " to " + desktop::pretty_quantity(*high, chart.x_unit, 3);
  const char* over = options.scale == SpectrumScale::Relative
                         ? "Amplitude 1 is the maximum of the curve. "
                     : options.scale == SpectrumScale::Decibel ? "Level of the amplitude. "
                                                               : "";
  add_note(chart, fmt::format("{}{}, mean removed, line spacing {}.", over,
                              capitalize_first(signal::window_name(options.window)), apart));
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
  add_note(chart, fmt::format("Logarithmic frequency axis: lines above {} % of the maximum extend "
                              "to {} in one curve and to {} in another.",
                              desktop::pretty_number(100.0 * visible, 2),
                              desktop::pretty_quantity(least, chart.x_unit, 3),
                              desktop::pretty_quantity(most, chart.x_unit, 3)));
}

void set_initial_spectrum_view(ChartPage& chart, SpectrumScale scale, Domain domain) {
  if (chart.panels.empty() || chart.x.empty()) return;
  std::vector<std::vector<double>> relative;
  std::vector<double> ends;
  for (const ChartPanel& panel : chart.panels)
    for (const ChartCurve& curve : panel.curves) {
      if (curve.y.empty()) continue;
      relative.push_back(relative_amplitude(curve.y, scale));
      ends.push_back(highest_frequency_above(chart.x, relative.back(), kVisible));
    }
  choose_frequency_axis(chart, ends, kVisible);
  if (scale == SpectrumScale::Decibel) return;  // everything is visible
  // A little beyond the last visible line, and at least ten lines.
  const double beside = chart.log_x ? 1.4 : 1.15;
  double shown = beside * chart.x[std::min<std::size_t>(10, chart.x.size() - 1)];
  for (const double end : ends) shown = std::max(shown, beside * end);
  const auto fundamental = [](const std::string& label) {
    return std::isdigit(static_cast<unsigned char>(label.front())) == 0;
  };
  for (const auto& mark : chart.marks)
    if (domain != Domain::Spectrum && fundamental(mark.label))
      shown = std::max(shown, 1.05 * mark.x);
    else if (mark.label == "shaft" || mark.label == "rotation" || mark.label == "inner race")
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
             fmt::format("Highest line outside the initial view: {} % of the maximum, at {}.",
                         desktop::pretty_number(100.0 * beyond, 2),
                         desktop::pretty_quantity(at, chart.x_unit, 3)));
}

}  // namespace adore::adrplot
