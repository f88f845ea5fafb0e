#include "adrplot/own_chart.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace adore::adrplot {
namespace {

struct Taken {
  std::string name, unit, title;
  std::vector<double> x, y;
  bool wraps = false;
};

std::string run_of(const PlotDocument& file) {
  const std::string folder = std::filesystem::absolute(file.path).parent_path().filename().string();
  return (folder.empty() ? "" : folder + "/") + file.path.filename().string();
}

}  // namespace

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
  if (picks.empty()) throw InputError("choose at least one curve for the chart");
  if (how == Combine::Difference && picks.size() < 2)
    throw InputError("a difference needs two curves at least");
  desktop::ChartPage page;
  page.title = how == Combine::Difference ? "Differences" : "Chosen curves";
  std::vector<Taken> taken;
  std::set<std::string> runs;
  for (const CurvePick& pick : picks) {
    const desktop::ChartPage source = pick.file->build(pick.page, options);
    if (source.equal_axes || pick.panel >= source.panels.size() ||
        pick.curve >= source.panels[pick.panel].curves.size())
      throw InputError(fmt::format("{}, page {}: this curve has no abscissa of its own",
                                   pick.file->path.string(), pick.page));
    if (taken.empty()) {
      page.x_title = source.x_title;
      page.x_unit = source.x_unit;
    } else if (source.x_unit != page.x_unit || source.x_title != page.x_title) {
      throw InputError(fmt::format(
          "{} is drawn over {} and {} over {}; choose curves of one abscissa, or another one for "
          "both",
          taken.front().name, page.x_title, source.panels[pick.panel].title, source.x_title));
    }
    const desktop::ChartPanel& panel = source.panels[pick.panel];
    const desktop::ChartCurve& curve = panel.curves[pick.curve];
    Taken one;
    one.title = panel.title;
    one.unit = panel.unit;
    one.wraps = panel.wraps;
    one.name = fmt::format("{}{}{} · {} · {}", panel.title, curve.name.empty() ? "" : ", ",
                           curve.name, pick.file->subject, run_of(*pick.file));
    one.x = source.x;
    one.y = curve.y;
    runs.insert(run_of(*pick.file));
    taken.push_back(std::move(one));
  }
  for (const Taken& one : taken) page.x.insert(page.x.end(), one.x.begin(), one.x.end());
  std::sort(page.x.begin(), page.x.end());
  page.x.erase(std::unique(page.x.begin(), page.x.end()), page.x.end());
  for (const Taken& one : taken) {
    std::vector<double> y = read_off(one.x, one.y, page.x);
    std::string title = one.title;
    std::string name = one.name;
    if (how == Combine::Difference) {
      if (&one == &taken.front()) continue;
      if (one.unit != taken.front().unit)
        throw InputError(fmt::format("{} is in {}, {} in {}: there is no difference of them",
                                     one.name, one.unit.empty() ? "no unit" : one.unit,
                                     taken.front().name,
                                     taken.front().unit.empty() ? "no unit" : taken.front().unit));
      const std::vector<double> first = read_off(taken.front().x, taken.front().y, page.x);
      for (std::size_t i = 0; i < y.size(); ++i) y[i] -= first[i];
      title = "Difference";
    }
    const auto same = std::find_if(page.panels.begin(), page.panels.end(), [&](const auto& panel) {
      return panel.unit == one.unit &&
             (how == Combine::Difference || panel.title == title || !one.unit.empty());
    });
    if (same == page.panels.end()) {
      page.panels.push_back(
          {title, one.unit, {{name, std::move(y), {}}}, one.wraps && how == Combine::Overlay});
    } else {
      if (same->title != title) same->title = "Values";
      same->curves.push_back({name, std::move(y), {}});
    }
  }
  std::string files;
  for (const std::string& run : runs) files += (files.empty() ? "" : "   ·   ") + run;
  page.subtitle = files;
  if (how == Combine::Difference) page.note = "Less " + taken.front().name + ".";
  return page;
}

}  // namespace adore::adrplot
