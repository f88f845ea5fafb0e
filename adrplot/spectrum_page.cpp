#include "adrplot/spectrum_page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace adore::adrplot {
namespace {

using desktop::ChartCurve;
using desktop::ChartPage;
using desktop::ChartPanel;

bool any_value(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// Frequency above which no coordinate exceeds 1 % of its largest amplitude: the first view ends a
/// little beyond it.
double interesting_frequency(const std::vector<double>& frequency,
                             const std::vector<ChartPanel>& panels) {
  constexpr double kVisible = 0.01;
  std::size_t last = 0;
  for (const auto& panel : panels)
    for (std::size_t k = 0; k < frequency.size(); ++k)
      if (panel.curves.front().y[k] > kVisible) last = std::max(last, k);
  return std::min(
      frequency.back(),
      1.15 *
          frequency[std::max<std::size_t>(last, std::min<std::size_t>(10, frequency.size() - 1))]);
}

}  // namespace

void add_note(ChartPage& chart, const std::string& text) {
  if (text.empty() || chart.note.find(text) != std::string::npos) return;
  chart.note += (chart.note.empty() ? "" : " ") + text;
}

void to_spectra(ChartPage& chart, const std::vector<double>& t, const SpectrumOptions& options) {
  std::vector<double> frequency;
  bool any = false;
  for (ChartPanel& panel : chart.panels) {
    for (ChartCurve& curve : panel.curves) {
      const bool empty = !any_value(curve.y);
      const Samples samples = equal_samples(t, curve.y);
      curve.low.clear(), curve.high.clear();
      curve.y.clear();
      if (!empty) add_note(chart, samples.note);
      if (samples.values.empty()) {
        if (panel.message.empty()) panel.message = samples.note;
        continue;
      }
      Spectrum spectrum = amplitude_spectrum(samples.values, samples.step, options.window);
      if (std::all_of(spectrum.amplitude.begin(), spectrum.amplitude.end(),
                      [](double a) { return a == 0.0; })) {
        panel.message = "Nothing vibrates here: the value does not change.";
        frequency = std::move(spectrum.frequency);
        any = true;
        continue;
      }
      scale_spectrum(spectrum, options.scale);
      frequency = std::move(spectrum.frequency);
      curve.y = std::move(spectrum.amplitude);
      any = true;
    }
    panel.wraps = false;
    if (options.scale != SpectrumScale::Units)
      panel.unit = options.scale == SpectrumScale::Decibel ? "dB" : "";
  }
  if (chart.title.find("pectrum") == std::string::npos) chart.title += ": amplitude spectrum";
  chart.x = std::move(frequency);
  chart.x_title = "Frequency";
  chart.x_unit = "Hz";
  if (!any) chart.panels.clear();
}

void first_view_of_spectra(ChartPage& chart, SpectrumScale scale) {
  if (chart.panels.empty() || scale == SpectrumScale::Decibel) return;
  std::vector<ChartPanel> relative;
  for (const ChartPanel& panel : chart.panels)
    for (const ChartCurve& curve : panel.curves) {
      if (curve.y.empty()) continue;
      ChartPanel one{"", "", {curve}, false};
      double largest = 0.0;
      for (const double a : curve.y)
        if (a > largest) largest = a;  // beside missing values
      for (double& a : one.curves.front().y) a = largest > 0.0 ? a / largest : 0.0;
      relative.push_back(std::move(one));
    }
  double shown = interesting_frequency(chart.x, relative);
  for (const auto& mark : chart.marks)
    if (mark.label == "shaft") shown = std::max(shown, 1.5 * mark.x);
  chart.view_low = 0.0;
  chart.view_high = std::min(shown, chart.x.back());
}

}  // namespace adore::adrplot
