#include "adrplot/formula_document.hpp"

#include "adrplot/domain_page.hpp"
#include "adrplot/known_values.hpp"
#include "adrplot/own_chart.hpp"
#include "base/errors.hpp"
#include "signal/channel_formula.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::adrplot {

std::size_t curve_index(const desktop::ChartPage& page, std::size_t panel,
                        const std::string& name) {
  const auto& curves = page.panels.at(panel).curves;
  const auto found = std::find_if(curves.begin(), curves.end(),
                                  [&](const desktop::ChartCurve& c) { return c.name == name; });
  return found == curves.end() ? 0 : static_cast<std::size_t>(found - curves.begin());
}

desktop::ChartPage formula_page(const FormulaChannel& channel, const PageOptions& options) {
  if (channel.inputs.empty())
    throw InputError(fmt::format("Formula \"{}\": it uses no channel", channel.formula));
  PageOptions history = options;
  history.domain = Domain::History;
  if (options.domain != Domain::History) history.abscissa = Abscissa::Time;
  desktop::ChartPage out;
  out.title = channel.title;
  out.note = channel.formula + ", where ";
  signal::NamedSeries series;
  for (const FormulaInput& input : channel.inputs) {
    const desktop::ChartPage page = input.file->build(input.page, history);
    if (page.equal_axes || input.panel >= page.panels.size() ||
        page.panels[input.panel].curves.empty())
      throw InputError(fmt::format("Formula \"{}\": {} has no channel for \"{}\"", channel.formula,
                                   input.file->path.string(), input.name));
    const desktop::ChartPanel& panel = page.panels[input.panel];
    const desktop::ChartCurve& curve = panel.curves[curve_index(page, input.panel, input.curve)];
    if (series.empty()) {
      out.x = page.x, out.x_title = page.x_title, out.x_unit = page.x_unit;
    } else if (page.x_title != out.x_title || page.x_unit != out.x_unit) {
      throw InputError(fmt::format(
          "Formula \"{}\": \"{}\" is plotted against {}, other channels against {}; select "
          "channels with the same horizontal axis",
          channel.formula, input.name, page.x_title, out.x_title));
    }
    out.note += fmt::format("{}{} is {}{}{}{}", series.empty() ? "" : "; ", input.name, panel.title,
                            curve.name.empty() ? "" : ", ", curve.name,
                            panel.unit.empty() ? "" : " [" + panel.unit + "]");
    series[input.name] = page.x == out.x ? curve.y : interpolated_values(page.x, curve.y, out.x);
  }
  out.note += '.';
  desktop::ChartPanel panel{channel.title, channel.unit, {}, false};
  panel.curves.push_back({"", signal::evaluate(channel.formula, series), {}});
  if (!has_number(panel.curves.front().y)) panel.message = "The formula has no values.";
  out.panels.push_back(std::move(panel));
  if (out.x_title == "Time" && out.x_unit == "s")
    show_domain(out, motion_at(*channel.inputs.front().file, out.x), options);
  return out;
}

PlotDocument formula_document(std::vector<FormulaChannel> channels) {
  PlotDocument out;
  out.path = "formulas";
  out.subject = "computed channels";
  for (const FormulaChannel& channel : channels)
    out.pages.push_back({channel.title, PageKind::History, {channel.title}, {{""}}});
  const auto shared = std::make_shared<const std::vector<FormulaChannel>>(std::move(channels));
  out.build = [shared](int number, const PageOptions& options) {
    check_page_number("formulas", number, shared->size());
    desktop::ChartPage page =
        formula_page((*shared)[static_cast<std::size_t>(number - 1)], options);
    page.subtitle = fmt::format("computed channel   ·   page {} of {}", number, shared->size());
    return page;
  };
  if (!shared->empty() && !shared->front().inputs.empty())
    out.motion = [file = shared->front().inputs.front().file] {
      return file->motion ? file->motion() : RunMotion{};
    };
  return out;
}

}  // namespace adore::adrplot
