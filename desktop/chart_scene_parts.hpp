#pragma once

#include "desktop/chart_scene.hpp"

#include <QString>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Shared by the sources of ChartScene.
namespace adore::desktop {

inline QString text_of(const std::string& text) { return QString::fromStdString(text); }

inline QString with_unit(const QString& title, const AxisScale& axis) {
  QString text = title;
  if (!axis.unit.empty()) text += " [" + text_of(axis.unit) + "]";
  return text;
}

/// Space at an abscissa for the reference value of its numbers.
inline QString with_unit_and_offset(const QString& title, const AxisScale& axis) {
  const QString text = with_unit(title, axis);
  return axis.offset_text.empty() ? text : text + " from " + text_of(axis.offset_text);
}

inline bool has_positive_value(const ChartCurve& curve) {
  return std::any_of(curve.y.begin(), curve.y.end(),
                     [](double value) { return value > 0.0 && is_drawable(value); });
}

/// Does a curve have values, but none for a logarithmic axis?
inline bool has_only_nonpositive_values(const ChartCurve& curve) {
  return std::any_of(curve.y.begin(), curve.y.end(), is_drawable) && !has_positive_value(curve);
}

/// A curve of a panel as drawn.
struct ChartScene::ShownCurve {
  std::size_t curve = 0;  ///< of the panel
  int colour = 0;
  std::vector<Polyline> pieces = {};
  std::vector<QPolygonF> lines = {};  ///< the same in the scene
  std::vector<Extent> extents = {};   ///< of each line, downward
  /// The first of the curves that this one would hide in the view, and the number of curves in
  /// between.
  std::optional<std::size_t> hides = {};
  int later = 0;
  Alike alike = Alike::Covers;
  /// Interval in which it would hide that curve, in the scene; empty: everywhere.
  std::vector<std::pair<qreal, qreal>> over = {};
  bool partly = false;  ///< elsewhere the two differ, or one of them has no value
};

/// Points of a line in the scene; `limited` to the range of a painter.
[[nodiscard]] QPolygonF line_in_scene(const Polyline& line, const QRectF& area,
                                      const AxisScale& x_axis, const AxisScale& y_axis,
                                      bool limited = true);

/// The parts of a line inside `area`.
[[nodiscard]] std::vector<QPolygonF> clip_to_area(const QPolygonF& line, const QRectF& area);

struct ChartScene::Metrics {
  qreal left, right, top, bottom, gap, legend;
  int title_font, text_font, tick_font;
  qreal line, thin_line;
};

/// Height of small pictures below which their panels need the space between texts.
inline constexpr qreal kLowCompact = 190.0;

/// Between a panel and its legend: rows of mark names, and the steps from these to their lines, so
/// that no step crosses a curve. The number of rows is that of all marks of the page at this width:
/// constant while zooming.
[[nodiscard]] inline qreal mark_step_height(int rows) { return rows > 1 ? 24.0 : 20.0; }
[[nodiscard]] int mark_row_count(const ChartPage& page, int tick_font, qreal width);
[[nodiscard]] qreal mark_labels_height(const ChartPage& page, int tick_font, qreal width);

/// Length of a title next to its panel: into the gaps above and below, up to the next title.
inline qreal available_title_length(const QRectF& area, qreal gap) {
  constexpr qreal kApart = 12.0;
  return area.height() + gap - kApart;
}

}  // namespace adore::desktop
