#include "adrplot/own_chart.hpp"

#include "adrplot/collected_curves.hpp"
#include "adrplot/spectrogram_page.hpp"
#include "adrplot/spectrum_page.hpp"
#include "base/errors.hpp"
#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace adore::adrplot {
namespace {

/// Which of the increasing points `where` are stored points of a curve.
std::vector<bool> own_places(const CollectedCurve& curve, const std::vector<double>& where) {
  std::vector<bool> out(where.size(), false);
  std::size_t at = 0;
  for (std::size_t i = 0; i < where.size(); ++i) {
    while (at < curve.x.size() && curve.x[at] < where[i]) ++at;
    out[i] = at < curve.x.size() && curve.x[at] == where[i] && (curve.own.empty() || curve.own[at]);
  }
  return out;
}

/// Extremes since the previous value at other points: those of the stored step that contains the
/// point.
std::vector<double> extremes_at(const std::vector<double>& x, const std::vector<double>& extremes,
                                const std::vector<double>& where) {
  std::vector<double> out;
  out.reserve(where.size());
  std::size_t at = 0;
  for (const double place : where) {
    while (at < x.size() && x[at] < place) ++at;
    const bool inside = at < x.size() && place >= x.front();
    out.push_back(inside ? extremes[at] : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

bool of_one_run(const std::vector<CurvePick>& picks) {
  return std::all_of(picks.begin(), picks.end(), [&](const CurvePick& pick) {
    return run_folder(pick.file->path) == run_folder(picks.front().file->path);
  });
}

std::vector<double> all_places(const std::vector<CollectedCurve>& curves) {
  std::vector<double> x;
  for (const CollectedCurve& one : curves) x.insert(x.end(), one.x.begin(), one.x.end());
  std::sort(x.begin(), x.end());
  x.erase(std::unique(x.begin(), x.end()), x.end());
  return x;
}

/// Smallest and largest distance of points.
std::pair<double, double> steps_of(const std::vector<double>& x) {
  std::pair<double, double> out{std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t i = 1; i < x.size(); ++i) {
    out.first = std::min(out.first, x[i] - x[i - 1]);
    out.second = std::max(out.second, x[i] - x[i - 1]);
  }
  return out;
}

/// Points for the spectrum of a difference: those of both runs if equal, else equal steps as long
/// as the longest step of either. Finer linear interpolation would add artificial frequencies.
std::vector<double> places_for_spectrum(const CollectedCurve& a, const CollectedCurve& b,
                                        desktop::ChartPage& page) {
  const std::vector<double> both = all_places({a, b});
  if (a.x == b.x || a.x.empty() || b.x.empty()) return both;
  const double from = std::max(a.x.front(), b.x.front()), to = std::min(a.x.back(), b.x.back());
  const auto of_a = steps_of(a.x), of_b = steps_of(b.x);
  const double step = std::max(of_a.second, of_b.second);
  if (!(to > from) || !(step > 0.0)) return both;
  std::vector<double> out;
  const auto count = static_cast<std::size_t>((to - from) / step);
  for (std::size_t i = 0; i <= count; ++i)
    out.push_back(std::min(to, from + step * static_cast<double>(i)));
  const auto seconds = [](double value) { return desktop::pretty_quantity(value, "s", 3); };
  add_note(page,
           fmt::format("Resampled: the steps of the curves are {} to {} and {} to {}. Both curves "
                       "were interpolated linearly every {}, so the spectrum ends at {}.",
                       seconds(of_a.first), seconds(of_a.second), seconds(of_b.first),
                       seconds(of_b.second), seconds(step),
                       desktop::pretty_quantity(0.5 / step, "Hz", 3)));
  return out;
}

/// Differences of all other curves to the first one, at the points of both.
std::vector<CollectedCurve> differences(const std::vector<CollectedCurve>& taken, bool for_spectra,
                                        desktop::ChartPage& page) {
  const CollectedCurve& first = taken.front();
  const std::array<bool, 3> apart = distinguishing_names(taken);
  std::vector<CollectedCurve> out;
  for (std::size_t i = 1; i < taken.size(); ++i) {
    CollectedCurve one = taken[i];
    if (one.unit != first.unit)
      throw InputError(fmt::format("{} is in {}, but {} is in {}; select curves with the same unit",
                                   one.name, one.unit.empty() ? "no unit" : one.unit, first.name,
                                   first.unit.empty() ? "no unit" : first.unit));
    one.x =
        for_spectra ? places_for_spectrum(first, taken[i], page) : all_places({first, taken[i]});
    one.y = interpolated_values(taken[i].x, taken[i].y, one.x);
    const std::vector<double> less = interpolated_values(first.x, first.y, one.x);
    for (std::size_t k = 0; k < one.y.size(); ++k) one.y[k] -= less[k];
    one.own = own_places(taken[i], one.x);
    const std::vector<bool> of_first = own_places(first, one.x);
    for (std::size_t k = 0; k < one.own.size(); ++k) one.own[k] = one.own[k] && of_first[k];
    one.title = "Difference";
    for (std::size_t k = 0; k < one.names.size(); ++k)
      if (one.names.at(k) != first.names.at(k)) one.names.at(k) += " minus " + first.names.at(k);
    one.name = joined_names(one.names, {true, true, true});
    one.brief = "Difference: " + joined_names(one.names, apart);
    if (!one.low.empty() || !first.low.empty())
      add_note(page, "Differences have no min–max bands.");
    one.low.clear(), one.high.clear();
    one.wraps = false;
    out.push_back(std::move(one));
  }
  return out;
}

/// A curve from its first value to its last: a shorter run has no later values.
void trim(CollectedCurve& one) {
  const auto known = [](double v) { return std::isfinite(v); };
  const auto first = std::find_if(one.y.begin(), one.y.end(), known) - one.y.begin();
  const auto last = one.y.rend() - std::find_if(one.y.rbegin(), one.y.rend(), known);
  if (last <= first) return;  // no value at all
  one.x = {one.x.begin() + first, one.x.begin() + last};
  one.y = {one.y.begin() + first, one.y.begin() + last};
  if (!one.own.empty()) one.own = {one.own.begin() + first, one.own.begin() + last};
  if (!one.low.empty()) {
    one.low = {one.low.begin() + first, one.low.begin() + last};
    one.high = {one.high.begin() + first, one.high.begin() + last};
  }
}

/// Each curve over time becomes its spectrum.
/// @param motion_of the run of a curve, by its number, after trim()
void to_frequency(std::vector<CollectedCurve>& curves, desktop::ChartPage& page,
                  const PageOptions& options,
                  const std::function<RunMotion(std::size_t)>& motion_of) {
  std::vector<std::pair<std::string, std::string>> told;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    CollectedCurve& one = curves[i];
    trim(one);
    desktop::ChartPage alone;
    alone.x = one.x;
    alone.panels = {{one.title, one.unit, {{"", one.y, {}}}, one.wraps}};
    to_spectra(alone, motion_of(i), options.spectrum, options.domain);
    page.x_unit = alone.x_unit;
    const bool has = !alone.panels.empty() && !alone.panels[0].curves[0].y.empty();
    if (!has && !alone.panels.empty()) add_note(alone, alone.panels[0].message);
    told.emplace_back(one.name, alone.note);
    one.wraps = false;
    one.own.clear();  // the lines of a spectrum are stored points
    one.low.clear(), one.high.clear();
    one.x = has ? alone.x : std::vector<double>();
    one.y = has ? alone.panels[0].curves[0].y : std::vector<double>();
    if (has) one.unit = alone.panels[0].unit;
  }
  const bool same = std::all_of(told.begin(), told.end(),
                                [&](const auto& one) { return one.second == told.front().second; });
  for (const auto& [name, note] : told)
    if (!note.empty()) add_note(page, same ? note : name + ": " + note);
  std::erase_if(curves, [](const CollectedCurve& one) { return one.x.empty(); });
  std::vector<double> distances;
  for (const CollectedCurve& one : curves) distances.push_back(one.x.front());
  note_spectrum_lines(page, distances, options.spectrum);
  page.title += ": " + spectrum_title(options.domain);
  page.x_title = "Frequency";
}

/// Curves of one unit share a panel.
void add_panels(desktop::ChartPage& page, const std::vector<CollectedCurve>& curves,
                bool one_title) {
  for (const CollectedCurve& one : curves) {
    desktop::ChartCurve curve{one.name, interpolated_values(one.x, one.y, page.x), {}};
    curve.brief = one.brief;
    curve.element = one.element;
    if (!one.low.empty()) {
      curve.low = extremes_at(one.x, one.low, page.x);
      curve.high = extremes_at(one.x, one.high, page.x);
    }
    curve.stored = own_places(one, page.x);
    if (std::find(curve.stored.begin(), curve.stored.end(), false) == curve.stored.end())
      curve.stored.clear();
    const auto same = std::find_if(page.panels.begin(), page.panels.end(), [&](const auto& panel) {
      return panel.unit == one.unit && panel.group == one.group &&
             (one.group >= 0 || one_title || panel.title == one.title || !one.unit.empty());
    });
    if (same == page.panels.end()) {
      page.panels.push_back({one.title, one.unit, {std::move(curve)}, one.wraps});
      page.panels.back().group = one.group;
    } else {
      if (same->title != one.title) same->title = "Values";
      same->curves.push_back(std::move(curve));
    }
  }
}

}  // namespace

void UserChart::add(const CurvePick& pick) {
  const auto known = std::find_if(files.begin(), files.end(), [&](const auto& file) {
    return file->path == pick.file->path && file->subject == pick.file->subject;
  });
  files.push_back(known != files.end() ? *known : std::make_shared<PlotDocument>(*pick.file));
  curves.push_back(pick);
  curves.back().file = files.back().get();
}

RunMotion motion_at(const PlotDocument& file, const std::vector<double>& times) {
  RunMotion out;
  if (file.motion) out = file.motion();
  out.turns = interpolated_values(out.times, out.turns, times);
  if (std::any_of(out.turns.begin(), out.turns.end(),
                  [](double turns) { return !std::isfinite(turns); }))
    out = {};
  out.times = times;
  return out;
}

std::vector<int> groups_by_unit(const std::vector<CurvePick>& picks, const PageOptions& options) {
  std::vector<int> out;
  std::vector<std::pair<std::string, std::string>> panels;  // unit; title of pure numbers
  for (const CurvePick& pick : picks) {
    const desktop::ChartPage page = pick.file->build(pick.page, options);
    const desktop::ChartPanel& panel = page.panels.at(pick.panel);
    const std::pair key(panel.unit, panel.unit.empty() ? panel.title : std::string());
    const auto known = std::find(panels.begin(), panels.end(), key);
    out.push_back(static_cast<int>(known - panels.begin()));
    if (known == panels.end()) panels.push_back(key);
  }
  return out;
}

std::vector<double> interpolated_values(const std::vector<double>& x, const std::vector<double>& y,
                                        const std::vector<double>& where) {
  std::vector<double> out;
  out.reserve(where.size());
  std::size_t at = 0;
  const std::size_t n = std::min(x.size(), y.size());
  for (const double place : where) {
    if (n == 0 || place < x[0] || place > x[n - 1]) {
      out.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    while (at + 1 < n && x[at + 1] <= place) ++at;
    if (x[at] == place || at + 1 == n) {
      out.push_back(y[at]);
      continue;
    }
    out.push_back(y[at] + (place - x[at]) / (x[at + 1] - x[at]) * (y[at + 1] - y[at]));
  }
  return out;
}

desktop::ChartPage combine_curves(const std::vector<CurvePick>& picks, Combine how,
                                  const PageOptions& options) {
  if (picks.empty()) throw InputError("select at least one curve");
  const bool less = how == Combine::Difference;
  if (less && picks.size() < 2) throw InputError("select at least two curves for a difference");
  PageOptions history = options;
  history.domain = Domain::History;
  if (options.domain != Domain::History) history.abscissa = Abscissa::Time;
  desktop::ChartPage page;
  page.title = less ? "Differences" : "Selected curves";
  SourceNotes notes;
  std::vector<CollectedCurve> curves = take(picks, history, options.domain, page, notes);
  // Spectra need curves over time: not available for sweeps, tables and curves over frequency.
  const Domain domain =
      page.x_title == "Time" && page.x_unit == "s" ? options.domain : Domain::History;
  page.x = all_places(curves);
  if (less) {
    // One difference has no legend that would name it.
    page.note = (curves.size() == 2 ? curves.back().name + " minus " : "All curves minus ") +
                curves.front().name + ".";
    curves = differences(curves, domain != Domain::History, page);
  }
  if (domain != options.domain) add_note(page, "Spectra need curves over time.");
  // The difference of two runs has no speed.
  const auto motion_of = [&](std::size_t curve) {
    const std::vector<double>& times = curves[curve].x;
    if (less && !of_one_run(picks)) return RunMotion{times, {}};
    return motion_at(*picks[less ? curve + 1 : curve].file, times);
  };
  if (domain == Domain::Spectrogram) {
    // Only one curve: two spectrograms would overlap.
    std::vector<std::string> names;
    for (const CollectedCurve& one : curves) names.push_back(one.name);
    const std::size_t chosen = choice_of(names, options.spectrogram_of).value_or(0);
    CollectedCurve& one = curves[chosen];
    trim(one);
    page.x = one.x;
    page.panels = {{one.title, one.unit, {{one.name, one.y, {}}}, one.wraps}};
    to_spectrogram(page, motion_of(chosen), options.spectrum);
    page.choices = names;
    page.chosen = chosen;
    drop_low_marks(page);
    notes.add_notes_to(page);
    return page;
  }
  if (domain != Domain::History) {
    to_frequency(curves, page, options, motion_of);
    page.x = all_places(curves);
  }
  add_panels(page, curves, less);
  notes.add_notes_to(page);
  if (domain != Domain::History) {
    // Runs have different speeds: marks of one are wrong for another.
    if (of_one_run(picks))
      page.marks = picks.front().file->build(picks.front().page, options).marks;
    set_initial_spectrum_view(page, options.spectrum.scale, domain);
  }
  return page;
}

}  // namespace adore::adrplot
