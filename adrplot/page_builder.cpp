#include "adrplot/page_builder.hpp"

#include "adrplot/domain_page.hpp"
#include "adrplot/known_values.hpp"
#include "adrplot/page_remarks.hpp"
#include "adrplot/sentence_words.hpp"
#include "adrplot/spectrum_page.hpp"
#include "base/counted.hpp"
#include "base/errors.hpp"
#include "desktop/axis_scale.hpp"
#include "results/channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace adore::adrplot {
namespace {

using desktop::ChartCurve;
using desktop::ChartPage;
using desktop::ChartPanel;
using results::SolFile;

std::vector<double> times(const SolFile& file) {
  std::vector<double> numbers;
  for (const auto& step : file.steps) numbers.push_back(step.time);
  return numbers;
}

/// Panels of a page with its curves over the stored steps. For a curve without values the reason is
/// stored in the panel, or in the note if other curves have values.
/// @return reasons for gaps, one sentence each
std::vector<std::string> add_panels(ChartPage& chart, const SolFile& file, const PageSpec& page,
                                    const RunFacts& facts) {
  const ValidColumns columns(file);
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> gaps;  // panels
  for (const auto& spec : page.panels) {
    ChartPanel panel{spec.title, columns.unit(spec.curves.front().column), {}, spec.wraps};
    std::string reason;
    for (const auto& curve : spec.curves) {
      ValidValues known = columns.values(curve.column);
      if (!known.why_none.empty() && !has_number(known.values)) {
        const bool flange = curve.column.starts_with("flange.");
        const std::string before = flange ? reason : std::string();
        std::string why = known.why_none;
        if (flange)
          why = missing_flange_reason(
              curve.column.substr(curve.column.find('.', std::string_view("flange.").size())),
              facts, file.part);
        else if (spec.curves.size() > 1)
          why = capitalize_first(curve.name) + ": " + lowercase_first(why);
        reason = before + (before.empty() ? "" : " ") + why;
        // Missing bodies are not listed in the legend.
        if (has_no_flange(curve.column, facts) &&
            std::any_of(spec.curves.begin(), spec.curves.end(), [&](const CurveSpec& other) {
              return has_number(columns.values(other.column).values);
            })) {
          add_note(chart, why);
          reason = before;
          continue;
        }
      }
      if (!known.why_gaps.empty() && has_number(known.values))
        gaps[{curve.name, known.why_gaps}].push_back(spec.title);
      panel.curves.push_back({curve.name, std::move(known.values), {}});
    }
    if (std::none_of(panel.curves.begin(), panel.curves.end(),
                     [](const ChartCurve& c) { return has_number(c.y); })) {
      const auto colon = reason.find(": ");
      panel.message = capitalize_first(
          spec.curves.size() > 1 && colon != std::string::npos ? reason.substr(colon + 2) : reason);
    } else {
      add_note(chart, reason);
    }
    chart.panels.push_back(std::move(panel));
  }
  // One sentence for curves of the same panels.
  std::map<std::pair<std::string, std::string>, std::string> curves;
  for (const auto& [what, panels] : gaps) {
    std::string names;
    for (const std::string& panel : panels)
      names += (names.empty() ? "" : " and ") + lowercase_first(panel);
    std::string& of = curves[{names, what.second}];
    // "the outer race", but "surface 1"
    const bool numbered =
        !what.first.empty() && std::isdigit(static_cast<unsigned char>(what.first.back())) != 0;
    const std::string name = (numbered ? "" : "the ") + what.first;
    if (!what.first.empty()) of += (of.empty() ? " of " : " and ") + name;
  }
  std::vector<std::string> out;
  for (const auto& [what, of] : curves) {
    const bool several = (what.first + of).find(" and ") != std::string::npos;
    out.push_back(capitalize_first(fmt::format("{}{} {} missing where there is {}.", what.first, of,
                                               several ? "are" : "is", what.second)));
  }
  return out;
}

/// Components of one force, moment or acceleration: values below 1e-7 of the largest are rounding
/// of sums and are not enlarged.
void limit_detail(ChartPage& chart) {
  constexpr double kDetail = 1e-7;
  for (ChartPanel& panel : chart.panels) {
    if (panel.unit != "N" && panel.unit != "N.m" && panel.unit != "m/s^2" && panel.unit != "lbf" &&
        panel.unit != "lbf.in" && panel.unit != "in/s^2")
      continue;
    double largest = 0.0;
    for (const ChartPanel& other : chart.panels)
      if (other.unit == panel.unit)
        for (const ChartCurve& curve : other.curves)
          for (const double v : curve.y)
            if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
    panel.least_span = std::max(panel.least_span, kDetail * largest);
  }
}

/// Between the least and the largest value; -infinity without any.
double spread(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : values)
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  return high - low;
}

