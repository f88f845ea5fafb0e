#include "adrplot/own_chart.hpp"

#include "adrplot/spectrogram_page.hpp"
#include "adrplot/spectrum_page.hpp"
#include "base/errors.hpp"
#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>

namespace adore::adrplot {
namespace {

/// Identifies a curve: quantity, body and run.
using Names = std::array<std::string, 3>;

struct Taken {
  std::string name, unit, title;
  int group = -1;
  Names names = {};
  std::string brief = {};  ///< without the common part of all curves
  std::vector<double> x, y;
  bool wraps = false;
  std::vector<bool> own = {};  ///< as long as x: a value that is stored; empty: all are
  /// Extremes between the stored values, as long as x; empty: not known.
  std::vector<double> low = {}, high = {};
};

/// Which of the increasing points `where` are stored points of a curve.
std::vector<bool> own_places(const Taken& curve, const std::vector<double>& where) {
  std::vector<bool> out(where.size(), false);
  std::size_t at = 0;
  for (std::size_t i = 0; i < where.size(); ++i) {
    while (at < curve.x.size() && curve.x[at] < where[i]) ++at;
    out[i] = at < curve.x.size() && curve.x[at] == where[i] && (curve.own.empty() || curve.own[at]);
  }
  return out;
}

/// The last `parts` of a file's path.
std::string end_of_path(const PlotDocument& file, std::size_t parts) {
  std::filesystem::path out = file.path.filename(), folder = run_folder(file.path);
  for (std::size_t i = 1; i < parts && !folder.filename().empty(); ++i) {
    out = folder.filename() / out;
    folder = folder.parent_path();
  }
  return out.generic_string();
}

/// Names of the files, "ball/SOL7": as long as needed to distinguish them.
std::vector<std::string> runs_of(const std::vector<CurvePick>& picks) {
  constexpr std::size_t kLongest = 8;
  std::set<std::filesystem::path> files;
  for (const CurvePick& pick : picks)
    files.insert(run_folder(pick.file->path) / pick.file->path.filename());
  std::vector<std::string> out;
  for (std::size_t parts = 2; parts <= kLongest; ++parts) {
    out.clear();
    for (const CurvePick& pick : picks) out.push_back(end_of_path(*pick.file, parts));
    if (std::set(out.begin(), out.end()).size() == files.size()) break;
  }
  return out;
}

std::string joined(const Names& names, const std::array<bool, 3>& which) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (which.at(i)) out += (out.empty() ? "" : " · ") + names.at(i);
  return out;
}

/// The names that distinguish the curves, and always the quantity.
std::array<bool, 3> telling(const std::vector<Taken>& curves) {
  std::array<bool, 3> out{true, false, false};
  for (const Taken& one : curves)
    for (std::size_t i = 0; i < out.size(); ++i)
      out.at(i) = out.at(i) || one.names.at(i) != curves.front().names.at(i);
  return out;
}

/// Sentences, each with its full stop.
std::vector<std::string> sentences_of(const std::string& note) {
  std::vector<std::string> out;
  std::size_t begin = 0;
  for (std::size_t i = 0; i + 2 < note.size(); ++i) {
    const auto next = static_cast<unsigned char>(note[i + 2]);
    if (note[i] != '.' || note[i + 1] != ' ' ||
        (std::isupper(next) == 0 && std::isdigit(next) == 0))
      continue;
    out.push_back(note.substr(begin, i + 1 - begin));
    begin = i + 2;
  }
  if (begin < note.size()) out.push_back(note.substr(begin));
  return out;
}

/// Notes of the pages of the curves: once if they apply to all curves, else by curve name.
class SourceNotes {
 public:
  void add(const std::string& source, const std::string& sentence) {
    if (std::find(sources_.begin(), sources_.end(), source) == sources_.end())
      sources_.push_back(source);
    if (sentence.empty()) return;
    const auto same = std::find_if(said_.begin(), said_.end(),
                                   [&](const auto& one) { return one.first == sentence; });
    if (same == said_.end())
      said_.push_back({sentence, {source}});
    else if (std::find(same->second.begin(), same->second.end(), source) == same->second.end())
      same->second.push_back(source);
  }
  void tell(desktop::ChartPage& page) const {
    for (const auto& [sentence, of] : said_)
      if (of.size() == sources_.size()) add_note(page, sentence);
    std::map<std::vector<std::string>, std::string> others;
    for (const auto& [sentence, of] : said_) {
      if (of.size() == sources_.size()) continue;
      std::string& text = others[of];
      text += (text.empty() ? "" : " ") + sentence;
    }
    for (const auto& [of, text] : others) {
      std::string names;
      for (const std::string& name : of) names += (names.empty() ? "" : ", ") + name;
      add_note(page, names + ": " + text);
    }
  }

