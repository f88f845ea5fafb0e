#include "desktop/chart_scene_parts.hpp"

#include <QFontMetricsF>
#include <QGraphicsItem>

#include <algorithm>
#include <array>

namespace adore::desktop {
namespace {

/// Does the stroke touch the rectangle? Not if all corners are on one side of it.
bool touches(const QPointF& a, const QPointF& b, const QRectF& box) {
  if (std::max(a.x(), b.x()) < box.left() || std::min(a.x(), b.x()) > box.right() ||
      std::max(a.y(), b.y()) < box.top() || std::min(a.y(), b.y()) > box.bottom())
    return false;
  bool left = false, right = false;
  for (const QPointF& corner :
       {box.topLeft(), box.topRight(), box.bottomLeft(), box.bottomRight()}) {
    const QPointF along = b - a, to = corner - a;
    const qreal side = along.x() * to.y() - along.y() * to.x();
    left = left || side >= 0.0;
    right = right || side <= 0.0;
  }
  return left && right;
}

/// How many strokes of the lines touch the rectangle; a line of one point is a dot.
int hidden_by(const QRectF& box, const std::vector<QPolygonF>& drawn) {
  int out = 0;
  for (const QPolygonF& line : drawn) {
    if (line.size() == 1) out += box.contains(line.front()) ? 1 : 0;
    for (qsizetype i = 1; i < line.size(); ++i) out += touches(line[i - 1], line[i], box) ? 1 : 0;
  }
  return out;
}

}  // namespace

void ChartScene::addAxisOffset(const AxisScale& y_axis, const QRectF& area, qreal head,
                               qreal legend, const std::vector<QPolygonF>& drawn,
                               const Metrics& m) {
  constexpr qreal kGap = 8.0, kRim = 4.0, kEdge = 2.0;
  auto* base =
      addSimpleText("difference from " + text_of(y_axis.offset_text), ui_font(m.tick_font));
  base->setBrush(theme_->accent);
  const auto beside = [&] { return head + base->boundingRect().width() + kGap < legend; };
  if (!beside()) base->setText("from " + text_of(y_axis.offset_text));
  const QSizeF size = base->boundingRect().size();
  if (beside()) {
    base->setPos(head, area.top() - size.height() - 3.0);
    return;
  }
  std::array<QRectF, 4> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = QRectF({i % 2 == 0 ? area.left() + kRim : area.right() - kRim - size.width(),
                         i < 2 ? area.top() + kEdge : area.bottom() - kEdge - size.height()},
                        size);
  const QRectF& place = *std::min_element(
      corners.begin(), corners.end(),
      [&](const QRectF& a, const QRectF& b) { return hidden_by(a, drawn) < hidden_by(b, drawn); });
  base->setPos(place.topLeft());
  base->setZValue(1.0);
  if (hidden_by(place, drawn) == 0) return;
  QColor paper = theme_->surface;  // readable above a curve that passes there
  paper.setAlpha(215);
  addRect(base->sceneBoundingRect(), Qt::NoPen, paper);
}

}  // namespace adore::desktop
