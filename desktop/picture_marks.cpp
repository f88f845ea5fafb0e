#include "desktop/picture_marks.hpp"

#include <QPainter>
#include <QPolygonF>
#include <QRadialGradient>

namespace adore::desktop {

void draw_arrow_head(QPainter& painter, QPointF tip, QPointF direction, double length,
                     const QColor& colour, const QPen& casing) {
  const QPointF across(-direction.y(), direction.x());
  const QPolygonF head({tip, tip - direction * length + across * length * 0.42,
                        tip - direction * length - across * length * 0.42});
  painter.setBrush(colour);
  if (casing.style() != Qt::NoPen) {
    painter.setPen(casing);
    painter.drawPolygon(head);
  }
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(head);
}

QBrush ball_brush(QPointF centre, double radius, const QColor& lit, const QColor& middle,
                  const QColor& rim) {
  QRadialGradient shine(centre - QPointF(0.35, 0.4) * radius, 1.5 * radius);
  shine.setColorAt(0, lit);
  shine.setColorAt(0.45, middle);
  shine.setColorAt(1, rim);
  return shine;
}

}  // namespace adore::desktop
