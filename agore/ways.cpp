#include "agore/ways.hpp"

#include "agore/sketch.hpp"

#include <QPen>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace adore::agore {
namespace {

constexpr double kApart = 6.0;  // distance of frames in pixels above which marks are visibly apart
constexpr double kCell = 2.0;   // pixels within which one mark represents several

double mark_size(double width) { return std::max(4.6, 2.0 * width); }

void draw_dot(QPainter& painter, QPointF at, double size, const QColor& colour) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawEllipse(at, 0.5 * size, 0.5 * size);
}

/// Positions of marks that are visible: a run of a thousand revolutions has a cloud of them.
class Places {
 public:
  explicit Places(const QRectF& area)
      : area_(area),
        columns_(static_cast<std::size_t>(std::max(1.0, std::ceil(area.width() / kCell)) + 1)),
        taken_(columns_ *
               static_cast<std::size_t>(std::max(1.0, std::ceil(area.height() / kCell)) + 1)) {}
  [[nodiscard]] bool take(QPointF at) {
    if (!area_.contains(at)) return false;
    const auto column = static_cast<std::size_t>((at.x() - area_.left()) / kCell),
               row = static_cast<std::size_t>((at.y() - area_.top()) / kCell);
    const bool free = !taken_[row * columns_ + column];
    taken_[row * columns_ + column] = true;
    return free;
  }

 private:
  QRectF area_;
  std::size_t columns_;
  std::vector<bool> taken_;
};

}  // namespace

void draw_frame_mark(QPainter& painter, QPointF at, double width, const QColor& colour) {
  draw_dot(painter, at, mark_size(width), colour);
}

namespace {

/// One stroke of a path, its edge or the line: `extra` pixels wider than the path.
void stroke(QPainter& painter, const QRectF& area, const std::vector<TrajectoryPoint>& way,
            const TrajectoryStyle& look, const QColor& ink, double extra) {
  QPen pen(ink, look.width + extra, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  if (look.dashed) {  // of equal length, however wide the stroke is
    constexpr double kDash = 4.0, kGap = 3.0;
    pen.setDashPattern({kDash / pen.widthF(), kGap / pen.widthF()});
    pen.setCapStyle(Qt::FlatCap);
  }
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  QPolygonF line;
  const auto end_line = [&](std::size_t last) {
    if (line.size() > 1 || (line.size() == 1 && line.front() != way[last].at)) {
      line.append(way[last].at);
      painter.drawPolyline(line);
    }
    line.clear();
  };
  bool marks = false;
  const auto apart = [&](std::size_t i) {
    return i >= way.size() || (way[i].at - way[i - 1].at).manhattanLength() > kApart;
  };
  const auto marked = [&](std::size_t i) {
    if (!way[i].frame) return false;
    const bool before = i > 0 && !way[i].joined, behind = i + 1 < way.size() && !way[i + 1].joined;
    return before || behind || ((i == 0 || apart(i)) && apart(i + 1));
  };
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (i > 0 && !way[i].joined) end_line(i - 1);
    append_visible_point(line, way[i].at);
    marks = marks || marked(i);
  }
  if (!way.empty()) end_line(way.size() - 1);
  if (!marks) return;
  Places places(area);
  const bool pixels = is_raster_target(painter);
  const double size = mark_size(look.width) + extra;
  QPolygonF points;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (!marked(i) || !places.take(way[i].at)) continue;
    if (pixels)
      points.append(way[i].at);
    else
      draw_dot(painter, way[i].at, size, ink);
  }
  // Round ends of lines without length: a cloud of ellipses would be slow.
  painter.setPen(QPen(ink, size, Qt::SolidLine, Qt::RoundCap));
  painter.drawPoints(points);
}

/// Without invalid points (stars in the file): the path is interrupted there.
std::vector<TrajectoryPoint> known_part(const std::vector<TrajectoryPoint>& way) {
  std::vector<TrajectoryPoint> out;
  out.reserve(way.size());
  bool broken = false;
  for (const TrajectoryPoint& point : way) {
    if (!std::isfinite(point.at.x() + point.at.y())) {
      broken = true;
      continue;
    }
    out.push_back(point);
    out.back().joined = point.joined && !broken;
    broken = false;
  }
  return out;
}

}  // namespace

void draw_trajectory(QPainter& painter, const QRectF& area, const std::vector<TrajectoryPoint>& way,
                     const TrajectoryStyle& look) {
  draw_trajectories(painter, area, {way}, look);
}

void draw_trajectories(QPainter& painter, const QRectF& area,
                       const std::vector<std::vector<TrajectoryPoint>>& all,
                       const TrajectoryStyle& look) {
  std::vector<std::vector<TrajectoryPoint>> ways;
  for (const std::vector<TrajectoryPoint>& way : all) ways.push_back(known_part(way));
  if (look.casing.isValid())
    for (const std::vector<TrajectoryPoint>& way : ways)
      stroke(painter, area, way, look, look.casing, 2.0 * look.edge);
  for (const std::vector<TrajectoryPoint>& way : ways)
    stroke(painter, area, way, look, look.colour, 0.0);
}

}  // namespace adore::agore
