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

/// Ways to and fro of very many points, such as an orbit of a million: what is drawn of them.
namespace adore::desktop {

/// Where values of two axes stand in a picture: x_at + x_per * x, and so upward.
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
/// The same of parts of a way, in order, with all that is up to `margin` pixels outside. Of each
/// cell there the first stroke that passes it is drawn, so that pictures beside each other show the
/// same where they meet.
[[nodiscard]] std::vector<QPolygonF> seen_way(const std::vector<double>& x,
                                              const std::vector<double>& y,
                                              const std::vector<Stretch>& stretches,
                                              const PlaneScale& scale, const QRectF& area,
                                              double margin);

/// Short strokes as an image: of each pixel the largest cover by any of them. A general painter
/// takes a microsecond and more for each. Null: nothing is inside.
struct StampImage {
  QImage image;
  QPoint place;  ///< of its upper left corner
};
[[nodiscard]] StampImage stamp_image(const std::vector<QPolygonF>& lines, double width,
                                     const QColor& colour, const QRect& within);
/// The same as covers of the pixels of `within`, row by row; empty: nothing is inside.
[[nodiscard]] std::vector<std::uint8_t> stamp_cover(const std::vector<QPolygonF>& lines,
                                                    double width, const QRect& within);
/// How far from its middle a stroke covers pixels.
[[nodiscard]] double stamp_reach(double width);
/// The ink of each cover, premultiplied.
[[nodiscard]] std::array<QRgb, 256> inks_of(const QColor& colour);

}  // namespace adore::desktop
