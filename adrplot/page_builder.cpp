#include "adrplot/page_builder.hpp"

#include "adrplot/spectrum.hpp"
#include "base/errors.hpp"
#include "results/channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::adrplot {
namespace {

using desktop::ChartCurve;
using desktop::ChartPage;
using desktop::ChartPanel;
using results::SolFile;

/// The columns of one file, found by id: numbers and unit. What the file does not hold is missing
/// at every step.
class FileColumns {
 public:
  explicit FileColumns(const SolFile& file)
      : file_(file), columns_(results::sol_columns(file.header)) {}

  [[nodiscard]] std::vector<double> numbers(const std::string& id) const {
    const std::size_t index = file_.place(find(id));
    std::vector<double> out;
    out.reserve(file_.steps.size());
    for (const auto& step : file_.steps)
      out.push_back(index < step.values.size() ? step.values[index]
                                               : std::numeric_limits<double>::quiet_NaN());
    return out;
  }
  [[nodiscard]] std::string unit(const std::string& id) const {
    const std::size_t index = find(id);
    return index < columns_.size() ? results::unit_of_column(file_, columns_[index]) : "";
  }

 private:
  [[nodiscard]] std::size_t find(const std::string& id) const {
    const auto found = std::find_if(columns_.begin(), columns_.end(),
                                    [&](const auto& column) { return column.id == id; });
    return static_cast<std::size_t>(found - columns_.begin());
  }

  const SolFile& file_;
  std::vector<results::SolColumn> columns_;
};

std::vector<double> times(const SolFile& file) {
  std::vector<double> numbers;
  for (const auto& step : file.steps) numbers.push_back(step.time);
  return numbers;
}

void add_history(ChartPage& chart, const SolFile& file, const PageSpec& page, Abscissa abscissa) {
  if (abscissa == Abscissa::Time) {
    chart.x_title = "Time";
    chart.x_unit = "s";
    chart.x = times(file);
  } else {
    chart.x_title = "Bearing rotation";
    chart.x_unit = "rev";
    for (const auto& step : file.steps) chart.x.push_back(step.revolutions);
  }
  const FileColumns columns(file);
  for (const auto& spec : page.panels) {
    ChartPanel panel{spec.title, columns.unit(spec.curves.front().column), {}, spec.wraps};
    for (const auto& curve : spec.curves)
      panel.curves.push_back({curve.name, columns.numbers(curve.column), {}});
    chart.panels.push_back(std::move(panel));
  }
}

void add_orbit(ChartPage& chart, const SolFile& file, const PageSpec& page, OrbitPair pair) {
  const PanelSpec& across = page.panels.at(static_cast<std::size_t>(pair.across));
  const PanelSpec& up = page.panels.at(static_cast<std::size_t>(pair.up));
  const bool over_clearance = file.kind == results::SolKind::Cage;
  const std::string suffix = over_clearance ? " / clearance" : " position";
  chart.equal_axes = true;
  // The unit circle is where a land without a second support touches; it means nothing against the
  // axial coordinate.
  if (over_clearance && pair.across != 0 && pair.up != 0) chart.guide_radius = 1.0;
  chart.x_title = across.title + suffix;
  const FileColumns columns(file);
  ChartPanel panel{up.title + suffix, columns.unit(up.curves.front().column), {}, false};
  panel.curves.push_back({"mass centre", columns.numbers(up.curves.front().column),
                          columns.numbers(across.curves.front().column)});
  chart.panels.push_back(std::move(panel));
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

void add_spectrum(ChartPage& chart, const SolFile& file, const PageSpec& page) {
  const std::vector<double> t = times(file);
  const TimeStep step = common_time_step(t);
  if (!step.reason.empty()) {
    chart.note = step.reason;
    return;
  }
  chart.x_title = "Frequency";
  chart.x_unit = "Hz";
  const FileColumns columns(file);
  // y and z carry the whirl, so they come first; x is the third panel.
  for (const std::size_t coordinate : {1U, 2U, 0U}) {
    const PanelSpec& spec = page.panels.at(coordinate);
    const std::vector<double> samples = columns.numbers(spec.curves.front().column);
    if (std::any_of(samples.begin(), samples.end(), [](double s) { return !std::isfinite(s); })) {
      chart.panels.clear();
      chart.note =
          "The file shows stars instead of some mass centre positions, so there is no frequency "
          "spectrum.";
      return;
    }
    Spectrum spectrum = relative_spectrum(samples, step.step);
    chart.x = spectrum.frequency;
    chart.panels.push_back(
        {"Amplitude " + spec.title, "", {{"", std::move(spectrum.amplitude), {}}}, false});
  }
  const double turns = file.steps.back().revolutions - file.steps.front().revolutions;
  const double shaft = std::abs(turns) / (t.back() - t.front());
  if (shaft > 0.0) chart.marks.push_back({shaft, "shaft"});
  chart.view_low = 0.0;
  chart.view_high = std::max(interesting_frequency(chart.x, chart.panels),
                             1.5 * std::min(shaft, chart.x.back() / 1.5));
}

}  // namespace

void check_page_number(const std::filesystem::path& file, int number, std::size_t count) {
  if (number < 1 || number > static_cast<int>(count))
    throw InputError(
        fmt::format("{} has no page {}; its pages are 1 to {}", file.string(), number, count));
}

ChartPage build_page(const SolFile& file, const std::vector<PageSpec>& pages, int number,
                     const PageOptions& options) {
  check_page_number(file.path, number, pages.size());
  const PageSpec& page = pages[static_cast<std::size_t>(number - 1)];
  ChartPage chart;
  chart.title = page.title;
  chart.note = page.note;
  chart.subtitle = fmt::format("{}   ·   {}   ·   {}   ·   page {} of {}",
                               file.header.run_id.empty() ? "(no run name)" : file.header.run_id,
                               subject(file.kind, file.header), file.path.filename().string(),
                               number, pages.size());
  if (file.steps.empty()) {
    chart.note = "The file holds no complete step" +
                 (file.note.empty() ? std::string(".") : ": " + file.note + ".");
    return chart;
  }
  switch (page.kind) {
    case PageKind::History:
      add_history(chart, file, page, options.abscissa);
      break;
    case PageKind::Orbit:
      add_orbit(chart, file, page, options.orbit);
      break;
    case PageKind::Spectrum:
      add_spectrum(chart, file, page);
      break;
    case PageKind::Chart:
      break;  // pages of step files are of the kinds above
  }
  return chart;
}

}  // namespace adore::adrplot