/// Coordinates of one point: changes below 1e-7 of the largest one are rounding.
void limit_components(ChartPage& chart) {
  constexpr double kDetail = 1e-7;
  double largest = 0.0;
  for (const ChartPanel& panel : chart.panels)
    for (const ChartCurve& curve : panel.curves) largest = std::max(largest, spread(curve.y));
  for (ChartPanel& panel : chart.panels)
    panel.least_span = std::max(panel.least_span, kDetail * largest);
}

/// A land or flange that is not there has nothing between its steps, either.
bool any_but_zero(const MinMaxBand& band) {
  const auto some = [](double v) { return std::isfinite(v) && v != 0.0; };
  return std::any_of(band.low.begin(), band.low.end(), some) ||
         std::any_of(band.high.begin(), band.high.end(), some);
}

void add_history(ChartPage& chart, const SolFile& file, const PageSpec& page, Abscissa abscissa,
                 const PageContext& context) {
  set_abscissa(chart, file, abscissa);
  for (const std::string& gap : add_panels(chart, file, page, context.facts)) add_note(chart, gap);
  limit_detail(chart);
  note_special_values(chart, file, page, context.facts);
  note_speed_ratios(chart, file, page, context);
  for (std::size_t p = 0; p < page.panels.size(); ++p)
    for (const CurveSpec& spec : page.panels[p].curves) {
      // A missing flange has no curve.
      std::vector<ChartCurve>& drawn = chart.panels[p].curves;
      const auto curve = std::find_if(drawn.begin(), drawn.end(),
                                      [&](const ChartCurve& c) { return c.name == spec.name; });
      const auto band = context.bands.find(spec.column);
      if (curve == drawn.end() || band == context.bands.end() ||
          band->second.low.size() != file.steps.size())
        continue;
      if (!has_number(curve->y) && !any_but_zero(band->second)) continue;
      curve->low = band->second.low;
      curve->high = band->second.high;
      chart.band_note = file.every > 1
                            ? "Min–max bands: range of the values between the drawn steps."
                            : "Min–max bands: range of the values between the stored steps.";
    }
  const std::string aliased = aliasing_note(file, context);
  if (!aliased.empty())
    add_note(chart, aliased + "; the lines do not show this vibration.");
  else
    note_missed_peaks(chart, file, page, context);
}

void add_orbit(ChartPage& chart, const SolFile& file, const PageSpec& page, OrbitAxes pair,
               Abscissa abscissa, const PageContext& context) {
  const PanelSpec& across = page.panels.at(static_cast<std::size_t>(pair.across));
  const PanelSpec& up = page.panels.at(static_cast<std::size_t>(pair.up));
  const bool over_clearance = file.kind == results::SolKind::Cage;
  chart.equal_axes = true;
  ChartPage history;  // values shown for its points, as on other pages
  set_abscissa(history, file, abscissa);
  chart.along = std::move(history.x);
  chart.along_title = history.x_title;
  chart.along_unit = history.x_unit;
  // The unit circle shows the contact of a land without a second support; it has no meaning for the
  // axial coordinate.
  const ValidColumns columns(file);
  std::string suffix = " position";
  if (over_clearance) {
    const OrbitScale scale = orbit_scale(file, columns, context.facts);
    suffix = " / " + orbit_divisor_text(scale);
    add_note(chart, orbit_note(scale));
    if (scale.of == results::CageLengthScale::Of::GuideLands && pair.across != 0 && pair.up != 0)
      chart.guide_radius = 1.0;
  }
  chart.x_title = across.title + suffix;
  ChartPanel panel{up.title + suffix, columns.unit(up.curves.front().column), {}, false};
  panel.curves.push_back({"mass center", columns.values(up.curves.front().column).values,
                          columns.values(across.curves.front().column).values});
  // A motion smaller than an atom or a billionth of a clearance is not a path.
  const ChartCurve& path = panel.curves.front();
  const double least = panel.unit.empty() ? 1e-9 : desktop::min_axis_span(panel.unit);
  const double width = spread(path.x), height = spread(path.y);
  if (width >= 0.0 && height >= 0.0 && std::max(width, height) < least)
    add_note(chart, "The mass center does not move in this plane.");
  chart.panels.push_back(std::move(panel));
}

