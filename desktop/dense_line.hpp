#pragma once

#include <QLineF>
#include <QList>
#include <QPolygonF>
#include <QRectF>

#include <vector>

class QPainter;
class QPen;

/// Lines of more points than a screen has columns. Stroking such a zigzag takes seconds, since all
/// of its parts lie over one another; a bar for each column of pixels, from the lowest to the
/// highest place where the line passes it, looks the same, takes microseconds and hides no peak.
namespace adore::desktop {

struct ColumnBar {
  int column = 0;
  double top = 0.0, bottom = 0.0;  ///< y of the line, downwards; top <= bottom
};

/// Where a line whose x never falls passes the columns [i, i + 1) / `scale` from 0 on, between
/// `left` and `right`: one bar for each column that it touches, in order.
std::vector<ColumnBar> column_bars(const QPolygonF& line, double left, double right, double scale);

/// Is it quicker as bars: on a screen, solid, x rising, several points for each of its columns?
bool drawn_as_bars(const QPainter& painter, const QPolygonF& line, const QRectF& area,
                   const QPen& pen);

/// Straight parts of a long way, such as an orbit of many turns, without those that lie on another
/// one to a quarter of a pixel; `scale` pixels to a unit.
[[nodiscard]] QList<QLineF> distinct_parts(const QPolygonF& line, double scale);

/// Draws a line inside `area`, as bars where that is quicker.
void draw_line(QPainter& painter, const QPolygonF& line, const QRectF& area, const QPen& pen);

}  // namespace adore::desktop
