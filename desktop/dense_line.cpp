#include "desktop/dense_line.hpp"

#include "desktop/dense_way.hpp"
#include "desktop/stroke_mask.hpp"

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPen>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace adore::desktop {

std::vector<ColumnBar> column_bars(const QPolygonF& line, double left, double right, double scale) {
  std::vector<ColumnBar> out;
  const auto pass = [&out](int column, double y1, double y2) {
    if (out.empty() || out.back().column != column)
      out.push_back({column, std::min(y1, y2), std::max(y1, y2)});
    out.back().top = std::min({out.back().top, y1, y2});
    out.back().bottom = std::max({out.back().bottom, y1, y2});
  };
  const auto column_of = [scale](double x) { return static_cast<int>(std::floor(x * scale)); };
  const int first = column_of(left), last = column_of(right);
  for (qsizetype i = 0; i + 1 < line.size(); ++i) {
    const QPointF &p = line[i], &q = line[i + 1];
    if (q.x() < left || p.x() > right) continue;
    const int from = std::max(column_of(p.x()), first), to = std::min(column_of(q.x()), last);
    if (column_of(p.x()) == column_of(q.x())) {
      pass(from, p.y(), q.y());
      continue;
    }
    const double slope = (q.y() - p.y()) / (q.x() - p.x());
    const auto at = [&](double x) { return p.y() + slope * (std::clamp(x, p.x(), q.x()) - p.x()); };
    for (int column = from; column <= to; ++column)
      pass(column, at(column / scale), at((column + 1) / scale));
  }
  return out;
}

namespace {

/// Stroking takes hundreds of bytes for each point: a way of a million in one go took 260 MB.
void draw_in_pieces(QPainter& painter, const QPolygonF& line, const QPen& pen) {
  constexpr qsizetype kPiece = 4000;
  if (line.size() <= kPiece || pen.style() != Qt::SolidLine) {
    painter.drawPolyline(line);
    return;
  }
  for (qsizetype first = 0; first + 1 < line.size(); first += kPiece)
    painter.drawPolyline(line.constData() + first,
                         static_cast<int>(std::min(kPiece + 1, line.size() - first)));
}

}  // namespace

bool paints_pixels(const QPainter& painter) {
  const QTransform& placed = painter.deviceTransform();
  return painter.paintEngine() != nullptr &&
         painter.paintEngine()->type() == QPaintEngine::Raster &&
         placed.type() <= QTransform::TxScale && placed.m11() > 0.0 && placed.m22() > 0.0;
}

namespace {

/// Fewer points are stroked as quickly.
constexpr qsizetype kFewest = 16;

bool goes_right(const QPolygonF& line) {
  return line.size() >= kFewest &&
         std::is_sorted(line.begin(), line.end(),
                        [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
}

void draw_strokes(QPainter& painter, const std::vector<QPolygonF>& lines, const QRectF& area,
                  const QPen& pen) {
  const QTransform& placed = painter.deviceTransform();
  std::vector<QPolygonF> on_device;
  on_device.reserve(lines.size());
  for (const QPolygonF& line : lines) on_device.push_back(placed.map(line));
  const StrokeImage strokes = stroke_image(on_device, pen.widthF() * placed.m11(), pen.color(),
                                           placed.mapRect(area).toAlignedRect());
  if (strokes.image.isNull()) return;
  painter.drawImage(placed.inverted().mapRect(QRectF(strokes.place, strokes.image.size())),
                    strokes.image, strokes.image.rect());
}

void draw_stamps(QPainter& painter, const std::vector<QPolygonF>& lines, const QRectF& area,
                 const QPen& pen) {
  const QTransform& placed = painter.deviceTransform();
  std::vector<QPolygonF> on_device;
  on_device.reserve(lines.size());
  for (const QPolygonF& line : lines) on_device.push_back(placed.map(line));
  const StampImage stamps = stamp_image(on_device, pen.widthF() * placed.m11(), pen.color(),
                                        placed.mapRect(area).toAlignedRect());
  if (stamps.image.isNull()) return;
  painter.drawImage(placed.inverted().mapRect(QRectF(stamps.place, stamps.image.size())),
                    stamps.image, stamps.image.rect());
}

}  // namespace

void draw_lines(QPainter& painter, const std::vector<QPolygonF>& lines, const QRectF& area,
                const QPen& pen) {
  painter.save();
  painter.setClipRect(area, Qt::IntersectClip);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  const bool as_strokes = paints_pixels(painter) && pen.style() == Qt::SolidLine;
  constexpr qsizetype kMany = 4000;  // points of ways to and fro
  std::vector<QPolygonF> strokes, ways;
  qsizetype points = 0;
  for (const QPolygonF& line : lines) {
    const bool right = as_strokes && goes_right(line);
    (right ? strokes : ways).push_back(line);
    points += right ? 0 : line.size();
  }
  if (as_strokes && points > kMany)
    draw_stamps(painter, ways, area, pen);
  else
    for (const QPolygonF& line : ways) draw_in_pieces(painter, line, pen);
  if (!strokes.empty()) draw_strokes(painter, strokes, area, pen);
  painter.restore();
}

}  // namespace adore::desktop
