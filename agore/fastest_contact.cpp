#include "agore/fastest_contact.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/stored_rate.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::agore {

double fastest_frequency(const Animation& animation) {
  const std::filesystem::path file = animation.file.path.parent_path() / "RUN.json";
  try {
    const nlohmann::json run = parse_json(read_text_file(file), file.string());
    if (run.at("run") != animation.file.run_id) return 0.0;
    return run.at("plan").at("estimates").at("fastest_frequency_Hz").get<double>();
  } catch (const InputError&) {
    return 0.0;  // none, or not ours
  } catch (const nlohmann::json::exception&) {
    return 0.0;  // of a run without it
  }
}

void note_missed_peaks(desktop::ChartPage& page, const Animation& animation) {
  /// A line that moves, and has no extremes between its values.
  const auto bare = [](const desktop::ChartPanel& panel, const desktop::ChartCurve& curve) {
    desktop::Extent extent;
    for (const double v : curve.y) extent.include(v);
    return curve.low.empty() && !extent.empty() &&
           extent.high - extent.low > 1e-3 * desktop::min_axis_span(panel.unit);
  };
  for (const desktop::ChartPanel& panel : page.panels)
    if (std::any_of(panel.curves.begin(), panel.curves.end(),
                    [&](const desktop::ChartCurve& curve) { return bare(panel, curve); })) {
      // Shorter than the note of AdrPlot: it has 350 pixels next to the current values.
      const double frequency = fastest_frequency(animation);
      const double values = desktop::values_per_period(page.x, frequency);
      if (values > 0.0 && values < desktop::kTrueShape)
        page.note = fmt::format("Only {} per period at {}: peaks are missing.",
                                counted(fmt::format("{:.2g}", values), "stored step"),
                                desktop::pretty_quantity(frequency, "Hz", 3));
      return;
    }
}

}  // namespace adore::agore
