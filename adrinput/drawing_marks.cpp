#include "adrinput/drawing_marks.hpp"

#include "desktop/picture_marks.hpp"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::adrinput::marks {
namespace {

using drawing::Dimension;

constexpr double kShortest = 20.0;  // a shorter dimension line has its arrows outside, px

QPointF map(const QTransform& place, const drawing::Point& p) {
  return place.map(QPointF(p.x, p.y));
}

double length(QPointF v) { return std::hypot(v.x(), v.y()); }

/// Arc of an angle on the screen, from the first to the second ray, the shorter way.
QPolygonF arc_of(const Dimension& d, const QTransform& place) {
  const double r1 = std::hypot(d.from.x - d.centre.x, d.from.y - d.centre.y);
  const double a = std::atan2(d.from.y - d.centre.y, d.from.x - d.centre.x);
  const double b = std::atan2(d.to.y - d.centre.y, d.to.x - d.centre.x);
  const double turn = std::remainder(b - a, 2.0 * std::numbers::pi);
  QPolygonF out;
  for (int i = 0; i <= 24; ++i) {
    const double t = a + turn * i / 24;
    out << place.map(QPointF(d.centre.x + r1 * std::cos(t), d.centre.y + r1 * std::sin(t)));
  }
  return out;
}

}  // namespace

void hatch(QPainter& painter, const QPainterPath& area, const QColor& colour, bool mirrored) {
  // A pattern costs a tenth of lines clipped to the area.
  painter.setPen(Qt::NoPen);
  painter.setBrush(QBrush(colour, mirrored ? Qt::FDiagPattern : Qt::BDiagPattern));
  painter.drawPath(area);
}

void arrow(QPainter& painter, const QPolygonF& path, const QColor& colour, double width,
           bool faint) {
  if (path.size() < 2) return;
  QPen pen(colour, faint ? 0.6 * width : width, faint ? Qt::DotLine : Qt::SolidLine, Qt::FlatCap);
  const QPointF tip = path.back();
  const double size = 4.0 + 3.0 * width;
  // The head has the direction of the last part of its length.
  QPointF from = path.front();
  for (auto p = path.rbegin(); p != path.rend(); ++p) {
    from = *p;
    if (length(tip - from) >= 0.8 * size) break;
  }
  const double long_enough = length(tip - from);
  if (long_enough < 0.5) return;
  const QPointF direction = (tip - from) / long_enough;
  QPolygonF shaft;
  for (const QPointF& p : path)
    if (length(tip - p) > 0.7 * size) shaft << p;
  shaft << tip - direction * 0.7 * size;
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(shaft);
  desktop::draw_arrow_head(painter, tip, direction, std::min(size, 1.5 * long_enough), colour);
}

QColor arrow_colour(const desktop::Theme& theme, drawing::Arrow::Kind kind) {
  switch (kind) {
    case drawing::Arrow::Kind::Load:
      return theme.red;
    case drawing::Arrow::Kind::Moment:
      return theme.curves[3];
    case drawing::Arrow::Kind::Speed:
      return theme.green;
    case drawing::Arrow::Kind::Displacement:
      return theme.curves[1];
    case drawing::Arrow::Kind::Gravity:
      return theme.muted;
  }
  return theme.text;
}

