#pragma once

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <QRectF>

#include <vector>

/// Ways of bodies through the frames. Between two frames a way is drawn as a line where it is
/// known; frames that are seen apart are marked, and where the way is not known nothing else is
/// drawn.
namespace adore::agore {

struct WayPoint {
  QPointF at;           ///< in the picture
  bool joined = false;  ///< is the way from the point before known?
};

/// `area`: nothing outside of it is seen.
void draw_way(QPainter& painter, const QRectF& area, const std::vector<WayPoint>& way,
              const QColor& colour, double width);

/// The mark of a frame on a way, about a place of the picture.
void draw_frame_mark(QPainter& painter, QPointF at, double width, const QColor& colour);

}  // namespace adore::agore
