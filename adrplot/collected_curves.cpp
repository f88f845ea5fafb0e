#include "adrplot/collected_curves.hpp"

#include "adrplot/element_curves.hpp"
#include "adrplot/spectrum_page.hpp"
#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

namespace adore::adrplot {
namespace {

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

}  // namespace

std::string joined_names(const Names& names, const std::array<bool, 3>& which) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (which.at(i)) out += (out.empty() ? "" : " · ") + names.at(i);
  return out;
}

std::array<bool, 3> distinguishing_names(const std::vector<CollectedCurve>& curves) {
  std::array<bool, 3> out{true, false, false};
  for (const CollectedCurve& one : curves)
    for (std::size_t i = 0; i < out.size(); ++i)
      out.at(i) = out.at(i) || one.names.at(i) != curves.front().names.at(i);
  return out;
}

void SourceNotes::add(const std::string& source, const std::string& sentence) {
  if (std::find(sources_.begin(), sources_.end(), source) == sources_.end())
    sources_.push_back(source);
  if (sentence.empty()) return;
  const auto same = std::find_if(sources_by_sentence_.begin(), sources_by_sentence_.end(),
                                 [&](const auto& one) { return one.first == sentence; });
  if (same == sources_by_sentence_.end())
    sources_by_sentence_.push_back({sentence, {source}});
  else if (std::find(same->second.begin(), same->second.end(), source) == same->second.end())
    same->second.push_back(source);
}

void SourceNotes::add_notes_to(desktop::ChartPage& page) const {
  for (const auto& [sentence, of] : sources_by_sentence_)
    if (of.size() == sources_.size()) add_note(page, sentence);
  std::map<std::vector<std::string>, std::string> others;
  for (const auto& [sentence, of] : sources_by_sentence_) {
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

std::vector<CollectedCurve> take(const std::vector<CurvePick>& picks, const PageOptions& options,
                                 Domain domain, desktop::ChartPage& page, SourceNotes& notes) {
  std::vector<CollectedCurve> taken;
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
    CollectedCurve one;
    one.title = panel.title;
    one.group = pick.group;
    one.unit = panel.unit;
    one.wraps = panel.wraps;
    one.element = element_of_curve(*pick.file, curve.name);
    one.names = {panel.title + (curve.name.empty() ? "" : ", ") + curve.name, pick.file->subject,
                 runs[taken.size()]};
    one.name = joined_names(one.names, {true, true, true});
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
  const std::array<bool, 3> apart = distinguishing_names(taken);
  for (CollectedCurve& one : taken) one.brief = joined_names(one.names, apart);
  for (const std::string& run : std::set(runs.begin(), runs.end()))
    page.subtitle += (page.subtitle.empty() ? "" : "   ·   ") + run;
  return taken;
}

}  // namespace adore::adrplot
