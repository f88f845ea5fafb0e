#include "desktop/dense_line.hpp"

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

QList<QLineF> distinct_parts(const QPolygonF& line, double scale) {
  constexpr double kPerPixel = 4.0, kFar = 32767.0;
  constexpr int kSlotBits = 18, kLooks = 8;
  // What was drawn, by its hash; of more than there is room for the latest.
  std::vector<std::uint64_t> drawn(std::size_t{1} << kSlotBits, 0);
  const auto is_new = [&drawn](std::uint64_t part) {
    const std::size_t first = (part * 0x9e3779b97f4a7c15ULL) >> (64 - kSlotBits);
    for (std::size_t i = 0; i < kLooks; ++i) {
      std::uint64_t& slot = drawn[(first + i) & (drawn.size() - 1)];
      if (slot == part) return false;
      if (slot != 0) continue;
      slot = part;
      return true;
    }
    drawn[first] = part;
    return true;
  };
  QList<QLineF> out;
  if (line.isEmpty()) return out;
  struct Place {
    std::uint64_t key = 0;
    bool near = false;
  };
  const auto place = [&](const QPointF& p) -> Place {
    const double x = std::round(kPerPixel * scale * p.x()),
                 y = std::round(kPerPixel * scale * p.y());
    if (!(std::abs(x) < kFar && std::abs(y) < kFar)) return {};
    return {static_cast<std::uint64_t>(x + kFar) << 16 | static_cast<std::uint64_t>(y + kFar),
            true};
  };
  QPointF from = line.front();
  Place at = place(from);
  for (qsizetype i = 1; i < line.size(); ++i) {
    const Place next = place(line[i]);
    if (at.near && next.near) {
      if (at.key == next.key) continue;
      const std::uint64_t part = std::max(at.key, next.key) << 32 | std::min(at.key, next.key);
      if (is_new(part)) out.append({from, line[i]});
    } else {
      out.append({from, line[i]});
    }
    from = line[i];
    at = next;
  }
  return out;
}

namespace {

/// Stroking takes hundreds of bytes for each point: an orbit of a million in one go took 260 MB.
void draw_in_pieces(QPainter& painter, const QPolygonF& line, const QPen& pen) {
  constexpr qsizetype kPiece = 4000;
  if (line.size() <= kPiece || pen.style() != Qt::SolidLine) {
    painter.drawPolyline(line);
    return;
  }
  if (painter.paintEngine() != nullptr && painter.paintEngine()->type() == QPaintEngine::Raster) {
    painter.drawLines(distinct_parts(line, painter.deviceTransform().m11()));
    return;
  }
  for (qsizetype first = 0; first + 1 < line.size(); first += kPiece)
    painter.drawPolyline(line.constData() + first,
                         static_cast<int>(std::min(kPiece + 1, line.size() - first)));
}

}  // namespace

namespace {

/// Is the painter one of pixels, which are whole ones of its own?
bool paints_pixels(const QPainter& painter) {
  const QTransform& placed = painter.deviceTransform();
  return painter.paintEngine() != nullptr &&
         painter.paintEngine()->type() == QPaintEngine::Raster &&
         placed.type() <= QTransform::TxScale && placed.m11() > 0.0 && placed.m22() > 0.0;
}

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

}  // namespace

void draw_lines(QPainter& painter, const std::vector<QPolygonF>& lines, const QRectF& area,
                const QPen& pen) {
  painter.save();
  painter.setClipRect(area, Qt::IntersectClip);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  const bool as_strokes = paints_pixels(painter) && pen.style() == Qt::SolidLine;
  std::vector<QPolygonF> strokes;
  for (const QPolygonF& line : lines) {
    if (as_strokes && goes_right(line))
      strokes.push_back(line);
    else
      draw_in_pieces(painter, line, pen);
  }
  if (!strokes.empty()) draw_strokes(painter, strokes, area, pen);
  painter.restore();
}

}  // namespace adore::desktop