void dimension(QPainter& painter, const Dimension& d, const QTransform& place, const QColor& colour,
               double width) {
  const QPointF from = map(place, d.from), to = map(place, d.to);
  const QPen thin(colour, std::max(0.7, 0.5 * width));
  const QPen line(colour, width);
  const double size = 5.0 + 1.5 * width;
  painter.setBrush(Qt::NoBrush);
  if (d.kind == Dimension::Kind::Angle) {
    const QPointF centre = map(place, d.centre);
    painter.setPen(thin);
    painter.drawLine(centre, from);
    painter.drawLine(centre, to);
    arrow(painter, arc_of(d, place), colour, width, false);
    return;
  }
  if (d.kind == Dimension::Kind::Leader || d.kind == Dimension::Kind::Radius) {
    if (length(to - from) < 1.0) return;
    painter.setPen(line);
    painter.drawLine(from, to);
    desktop::draw_arrow_head(painter, to, (to - from) / length(to - from), size, colour);
    return;
  }
  painter.setPen(thin);
  const QPointF from_edge = map(place, d.from_edge), to_edge = map(place, d.to_edge);
  if (from_edge != from) painter.drawLine(from_edge, from);
  if (to_edge != to) painter.drawLine(to_edge, to);
  const double long_enough = length(to - from);
  QPointF u(1.0, 0.0);
  if (long_enough > 1e-6) {
    u = (to - from) / long_enough;
  } else if (std::abs(d.from.x - d.from_edge.x) > std::abs(d.from.y - d.from_edge.y)) {
    u = {0.0, -1.0};
  }
  painter.setPen(line);
  if (long_enough >= kShortest) {
    // The line of a diameter continues beyond the axis, without an arrowhead there.
    painter.drawLine(from + u * (d.half ? -size : 0.7 * size), to - u * 0.7 * size);
    if (!d.half) desktop::draw_arrow_head(painter, from, -u, size, colour);
    desktop::draw_arrow_head(painter, to, u, size, colour);
    return;
  }
  painter.drawLine(from - u * 18.0, from - u * 0.7 * size);
  painter.drawLine(to + u * 18.0, to + u * 0.7 * size);
  desktop::draw_arrow_head(painter, from, u, size, colour);
  desktop::draw_arrow_head(painter, to, -u, size, colour);
}

QPointF label_point(const Dimension& d, const QTransform& place) {
  const QPointF from = map(place, d.from), to = map(place, d.to);
  if (d.kind == Dimension::Kind::Leader) return from;
  if (d.kind == Dimension::Kind::Radius) return from + 0.6 * (to - from);
  if (d.kind == Dimension::Kind::Angle) {
    const QPolygonF arc = arc_of(d, place);
    return arc[arc.size() / 2];
  }
  const double long_enough = length(to - from);
  if (long_enough < kShortest) {
    const QPointF u = long_enough > 1e-6 ? (to - from) / long_enough : QPointF(1.0, 0.0);
    return to + u * 24.0;
  }
  return 0.5 * (from + to);
}

bool label_fits(const Dimension& d, const QTransform& place, double width) {
  if (d.kind == Dimension::Kind::Leader) return true;
  if (d.kind != Dimension::Kind::Span) return false;
  const QPointF along = map(place, d.to) - map(place, d.from);
  return std::abs(along.x()) > width + 30.0 || std::abs(along.y()) > 60.0;
}

QPointF arrow_label_point(const drawing::Arrow& arrow, const QTransform& place) {
  const QPointF tip = map(place, arrow.path.back());
  if (arrow.path.size() > 2) {  // turning: below its arc
    QPolygonF arc;
    for (const drawing::Point& p : arrow.path) arc << map(place, p);
    return {arc.boundingRect().center().x(), arc.boundingRect().bottom() + 14.0};
  }
  const QPointF along = tip - map(place, arrow.path.front());
  return length(along) > 0.0 ? tip + along / length(along) * 12.0 : tip;
}

bool needs_label(const Dimension& d, const QTransform& place) {
  if (d.kind == Dimension::Kind::Angle) {
    const QPolygonF arc = arc_of(d, place);
    return length(arc.back() - arc.front()) > 4.0;
  }
  return length(map(place, d.to) - map(place, d.from)) > 4.0;
}

double distance(const Dimension& d, const QTransform& place, QPointF from) {
  QPolygonF line;
  if (d.kind == Dimension::Kind::Angle)
    line = arc_of(d, place);
  else
    line = {map(place, d.from), map(place, d.to)};
  double best = 1e300;
  for (qsizetype i = 0; i + 1 < line.size(); ++i) {
    const QPointF along = line[i + 1] - line[i], rel = from - line[i];
    const double squared = QPointF::dotProduct(along, along);
    const double t =
        squared > 0.0 ? std::clamp(QPointF::dotProduct(rel, along) / squared, 0.0, 1.0) : 0.0;
    best = std::min(best, length(rel - along * t));
  }
  return best;
}

}  // namespace adore::adrinput::marks
