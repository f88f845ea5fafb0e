#include "desktop/chart_scene_parts.hpp"

#include <QFontMetricsF>
#include <QGraphicsSimpleTextItem>

#include <algorithm>
#include <cmath>

/// A panel of a page of charts: its axis, and its content.
namespace adore::desktop {

AxisScale ChartScene::panelAxis(std::size_t index, const QRectF& area, bool& any) {
  auto& found = axis_cache_.at(index);
  if (!found) {
    bool has = false;
    const AxisScale axis = findAxis(index, area, has);
    found = std::pair(axis, has);
  }
  any = found->second;
  return found->first;
}

AxisScale ChartScene::findAxis(std::size_t index, const QRectF& area, bool& any) const {
  const ChartPanel& panel = page_.panels[index];
  if (panel.rows) {
    any = !panel.rows->at.empty();
    const std::vector<double> limits = cell_edges(panel.rows->at);
    const auto [low, high] = panel_views_[index].value_or(
        any ? std::pair(limits.front(), limits.back()) : std::pair(0.0, 1.0));
    return tight_axis(low, high, panel.rows->unit,
                      std::clamp(static_cast<int>(area.height() / 38), 2, 8));
  }
  Extent extent;
  any = false;
  const auto [from, to] = abscissa_increasing_
                              ? indices_between(page_.x, low_, high_)
                              : std::pair<std::size_t, std::size_t>(0, page_.x.size());
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const ChartCurve& curve = panel.curves[c];
    any = any || std::any_of(curve.y.begin(), curve.y.end(), is_drawable);
    if (curve.hidden) continue;
    const bool by_blocks = !curve_blocks_.empty() && !panel.log;
    std::size_t which = 0;
    for (const auto* values : {&curve.y, &curve.low, &curve.high}) {
      if (by_blocks)
        extent.include(extent_between(*values, from, to, curve_blocks_[index][c].of(which)));
      ++which;
      if (by_blocks) continue;
      for (std::size_t i = from; i < std::min(to, values->size()); ++i)
        if ((abscissa_increasing_ || (page_.x[i] >= low_ && page_.x[i] <= high_)) &&
            (!panel.log || (*values)[i] > 0.0))
          extent.include((*values)[i]);
    }
  }
  const double least = std::max(panel.least_span, min_axis_span(panel.unit));
  if (!panel.log && !extent.empty() && extent.high - extent.low < least) {
    // Next to a larger value such noise is a constant; around zero the axis shows its size.
    constexpr double kSeen = 0.03;  // of an axis as short as the noise: less is a straight line
    const double middle = 0.5 * (extent.low + extent.high);
    const bool nothing = std::max(std::abs(extent.low), std::abs(extent.high)) < kSeen * least;
    const double half = std::abs(middle) > 500.0 * least ? 0.0 : 0.5 * least;
    extent = {middle - half, middle + half};
    // Values that are 0 except for rounding get a scale for bearings, not for atoms.
    if (nothing) extent = {-1e4 * least, 1e4 * least};
  }
  const int parts = std::clamp(static_cast<int>(area.height() / 38), 2, 8);
  const auto& chosen = panel_views_[index];
  const double low = chosen ? chosen->first : extent.low,
               high = chosen ? chosen->second : extent.high;
  constexpr qreal kLabelHeight = 20.0;
  return panel.log
             ? log_axis(low, high, panel.unit, chosen.has_value(), area.height() / kLabelHeight)
         : chosen ? tight_axis(low, high, panel.unit, parts)
                  : value_axis(low, high, panel.unit, parts);
}

namespace {

bool has_values(const ChartPanel& panel) {
  return std::any_of(panel.curves.begin(), panel.curves.end(), [](const ChartCurve& curve) {
    return std::any_of(curve.y.begin(), curve.y.end(), is_drawable);
  });
}

/// More than rounding of 0.
bool is_something(const ChartPanel& panel) {
  const double least = std::max(panel.least_span, min_axis_span(panel.unit));
  return std::any_of(panel.curves.begin(), panel.curves.end(), [least](const ChartCurve& curve) {
    return std::any_of(curve.y.begin(), curve.y.end(),
                       [least](double v) { return is_drawable(v) && std::abs(v) > least; });
  });
}

/// Do all panels lack values for the same reason? Then it is shown once for the page.
bool one_message(const ChartPage& page) {
  return page.panels.size() > 1 &&
         std::all_of(page.panels.begin(), page.panels.end(), [&](const ChartPanel& panel) {
           return !panel.message.empty() && panel.message == page.panels.front().message &&
                  !has_values(panel);
         });
}

/// Lengths are not a vector: a radius may be next to micrometers of an axial position.
bool shares_unit(const ChartPanel& panel) {
  return !panel.log && !panel.rows && !panel.unit.empty() && panel.unit != "m";
}

}  // namespace

void ChartScene::addMapPanel(std::size_t index, const QRectF& area, const AxisScale& y_axis,
                             bool any, bool bottom, const Metrics& m) {
  const ChartPanel& panel = page_.panels[index];
  const QString x_title =
      bottom ? with_unit_and_offset(text_of(page_.x_title), x_axis_) : QString();
  addFrame(area, x_axis_, y_axis, x_title, with_unit_and_offset(text_of(panel.rows->title), y_axis),
           bottom, any, m);
  if (any) addMapRows(panel, area, y_axis, m);
  if (!any) addMessage(area, text_of(panel.message), m);
  if (any) addMarks(area, y_axis, index == 0, true, m);
  plot_areas_.push_back(area);
  y_axes_.push_back(y_axis);
}