void add_spectrum(ChartPage& chart, const SolFile& file, const PageSpec& page,
                  const SpectrumOptions& options, const PageContext& context,
                  Domain domain = Domain::Spectrum) {
  add_panels(chart, file, page, context.facts);
  limit_detail(chart);
  if (page.kind == PageKind::Spectrum) limit_components(chart);
  if (show_spectra(chart, motion_of(file, context), options, domain))
    put_aliasing_note_first(chart, file, context);
}

}  // namespace

void check_page_number(const std::filesystem::path& file, int number, std::size_t count) {
  if (number < 1 || number > static_cast<int>(count))
    throw InputError(
        fmt::format("{} has no page {}; its pages are 1 to {}", file.string(), number, count));
}

std::vector<std::string> auxiliary_columns(results::SolKind kind, const PageSpec& page) {
  if (kind == results::SolKind::Cage && page.kind == PageKind::Orbit)
    return {"cage.radial_position", "cage.y_over_clearance", "cage.z_over_clearance",
            "cage.land1_force", "cage.land2_force"};
  if (kind == results::SolKind::Race && !page.panels.empty() &&
      page.panels.front().curves.front().column.starts_with("race.applied_"))
    return {"race.x", "race.y", "race.z", "race.theta", "race.phi", "race.angular_velocity"};
  return {};
}

RunMotion motion_of(const SolFile& file, const PageContext& context) {
  RunMotion out{times(file), accumulated_revolutions(file), context.marks, "bearing rotation",
                has_reversals(file)};
  if (file.path.has_filename()) out.source += " in " + file.path.filename().string();
  // From the file alone that of its rotation, which is one race's against the other.
  if (out.marks.empty()) out.marks.push_back({"rotation", out.times, out.turns});
  return out;
}

ChartPage build_page(const SolFile& file, const std::vector<PageSpec>& pages, int number,
                     const PageOptions& options, const PageContext& context) {
  check_page_number(file.path, number, pages.size());
  const PageSpec& page = pages[static_cast<std::size_t>(number - 1)];
  ChartPage chart;
  chart.title = page.title;
  chart.note = page.note;
  chart.about = subject(file.kind, file.header);
  chart.subtitle = fmt::format("{}   ·   {}   ·   {}   ·   page {} of {}",
                               file.header.run_id.empty() ? "(no run name)" : file.header.run_id,
                               chart.about, file.path.filename().string(), number, pages.size());
  if (file.steps.empty()) {
    chart.note = "The file contains no complete step" +
                 (file.note.empty() ? std::string(".") : ": " + file.note + ".");
    return chart;
  }
  switch (page.kind) {
    case PageKind::History:
      if (options.domain == Domain::History) {
        add_history(chart, file, page, options.abscissa, context);
      } else if (options.domain == Domain::Spectrogram) {
        add_panels(chart, file, page, context.facts);
        limit_detail(chart);
        show_domain(chart, motion_of(file, context), options);
        put_aliasing_note_first(chart, file, context);
      } else {
        add_spectrum(chart, file, page, options.spectrum, context, options.domain);
      }
      break;
    case PageKind::Orbit:
      add_orbit(chart, file, page, options.orbit, options.abscissa, context);
      break;
    case PageKind::Spectrum:
      add_spectrum(chart, file, page, options.spectrum, context);
      break;
    case PageKind::Chart:
      break;  // pages of step files are of the kinds above
  }
  return chart;
}

}  // namespace adore::adrplot
