#pragma once

#include <QPolygonF>
#include <QRectF>

#include <vector>

class QColor;
class QPainter;
class QPen;

/// Lines of more points than a screen has columns. Stroking such a zigzag takes seconds, because
/// its parts overlap; the minimum and maximum of the line in each column of pixels take
/// microseconds and keep all peaks.
namespace adore::desktop {

struct ColumnBar {
  int column = 0;
  double top = 0.0, bottom = 0.0;  ///< y of the line, downward; top <= bottom
};

/// Range of a line with increasing x in the columns [i, i + 1) / `scale` from 0 on, between `left`
/// and `right`: one bar for each column that it touches, in order.
std::vector<ColumnBar> column_bars(const QPolygonF& line, double left, double right, double scale);

/// Does the painter draw on pixels, with whole pixel coordinates?
[[nodiscard]] bool is_raster_painter(const QPainter& painter);

/// Draws lines inside `area`; on a screen those with increasing x by stroke_mask.hpp, oscillating
/// paths of many points by dense_way.hpp.
void draw_lines(QPainter& painter, const std::vector<QPolygonF>& lines, const QRectF& area,
                const QPen& pen);

/// Fills an area of upright rectangles by stroke_mask.hpp. False: not on a screen, nothing is
/// drawn.
bool draw_band(QPainter& painter, const QPolygonF& outline, const QColor& colour);

}  // namespace adore::desktop
