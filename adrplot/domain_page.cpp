#include "adrplot/domain_page.hpp"

#include "adrplot/spectrogram_page.hpp"
#include "adrplot/spectrum_page.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::adrplot {

bool show_spectra(desktop::ChartPage& chart, const RunMotion& motion, bool oscillates,
                  const SpectrumOptions& options) {
  chart.marks = mean_marks(motion.marks);
  to_spectra(chart, motion.times, options);
  const bool drawn = std::any_of(chart.panels.begin(), chart.panels.end(), [](const auto& panel) {
    return std::any_of(panel.curves.begin(), panel.curves.end(),
                       [](const desktop::ChartCurve& curve) { return !curve.y.empty(); });
  });
  if (!drawn) return false;  // notes on lines are false without lines
  const std::vector<double>& turns = motion.turns;
  if (!chart.marks.empty() && oscillates) {
    chart.marks.clear();
    add_note(chart, "The shaft oscillates, so there are no frequency marks.");
  }
  if (!chart.marks.empty() && !turns.empty() && turns.back() > turns.front() &&
      !keeps_speed(motion.times, turns)) {
    const auto [low, high] = speed_range(motion.times, turns);
    add_note(chart,
             fmt::format("The shaft speed varies from {} to {}. The marks are for the mean speed.",
                         rpm_text(low), rpm_text(high)));
  }
  tell_lines(chart, {chart.x.front()}, options);
  first_view_of_spectra(chart, options.scale);
  drop_low_marks(chart);
  return true;
}

void show_domain(desktop::ChartPage& chart, const RunMotion& motion, bool oscillates,
                 const PageOptions& options) {
  if (options.domain == Domain::Spectrum) show_spectra(chart, motion, oscillates, options.spectrum);
  if (options.domain != Domain::Spectrogram) return;
  to_spectrogram(chart, motion, options.spectrum, options.spectrogram_of);
  drop_low_marks(chart);
}

}  // namespace adore::adrplot
