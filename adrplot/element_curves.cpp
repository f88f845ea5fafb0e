#include "adrplot/element_curves.hpp"

#include "desktop/findings_bar.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

namespace adore::adrplot {
namespace {

constexpr std::string_view kElement = "element ";

/// "element 3" → 3; "elements 3 and 4" → 0.
int number_in(std::string_view curve) {
  if (!curve.starts_with(kElement)) return 0;
  curve.remove_prefix(kElement.size());
  int out = 0;
  const auto [end, error] = std::from_chars(curve.data(), curve.data() + curve.size(), out);
  return error == std::errc() && end == curve.data() + curve.size() && out > 0 ? out : 0;
}

desktop::ChartPage history_of(const PlotDocument& file, int page) {
  PageOptions options;
  options.abscissa = Abscissa::Time;
  return file.build(page, options);
}

/// A curve of a file by its name.
struct NamedCurve {
  const PlotDocument* file = nullptr;
  std::string name;
};

/// The same curve of another element on this page and panel; nothing: not available.
std::optional<NamedCurve> curve_of_element(const NamedCurve& curve, int page, std::size_t panel,
                                           int number,
                                           const std::vector<const PlotDocument*>& open) {
  NamedCurve out = curve;
  if (number_in(curve.name) > 0) {
    out.name = std::string(kElement) + std::to_string(number);
  } else {
    const auto found = std::find_if(open.begin(), open.end(), [&](const PlotDocument* one) {
      return one != nullptr && element_of(*one) == number &&
             run_folder(one->path) == run_folder(curve.file->path);
    });
    if (found == open.end()) return std::nullopt;
    out.file = *found;
  }
  if (page < 1 || page > static_cast<int>(out.file->pages.size())) return std::nullopt;
  const desktop::ChartPage source = history_of(*out.file, page);
  if (source.equal_axes || panel >= source.panels.size()) return std::nullopt;
  const auto& curves = source.panels[panel].curves;
  const bool has = std::any_of(curves.begin(), curves.end(),
                               [&](const auto& one) { return one.name == out.name; });
  return has ? std::optional(out) : std::nullopt;
}

/// The one element of all curves that have one; 0: none, or several.
int common_element(const std::vector<NamedCurve>& curves) {
  std::set<int> elements;
  for (const NamedCurve& curve : curves)
    if (const int element = element_of_curve(*curve.file, curve.name); element > 0)
      elements.insert(element);
  return elements.size() == 1 ? *elements.begin() : 0;
}

}  // namespace

int element_of(const PlotDocument& file) {
  return file.subject.starts_with("rolling element") ? desktop::parse_element_number(file.subject)
                                                     : 0;
}

int element_of_curve(const PlotDocument& file, const std::string& curve) {
  const int number = number_in(curve);
  return number > 0 ? number : element_of(file);
}

std::optional<UserChart> chart_of_element(const UserChart& chart, int number,
                                          const std::vector<const PlotDocument*>& open) {
  std::vector<NamedCurve> curves;
  for (const CurvePick& pick : chart.curves) {
    const desktop::ChartPage page = history_of(*pick.file, pick.page);
    if (pick.panel >= page.panels.size() || pick.curve >= page.panels[pick.panel].curves.size())
      return std::nullopt;
    curves.push_back({pick.file, page.panels[pick.panel].curves[pick.curve].name});
  }
  if (const int element = common_element(curves); element == 0 || element == number)
    return std::nullopt;
  UserChart out;
  out.how = chart.how;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    CurvePick pick = chart.curves[i];
    if (element_of_curve(*curves[i].file, curves[i].name) > 0) {
      const auto other = curve_of_element(curves[i], pick.page, pick.panel, number, open);
      if (!other) return std::nullopt;
      pick.file = other->file;
      pick.curve = curve_index(history_of(*pick.file, pick.page), pick.panel, other->name);
    }
    out.add(pick);
  }
  return out;
}

std::optional<FormulaChannel> formula_of_element(const FormulaChannel& channel, int number,
                                                 const std::vector<const PlotDocument*>& open) {
  std::vector<NamedCurve> curves;
  for (const FormulaInput& input : channel.inputs)
    curves.push_back({input.file.get(), input.curve});
  if (const int element = common_element(curves); element == 0 || element == number)
    return std::nullopt;
  FormulaChannel out = channel;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (element_of_curve(*curves[i].file, curves[i].name) == 0) continue;
    FormulaInput& input = out.inputs[i];
    const auto other = curve_of_element(curves[i], input.page, input.panel, number, open);
    if (!other) return std::nullopt;
    if (other->file != input.file.get()) input.file = std::make_shared<PlotDocument>(*other->file);
    input.curve = other->name;
  }
  return out;
}

bool emphasize_element(desktop::ChartPage& page, int number) {
  const auto element = [](const desktop::ChartCurve& curve) {
    return curve.element > 0 ? curve.element : number_in(curve.name);
  };
  std::set<int> elements;
  for (const desktop::ChartPanel& panel : page.panels)
    for (const desktop::ChartCurve& curve : panel.curves) elements.insert(element(curve));
  elements.erase(0);
  if (page.equal_axes || elements.size() < 2 || !elements.contains(number)) return false;
  for (desktop::ChartPanel& panel : page.panels)
    for (desktop::ChartCurve& curve : panel.curves) {
      curve.heavy = element(curve) == number;
      if (curve.heavy) curve.hidden = false;
    }
  return true;
}

}  // namespace adore::adrplot
