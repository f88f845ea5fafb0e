#pragma once

#include <QImage>
#include <QPoint>
#include <QPolygonF>
#include <QRect>

#include <vector>

class QPen;

/// Strokes of a round pen and areas with increasing x, as an image of the covered fraction of each
/// pixel. A general painter cuts a stroke into its outline first, which takes several microseconds
/// for each point, and sorts the edges of an outline; here a point takes no
/// measurable time and a column of pixels less than a microsecond.
namespace adore::desktop {

struct StrokeImage {
  QImage image;  ///< null: nothing is inside
  QPoint place;  ///< of its upper left corner
};

/// `lines` and `width` in pixels, with increasing x. Nothing is drawn outside of `within`.
[[nodiscard]] StrokeImage stroke_image(const std::vector<QPolygonF>& lines, double width,
                                       const QColor& colour, const QRect& within);

/// An area of vertical rectangles side by side, as an image of the covered fraction of each pixel.
/// Its outline goes to the right along the upper ends, two points for each, and back along the
/// lower ones.
[[nodiscard]] StrokeImage band_image(const QPolygonF& outline, const QColor& colour);

}  // namespace adore::desktop
