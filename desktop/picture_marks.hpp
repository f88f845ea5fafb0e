#pragma once

#include <QBrush>
#include <QColor>
#include <QPen>
#include <QPointF>

class QPainter;

/// Signs that the pictures of all programs share. Positions in pixels.
namespace adore::desktop {

/// Filled head of an arrow; `direction` is a unit vector. `casing`: about it, below its fill.
void draw_arrow_head(QPainter& painter, QPointF tip, QPointF direction, double length,
                     const QColor& colour, const QPen& casing = Qt::NoPen);

/// A round body lit from the upper left: its colors toward the light, in the middle and at the
/// rim.
[[nodiscard]] QBrush ball_brush(QPointF centre, double radius, const QColor& lit,
                                const QColor& middle, const QColor& rim);

}  // namespace adore::desktop