 private:
  std::vector<std::string> sources_;
  std::vector<std::pair<std::string, std::vector<std::string>>> said_;
};

/// Notes of the page of a curve that also apply to the curve over this domain.
std::vector<std::string> remarks_on(const CurvePick& pick, const desktop::ChartPage& history,
                                    const PageOptions& options) {
  std::vector<std::string> out;
  if (!pick.file->note.empty()) out.push_back("Incomplete file: " + pick.file->note + ".");
  const bool over_time = options.domain == Domain::History;
  const std::string note = over_time ? history.note : pick.file->build(pick.page, options).note;
  for (const std::string& sentence : sentences_of(note)) {
    const auto is = [&](std::string_view begin) { return sentence.starts_with(begin); };
    // A spectrum page has notes on its own frequencies.
    const bool of_file = is("Aliased: ") || is("Shown: ") || is("In this file ") ||
                         is("In these steps ") || is("The values have ") || is("RESULTS.h5 ");
    if (over_time || of_file) out.push_back(sentence);
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

/// The selected curves, each over its own horizontal axis, whose title and unit are stored in the
/// page.
std::vector<Taken> take(const std::vector<CurvePick>& picks, const PageOptions& options,
                        Domain domain, desktop::ChartPage& page, SourceNotes& notes) {
  std::vector<Taken> taken;
  const std::vector<std::string> runs = runs_of(picks);
  for (const CurvePick& pick : picks) {
    const desktop::ChartPage source = pick.file->build(pick.page, options);
    if (source.equal_axes || pick.panel >= source.panels.size() ||
        pick.curve >= source.panels[pick.panel].curves.size())
      throw InputError(
          fmt::format("{}, page {}: this curve has no horizontal axis and cannot be combined",
                      pick.file->path.string(), pick.page));
    if (taken.empty()) {
      page.x_title = source.x_title;
      page.x_unit = source.x_unit;
    } else if (source.x_unit != page.x_unit || source.x_title != page.x_title) {
      throw InputError(fmt::format(
          "{} is plotted against {}, but {} against {}; select curves with the same horizontal "
          "axis",
          taken.front().name, page.x_title, source.panels[pick.panel].title, source.x_title));
    }
    const desktop::ChartPanel& panel = source.panels[pick.panel];
    const desktop::ChartCurve& curve = panel.curves[pick.curve];
    Taken one;
    one.title = panel.title;
    one.group = pick.group;
    one.unit = panel.unit;
    one.wraps = panel.wraps;
    one.names = {panel.title + (curve.name.empty() ? "" : ", ") + curve.name, pick.file->subject,
                 runs[taken.size()]};
    one.name = joined(one.names, {true, true, true});
    one.x = source.x;
    one.y = curve.y;
    if (curve.low.size() == curve.y.size()) {
      one.low = curve.low, one.high = curve.high;
      page.band_note = source.band_note;
    }
    PageOptions shown = options;
    shown.domain = source.x_title == "Time" ? domain : Domain::History;
    notes.add(one.name, {});
    for (const std::string& remark : remarks_on(pick, source, shown)) notes.add(one.name, remark);
    taken.push_back(std::move(one));
  }
  const std::array<bool, 3> apart = telling(taken);
  for (Taken& one : taken) one.brief = joined(one.names, apart);
  for (const std::string& run : std::set(runs.begin(), runs.end()))
    page.subtitle += (page.subtitle.empty() ? "" : "   ·   ") + run;
  return taken;
}

bool of_one_run(const std::vector<CurvePick>& picks) {
  return std::all_of(picks.begin(), picks.end(), [&](const CurvePick& pick) {
    return run_folder(pick.file->path) == run_folder(picks.front().file->path);
  });
}

std::vector<double> all_places(const std::vector<Taken>& curves) {
  std::vector<double> x;
  for (const Taken& one : curves) x.insert(x.end(), one.x.begin(), one.x.end());
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
std::vector<double> places_for_spectrum(const Taken& a, const Taken& b, desktop::ChartPage& page) {
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
std::vector<Taken> differences(const std::vector<Taken>& taken, bool for_spectra,
                               desktop::ChartPage& page) {
  const Taken& first = taken.front();
  const std::array<bool, 3> apart = telling(taken);
  std::vector<Taken> out;
  for (std::size_t i = 1; i < taken.size(); ++i) {
    Taken one = taken[i];
    if (one.unit != first.unit)
      throw InputError(fmt::format("{} is in {}, but {} is in {}; select curves with the same unit",
                                   one.name, one.unit.empty() ? "no unit" : one.unit, first.name,
                                   first.unit.empty() ? "no unit" : first.unit));
    one.x =
        for_spectra ? places_for_spectrum(first, taken[i], page) : all_places({first, taken[i]});
    one.y = read_off(taken[i].x, taken[i].y, one.x);
    const std::vector<double> less = read_off(first.x, first.y, one.x);
    for (std::size_t k = 0; k < one.y.size(); ++k) one.y[k] -= less[k];
    one.own = own_places(taken[i], one.x);
    const std::vector<bool> of_first = own_places(first, one.x);
    for (std::size_t k = 0; k < one.own.size(); ++k) one.own[k] = one.own[k] && of_first[k];
    one.title = "Difference";
    for (std::size_t k = 0; k < one.names.size(); ++k)
      if (one.names.at(k) != first.names.at(k)) one.names.at(k) += " minus " + first.names.at(k);
    one.name = joined(one.names, {true, true, true});
    one.brief = "Difference: " + joined(one.names, apart);
    if (!one.low.empty() || !first.low.empty())
      add_note(page, "Differences have no min–max bands.");
    one.low.clear(), one.high.clear();
    one.wraps = false;
    out.push_back(std::move(one));
  }
  return out;
}

/// A curve from its first value to its last: a shorter run has no later values.
void trim(Taken& one) {
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
void to_frequency(std::vector<Taken>& curves, desktop::ChartPage& page,
                  const SpectrumOptions& options) {
  for (Taken& one : curves) {
    trim(one);
    desktop::ChartPage alone;
    alone.x = one.x;
    alone.panels = {{one.title, one.unit, {{"", one.y, {}}}, one.wraps}};
    to_spectra(alone, one.x, options);
    const bool has = !alone.panels.empty() && !alone.panels[0].curves[0].y.empty();
    if (!has && !alone.panels.empty()) add_note(alone, alone.panels[0].message);
    if (!alone.note.empty())
      add_note(page, curves.size() > 1 ? one.name + ": " + alone.note : alone.note);
    one.wraps = false;
    one.own.clear();  // the lines of a spectrum are stored points
    one.low.clear(), one.high.clear();
    one.x = has ? alone.x : std::vector<double>();
    one.y = has ? alone.panels[0].curves[0].y : std::vector<double>();
    if (has) one.unit = alone.panels[0].unit;
  }
  std::erase_if(curves, [](const Taken& one) { return one.x.empty(); });
  std::vector<double> distances;
  for (const Taken& one : curves) distances.push_back(one.x.front());
  tell_lines(page, distances, options);
  page.title += ": amplitude spectrum";
  page.x_title = "Frequency";
  page.x_unit = "Hz";
}

/// Curves of one unit share a panel.
void add_panels(desktop::ChartPage& page, const std::vector<Taken>& curves, bool one_title) {
  for (const Taken& one : curves) {
    desktop::ChartCurve curve{one.name, read_off(one.x, one.y, page.x), {}};
    curve.brief = one.brief;
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

void OwnChart::add(const CurvePick& pick) {
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
  out.turns = read_off(out.times, out.turns, times);
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

std::vector<double> read_off(const std::vector<double>& x, const std::vector<double>& y,
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
  std::vector<Taken> curves = take(picks, history, options.domain, page, notes);
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
  if (domain == Domain::Spectrogram) {
    // Only one curve: two spectrograms would overlap.
    std::vector<std::string> names;
    for (const Taken& one : curves) names.push_back(one.name);
    const std::size_t chosen = choice_of(names, options.spectrogram_of).value_or(0);
    Taken& one = curves[chosen];
    trim(one);
    page.x = one.x;
    page.panels = {{one.title, one.unit, {{one.name, one.y, {}}}, one.wraps}};
    // The difference of two runs has no speed.
    RunMotion motion{one.x, {}, {}};
    if (!less || of_one_run(picks))
      motion = motion_at(*picks[less ? chosen + 1 : chosen].file, one.x);
    to_spectrogram(page, motion, options.spectrum);
    page.choices = names;
    page.chosen = chosen;
    drop_low_marks(page);
    notes.tell(page);
    return page;
  }
  if (domain == Domain::Spectrum) {
    to_frequency(curves, page, options.spectrum);
    page.x = all_places(curves);
  }
  add_panels(page, curves, less);
  notes.tell(page);
  if (domain == Domain::Spectrum) {
    // Runs have different speeds: marks of one are wrong for another.
    if (of_one_run(picks))
      page.marks = picks.front().file->build(picks.front().page, options).marks;
    first_view_of_spectra(page, options.spectrum.scale);
  }
  return page;
}

}  // namespace adore::adrplot