void ChartScene::addPanel(std::size_t index, const QRectF& area, bool bottom, const Metrics& m) {
  const ChartPanel& panel = page_.panels[index];
  bool any = false;
  AxisScale y_axis = panelAxis(index, area, any);
  if (one_message(page_)) {  // axes would be of nothing
    if (index == 0) addMessage(space(m), text_of(panel.message), m);
    plot_areas_.push_back(area);
    y_axes_.push_back(y_axis);
    lines_.push_back(0);
    return;
  }
  // Panels with the same unit are comparable: if all are in N or kN, N is used unless the numbers
  // get too long.
  std::vector<AxisScale> alike;
  for (std::size_t i = 0; any && shares_unit(panel) && i < page_.panels.size(); ++i) {
    if (page_.panels[i].unit != panel.unit || !shares_unit(page_.panels[i])) continue;
    bool drawn = false;
    const AxisScale axis = panelAxis(i, area, drawn);
    if (drawn && is_something(page_.panels[i])) alike.push_back(axis);
  }
  if (!alike.empty()) take_common_unit(y_axis, alike);
  if (panel.rows) return addMapPanel(index, area, y_axis, any, bottom, m);
  const QString x_title =
      bottom ? with_unit_and_offset(text_of(page_.x_title), x_axis_) : QString();
  const std::vector<ShownCurve> shown = prepareShownCurves(index, area, y_axis, m);
  const bool log_of_none =
      any && panel.log &&
      std::none_of(panel.curves.begin(), panel.curves.end(), has_positive_value);
  const bool names_above = index == 0 && !page_.marks.empty();
  // A panel without values has no scale: any would be made up.
  const bool scaled = any && !log_of_none;
  const QRectF below_legend = area.adjusted(
      0.0, names_above ? -mark_labels_height(page_, m.tick_font, size_.width()) : 0.0, 0.0, 0.0);
  // Low panels of a small picture have no space for repeated names.
  const bool named_before =
      style_ == ChartStyle::Compact && size_.height() < kLowCompact && index > 0 &&
      std::equal(panel.curves.begin(), panel.curves.end(), page_.panels.front().curves.begin(),
                 page_.panels.front().curves.end(),
                 [](const ChartCurve& a, const ChartCurve& b) { return a.name == b.name; });
  const qreal legend = scaled && !named_before
                           ? addLegend(panel, shown, below_legend, labelsTop(area, y_axis, m), m)
                           : area.right();
  // A title too long for the side of its panel, even without its unit, is above it.
  QString y_title = scaled ? with_unit(text_of(panel.title), y_axis) : text_of(panel.title);
  qreal head = area.left();
  const QFontMetricsF title_metrics(ui_font(m.text_font));
  // One direction for the page.
  const bool above =
      std::any_of(page_.panels.begin(), page_.panels.end(), [&](const ChartPanel& one) {
        const QString unit = "[" + text_of(pretty_unit(one.unit)) + "]";
        return std::max(title_metrics.horizontalAdvance(text_of(one.title)),
                        title_metrics.horizontalAdvance(unit)) >
               available_title_length(area, m.gap);
      });
  if (above && area.left() + title_metrics.horizontalAdvance(y_title) + 8.0 < legend) {
    auto* title = addSimpleText(y_title, ui_font(m.text_font));
    title->setBrush(theme_->text);
    title->setPos(area.left(), below_legend.top() - title_metrics.height() - 3.0);
    head += title_metrics.horizontalAdvance(y_title) + 16.0;
    y_title.clear();
  }
  addFrame(area, x_axis_, y_axis, x_title, y_title, bottom, scaled, m);
  std::vector<QPolygonF> drawn;
  for (const ShownCurve& one : shown)  // below all curves: none has the color of another's area
    if (!panel.curves[one.curve].low.empty())
      addBand(index, one.curve, area, y_axis, one.colour, drawn);
  if (!page_.band_note.empty() && !bands_visible_)
    bands_visible_ = areBandsVisible(drawn, shown, area, m.line);
  for (const ShownCurve& one : shown) {
    addShownCurve(one, panel, area, y_axis, m);
    drawn.insert(drawn.end(), one.lines.begin(), one.lines.end());
  }
  if (!any)
    addMessage(area, panel.message.empty() ? tr("The file has no values.") : text_of(panel.message),
               m);
  if (log_of_none) addMessage(area, tr("No value is above 0 (logarithmic axis)."), m);
  if (scaled && !y_axis.offset_text.empty())
    addAxisOffset(y_axis, area, head, names_above ? head : legend, drawn, m);
  // Lines would cross the text of a message; their names are also at the panels below.
  const bool named =
      index == 0 && std::any_of(page_.panels.begin(), page_.panels.end(), has_values);
  if (any || named) addMarks(area, y_axis, named, any, m);
  plot_areas_.push_back(area);
  y_axes_.push_back(y_axis);
}

}  // namespace adore::desktop
