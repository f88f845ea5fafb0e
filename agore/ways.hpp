#pragma once

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <QRectF>

#include <vector>

/// Paths of bodies through the frames. Between two frames a path is drawn as a line if it is known;
/// frames that are visibly apart are marked, and for an unknown path only these marks are drawn.
namespace adore::agore {

struct TrajectoryPoint {
  QPointF at;           ///< in the picture
  bool joined = false;  ///< is the path from the previous point known?
  bool frame = true;    ///< of a frame, or a point where a body begins to hide the path
};

/// Appearance of a path: color, width, edge of `casing` over bodies, dashes behind bodies.
struct TrajectoryStyle {
  QColor colour;
  double width = 2.0;
  QColor casing{};  ///< invalid: none
  bool dashed = false;
  double edge = 1.2;  ///< of the casing, on each side [pixels]
};

/// `area`: visible area.
void draw_trajectory(QPainter& painter, const QRectF& area, const std::vector<TrajectoryPoint>& way,
                     const TrajectoryStyle& look);
/// Several overlapping paths: edges are drawn below all lines.
void draw_trajectories(QPainter& painter, const QRectF& area,
                       const std::vector<std::vector<TrajectoryPoint>>& ways,
                       const TrajectoryStyle& look);

/// The mark of a frame on a path, centered at a point of the picture.
void draw_frame_mark(QPainter& painter, QPointF at, double width, const QColor& colour);

}  // namespace adore::agore
