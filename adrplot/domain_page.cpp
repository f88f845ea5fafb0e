#include "adrplot/domain_page.hpp"

#include "adrplot/spectrogram_page.hpp"
#include "adrplot/spectrum_page.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::adrplot {

bool show_spectra(desktop::ChartPage& chart, const RunMotion& motion,
                  const SpectrumOptions& options, Domain domain) {
  to_spectra(chart, motion, options, domain);
  const bool drawn = std::any_of(chart.panels.begin(), chart.panels.end(), [](const auto& panel) {
    return std::any_of(panel.curves.begin(), panel.curves.end(),
                       [](const desktop::ChartCurve& curve) { return !curve.y.empty(); });
  });
  if (!drawn) return false;  // notes on lines are false without lines
  const std::vector<double>& turns = motion.turns;
  if (!chart.marks.empty() && motion.oscillates) {
    chart.marks.clear();
    add_note(chart, "The shaft oscillates, so there are no frequency marks.");
  }
  if (chart.x_unit == "Hz" && !chart.marks.empty() && !turns.empty() &&
      turns.back() > turns.front() && !has_constant_speed(motion.times, turns)) {
    const auto [low, high] = speed_range(motion.times, turns);
    add_note(chart,
             fmt::format("The shaft speed varies from {} to {}. The marks are for the mean speed.",
                         rpm_text(low), rpm_text(high)));
  }
  note_spectrum_lines(chart, {chart.x.front()}, options);
  set_initial_spectrum_view(chart, options.scale, domain);
  drop_low_marks(chart);
  return true;
}

void show_domain(desktop::ChartPage& chart, const RunMotion& motion, const PageOptions& options) {
  if (options.domain == Domain::History) return;
  if (options.domain != Domain::Spectrogram) {
    show_spectra(chart, motion, options.spectrum, options.domain);
    return;
  }
  to_spectrogram(chart, motion, options.spectrum, options.spectrogram_of);
  drop_low_marks(chart);
}

}  // namespace adore::adrplot
