#pragma once

#include "desktop/theme.hpp"
#include "drawing/outline.hpp"

#include <QPainterPath>
#include <QPolygonF>
#include <QTransform>

class QPainter;

/// The signs of engineering drawings: arrows, dimension lines, hatching. `place` maps meters to
/// pixels.
namespace adore::adrinput::marks {

/// Section lines at 45°, in the other direction if `mirrored`.
void hatch(QPainter& painter, const QPainterPath& area, const QColor& colour, bool mirrored);
/// Along the polygon with a head at its end; `faint` for an arrow that only shows its sense.
void arrow(QPainter& painter, const QPolygonF& path, const QColor& colour, double width,
           bool faint);
[[nodiscard]] QColor arrow_colour(const desktop::Theme& theme, drawing::Arrow::Kind kind);

void dimension(QPainter& painter, const drawing::Dimension& dimension, const QTransform& place,
               const QColor& colour, double width);
/// Position of the label of a dimension.
[[nodiscard]] QPointF label_point(const drawing::Dimension& dimension, const QTransform& place);
/// Does a label of that width fit into the line?
[[nodiscard]] bool label_fits(const drawing::Dimension& dimension, const QTransform& place,
                              double width);
/// Position of the label of an arrow.
[[nodiscard]] QPointF arrow_label_point(const drawing::Arrow& arrow, const QTransform& place);
/// Is it large enough on the screen to be named without being in focus?
[[nodiscard]] bool needs_label(const drawing::Dimension& dimension, const QTransform& place);
/// Distance of a point from its line.
[[nodiscard]] double distance(const drawing::Dimension& dimension, const QTransform& place,
                              QPointF from);

}  // namespace adore::adrinput::marks
