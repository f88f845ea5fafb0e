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
  bool frame = true;    ///< of a frame, or where a body begins to hide the way
};

/// Appearance of a path: color, width, edge of `casing` over bodies, dashes behind bodies.
struct WayLook {
  QColor colour;
  double width = 2.0;
  QColor casing{};  ///< invalid: none
  bool dashed = false;
  double edge = 1.2;  ///< of the casing, on each side [pixels]
};

/// `area`: nothing outside of it is seen.
void draw_way(QPainter& painter, const QRectF& area, const std::vector<WayPoint>& way,
              const WayLook& look);
/// Several over each other: no edge of one lies over another.
void draw_ways(QPainter& painter, const QRectF& area,
               const std::vector<std::vector<WayPoint>>& ways, const WayLook& look);

/// The mark of a frame on a way, about a place of the picture.
void draw_frame_mark(QPainter& painter, QPointF at, double width, const QColor& colour);

}  // namespace adore::agore
