#pragma once

#include <QImage>
#include <QPoint>
#include <QPolygonF>
#include <QRect>
#include <QRectF>

#include <vector>

class QColor;

/// Ways to and fro of very many points, such as an orbit of a million: what is drawn of them.
namespace adore::desktop {

/// Where values of two axes stand in a picture: x_at + x_per * x, and so upwards.
struct PlaneScale {
  double x_at = 0.0, x_per = 1.0, y_at = 0.0, y_per = 1.0;
  [[nodiscard]] QPointF place(double x, double y) const {
    return {x_at + x_per * x, y_at + y_per * y};
  }
};

/// The parts of a way inside `area` that show something new: a stroke all of whose cells were
/// passed before is left out, so that every place of the way is within a pixel of one that is
/// drawn, and all points of what is drawn are stored ones. Broken where a value is missing.
[[nodiscard]] std::vector<QPolygonF> seen_way(const std::vector<double>& x,
                                              const std::vector<double>& y, const PlaneScale& scale,
                                              const QRectF& area);

/// Short strokes as an image: of each pixel the largest cover by any of them. A general painter
/// takes a microsecond and more for each. Null: nothing is inside.
struct StampImage {
  QImage image;
  QPoint place;  ///< of its upper left corner
};
[[nodiscard]] StampImage stamp_image(const std::vector<QPolygonF>& lines, double width,
                                     const QColor& colour, const QRect& within);

}  // namespace adore::desktop
