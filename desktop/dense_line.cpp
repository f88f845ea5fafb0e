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

/// Stroking takes hundreds of bytes for each point: a path of a million points at once took 260 MB.
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

bool is_raster_painter(const QPainter& painter) {
  const QTransform& placed = painter.deviceTransform();
  return painter.paintEngine() != nullptr &&
         painter.paintEngine()->type() == QPaintEngine::Raster &&
         placed.type() <= QTransform::TxScale && placed.m11() > 0.0 && placed.m22() > 0.0;
}

namespace {

/// Fewer points are stroked as quickly.
constexpr qsizetype kMinPoints = 16;

bool goes_right(const QPolygonF& line) {
  return line.size() >= kMinPoints &&
         std::is_sorted(line.begin(), line.end(),
                        [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
}

/// Draws an image in device pixels at its position.
template <class Image>
void draw_on_device(QPainter& painter, const Image& made) {
  if (made.image.isNull()) return;
  painter.drawImage(
      painter.deviceTransform().inverted().mapRect(QRectF(made.place, made.image.size())),
      made.image, made.image.rect());
}

std::vector<QPolygonF> on_device(const QPainter& painter, const std::vector<QPolygonF>& lines) {
  std::vector<QPolygonF> out;
  out.reserve(lines.size());
  for (const QPolygonF& line : lines) out.push_back(painter.deviceTransform().map(line));
  return out;
}

}  // namespace

void draw_lines(QPainter& painter, const std::vector<QPolygonF>& lines, const QRectF& area,
                const QPen& pen) {
  painter.save();
  painter.setClipRect(area, Qt::IntersectClip);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  const bool as_strokes = is_raster_painter(painter) && pen.style() == Qt::SolidLine;
  constexpr qsizetype kMany = 4000;  // points of dense oscillations
  std::vector<QPolygonF> strokes, ways;
  qsizetype points = 0;
  for (const QPolygonF& line : lines) {
    const bool right = as_strokes && goes_right(line);
    (right ? strokes : ways).push_back(line);
    points += right ? 0 : line.size();
  }
  const double width = pen.widthF() * painter.deviceTransform().m11();
  const QRect within = painter.deviceTransform().mapRect(area).toAlignedRect();
  if (as_strokes && points > kMany)
    draw_on_device(painter, stamp_image(on_device(painter, ways), width, pen.color(), within));
  else
    for (const QPolygonF& line : ways) draw_in_pieces(painter, line, pen);
  if (!strokes.empty())
    draw_on_device(painter, stroke_image(on_device(painter, strokes), width, pen.color(), within));
  painter.restore();
}

bool draw_band(QPainter& painter, const QPolygonF& outline, const QColor& colour) {
  if (!is_raster_painter(painter)) return false;
  draw_on_device(painter, band_image(painter.deviceTransform().map(outline), colour));
  return true;
}

}  // namespace adore::desktop
