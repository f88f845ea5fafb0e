#pragma once

#include <QImage>
#include <QPoint>
#include <QPolygonF>
#include <QRect>

#include <vector>

class QPen;

/// Strokes of lines that go to the right, as an image: how much of each pixel a round pen covers.
/// A general painter cuts such a stroke into its outline first, which takes several microseconds
/// for each point; here a point takes none and a column of pixels less than one.
namespace adore::desktop {

struct StrokeImage {
  QImage image;  ///< null: nothing is inside
  QPoint place;  ///< of its upper left corner
};

/// `lines` and `width` in pixels; the x of none of them falls. Nothing is drawn outside of
/// `within`.
[[nodiscard]] StrokeImage stroke_image(const std::vector<QPolygonF>& lines, double width,
                                       const QColor& colour, const QRect& within);

}  // namespace adore::desktop
