#pragma once

#include "desktop/way_runs.hpp"

#include <QImage>
#include <QPoint>
#include <QPolygonF>
#include <QRect>
#include <QRectF>
#include <QRgb>

#include <array>
#include <cstdint>
#include <vector>

class QColor;

/// Paths of very many points, such as an orbit of a million: selects the strokes to draw.
namespace adore::desktop {

/// Mapping of values of two axes to the picture: x_at + x_per * x, and the same upward.
struct PlaneScale {
  double x_at = 0.0, x_per = 1.0, y_at = 0.0, y_per = 1.0;
  [[nodiscard]] QPointF place(double x, double y) const {
    return {x_at + x_per * x, y_at + y_per * y};
  }
};

/// The strokes of a path inside `area` that show something new: a stroke whose cells were all
/// visited before is omitted, so that every point of the path is within a pixel of a drawn one, and
/// all drawn points are stored ones. Interrupted at missing values.
[[nodiscard]] std::vector<QPolygonF> visible_path_strokes(const std::vector<double>& x,
                                                          const std::vector<double>& y,
                                                          const PlaneScale& scale,
                                                          const QRectF& area);
/// The same for parts of a path, in order, including strokes up to `margin` pixels outside. For
/// each cell there the first stroke through it is drawn, so that adjacent pictures agree at their
/// common edge.
[[nodiscard]] std::vector<QPolygonF> visible_path_strokes(const std::vector<double>& x,
                                                          const std::vector<double>& y,
                                                          const std::vector<PointRange>& stretches,
                                                          const PlaneScale& scale,
                                                          const QRectF& area, double margin);

/// Short strokes as an image: for each pixel the largest coverage by any of them. A general painter
/// takes at least a microsecond for each. Null: nothing is inside.
struct StampImage {
  QImage image;
  QPoint place;  ///< of its upper left corner
};
[[nodiscard]] StampImage stamp_image(const std::vector<QPolygonF>& lines, double width,
                                     const QColor& colour, const QRect& within);
/// The same as covers of the pixels of `within`, row by row; empty: nothing is inside.
[[nodiscard]] std::vector<std::uint8_t> stamp_coverage(const std::vector<QPolygonF>& lines,
                                                       double width, const QRect& within);
/// How far from its middle a stroke covers pixels.
[[nodiscard]] double stamp_radius(double width);
/// The ink of each cover, premultiplied.
[[nodiscard]] std::array<QRgb, 256> premultiplied_inks(const QColor& colour);

}  // namespace adore::desktop
