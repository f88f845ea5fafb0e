#include "adrinput/drawing_layout.hpp"
#include "adrinput/drawing_marks.hpp"
#include "adrinput/drawing_view.hpp"
#include "desktop/theme.hpp"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

/// Names and dimensions of a drawing, written in free areas.
namespace adore::adrinput {

using desktop::Theme;
using drawing::Part;

void DrawingView::writeLabels(QPainter& painter, const drawing::Pane& pane,
                              const PaneLayout& frame) {
  const Theme& t = desktop::current_theme();
  const QRectF area =
      pane.axes.empty() ? frame.area : frame.area.adjusted(kAxisLeft, 0.0, 0.0, -kAxisBottom);
  const auto middle = [&](const drawing::Dimension& d) {
    return marks::label_point(d, frame.place);
  };
  for (const drawing::Dimension& d : pane.dimensions)
    if (isInFocusedRecord(d.variable) && inFocus(d))
      writeLabel(painter, area, middle(d), text_of(d.label), true, t.accent,
                 marks::label_fits(d, frame.place, text_of(d.label).size() * 8.0) ? 0.0 : 12.0);
  for (const drawing::Arrow& arrow : pane.arrows)
    if (inFocus(arrow) && !arrow.path.empty())
      writeLabel(painter, area, marks::arrow_label_point(arrow, frame.place), text_of(arrow.label),
                 true, t.accent);
  if (!focus_has_dimension_ && &pane == &drawing_.panes.front() && !focus_.variable.empty()) {
    // The body that the field speaks of, or the curve, carries its name.
    for (const drawing::Shape& shape : pane.shapes) {
      if (!inFocus(shape) || focus_.variable == "recID" || focus_label_.isEmpty()) continue;
      const QRectF box = path_of(shape, frame.place, false).boundingRect().intersected(area);
      writeLabel(painter, area, QPointF(box.center().x(), box.top() + 0.25 * box.height()),
                 focus_label_, true, t.accent);
      break;
    }
  }
  for (const drawing::Caption& caption : pane.captions) {
    if (caption.room > 0.0 && caption.room * frame.place.m11() < 16.0) continue;
    const QPointF at = frame.place.map(QPointF(caption.at.x, caption.at.y));
    painter.setFont(desktop::ui_font(kText, true));
    const QFontMetricsF metrics(painter.font());
    const QString text = text_of(caption.text);
    QRectF box = metrics.boundingRect(text);
    box.moveCenter(at);
    if (std::any_of(labels_.begin(), labels_.end(),
                    [&](const Label& label) { return label.box.intersects(box); }))
      continue;
    painter.setPen(t.text);
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
    labels_.push_back({box, text, false});
  }
  for (const drawing::Arrow& arrow : pane.arrows)
    if (arrow.value != 0.0 && !inFocus(arrow) && !arrow.path.empty())
      writeLabel(painter, area, marks::arrow_label_point(arrow, frame.place), text_of(arrow.label),
                 false, marks::arrow_colour(t, arrow.kind));
  for (const drawing::Dimension& d : pane.dimensions)
    if (isDimensionVisible(d) && !inFocus(d) && marks::needs_label(d, frame.place)) {
      const QString name =
          (d.half ? QString::fromUtf8("\u2300 ") : QString()) + text_of(d.variable);
      if (writeAlongDimension(painter, area, d, frame.place, name)) continue;
      if (writeLabel(painter, area, middle(d), name, false, t.muted) &&
          d.kind == drawing::Dimension::Kind::Leader)
        paintDimension(painter, d, frame.place);
    }
  if (!pane.axes.empty())
    for (const drawing::Shape& shape : pane.shapes) {
      if (shape.part != Part::Curve || shape.paths.empty() || pane.shapes.size() < 2) continue;
      const drawing::Path& path = shape.paths.front();
      const drawing::Point& p = path[path.size() * 3 / 4];
      writeLabel(painter, area, frame.place.map(QPointF(p.x, p.y)), text_of(shape.name), false,
                 inFocus(shape) ? t.accent : t.muted);
    }
}

/// A name along a vertical line, as in engineering drawings: lines are closer than names are long.
bool DrawingView::writeAlongDimension(QPainter& painter, const QRectF& area,
                                      const drawing::Dimension& d, const QTransform& place,
                                      const QString& text) {
  const QPointF from = place.map(QPointF(d.from.x, d.from.y)),
                to = place.map(QPointF(d.to.x, d.to.y));
  painter.setFont(desktop::ui_font(kText));
  const QSizeF size =
      QFontMetricsF(painter.font()).size(Qt::TextSingleLine, text) + QSizeF(6.0, 0.0);
  if (d.kind != drawing::Dimension::Kind::Span || std::abs(to.x() - from.x()) > 1.0 ||
      std::abs(to.y() - from.y()) < size.width() + 24.0)
    return false;
  QRectF box(QPointF(), size.transposed());
  box.moveCenter(0.5 * (from + to));
  if (!area.contains(box) || std::any_of(labels_.begin(), labels_.end(), [&](const Label& label) {
        return label.box.intersects(box);
      }))
    return false;
  const Theme& t = desktop::current_theme();
  QColor ground = t.surface;
  ground.setAlpha(230);
  painter.fillRect(box, ground);
  painter.save();
  painter.translate(box.center());
  painter.rotate(-90.0);
  painter.setPen(t.muted);
  painter.drawText(QRectF(-0.5 * size.width(), -0.5 * size.height(), size.width(), size.height()),
                   Qt::AlignCenter, text);
  painter.restore();
  labels_.push_back({box, text, false});
  return true;
}

bool DrawingView::writeLabel(QPainter& painter, const QRectF& area, QPointF near,
                             const QString& text, bool strong, const QColor& colour, double free) {
  painter.setFont(desktop::ui_font(strong ? 12 : kText, strong));
  const QFontMetricsF metrics(painter.font());
  QSizeF size = metrics.size(Qt::TextSingleLine, text) + QSizeF(6, 2);
  size.setWidth(std::min(size.width(), area.width()));
  // Around the point in eight directions, then farther out.
  for (const double distance : {0.0, 16.0, 28.0, 44.0, 70.0, 100.0}) {
    if (distance < free) continue;
    for (int direction = 0; direction < (distance == 0.0 ? 1 : 8); ++direction) {
      const double a = (direction * 0.25 + 0.5) * 3.14159265358979;
      QRectF box(QPointF(), size);
      box.moveCenter(near + QPointF(std::cos(a) * (distance + 0.5 * size.width() *
                                                                  (distance > 0.0 ? 1.0 : 0.0)),
                                    -std::sin(a) * distance));
      if (strong) {
        box.moveLeft(std::clamp(box.left(), area.left(), area.right() - box.width()));
        box.moveTop(std::clamp(box.top(), area.top(), area.bottom() - box.height()));
      }
      if (!area.contains(box.adjusted(0.5, 0.5, -0.5, -0.5))) continue;
      if (std::any_of(labels_.begin(), labels_.end(),
                      [&](const Label& label) { return label.box.intersects(box); }))
        continue;
      const Theme& t = desktop::current_theme();
      QColor ground = t.surface;
      ground.setAlpha(strong ? 235 : 190);
      painter.setPen(strong ? QPen(colour, 1) : QPen(Qt::NoPen));
      painter.setBrush(ground);
      painter.drawRoundedRect(box, 3, 3);
      painter.setPen(colour);
      painter.drawText(box, Qt::AlignCenter,
                       metrics.elidedText(text, Qt::ElideRight, box.width() - 4));
      labels_.push_back({box, text, strong});
      return true;
    }
  }
  return false;
}

}  // namespace adore::adrinput
