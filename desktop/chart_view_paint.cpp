#include "desktop/chart_view.hpp"

#include <QPainter>

/// Overlays of a view over its charts: current point, cursors, keyboard focus.
namespace adore::desktop {

void ChartView::drawForeground(QPainter* painter, const QRectF&) {
  if (hasFocus()) drawFocus(*painter);
  drawDropTarget(*painter);
  const auto line = [&](double x) {
    for (const auto& area : scene_->plotAreas())
      painter->drawLine(QLineF(x, area.top(), x, area.bottom()));
  };
  if (pointer_line_x_ >= 0.0) {
    painter->setPen(QPen(current_theme().accent, 1, Qt::DotLine));
    line(pointer_line_x_);
  }
  if (scene_->plotAreas().empty()) return;
  if (scene_->page().equal_axes) {
    const auto ring = [&](const QPointF& at, const QPen& pen) {
      constexpr qreal kRadius = 6.0;
      painter->setPen(pen);
      painter->setBrush(Qt::NoBrush);
      painter->drawEllipse(at, kRadius, kRadius);
    };
    if (hovered_plane_point_) ring(*hovered_plane_point_, QPen(current_theme().accent, 1.2));
    for (std::size_t i = 0; i < cursors_.size(); ++i) {
      const auto at = planeCursor(i);
      if (!at) continue;
      ring(*at, QPen(current_theme().red, 1.2));
      painter->setFont(ui_font(12, true));
      painter->drawText(*at + QPointF(9, -5), i == 0 ? "A" : "B");
    }
    return;
  }
  for (std::size_t i = 0; i < cursors_.size(); ++i) {
    if (!(cursors_[i] >= scene_->viewLow() && cursors_[i] <= scene_->viewHigh())) continue;
    const double x = scene_->sceneXAt(cursors_[i]);
    painter->setPen(QPen(current_theme().red, 1.2));
    line(x);
    painter->setFont(ui_font(12, true));
    painter->drawText(QPointF(x + 4, scene_->plotAreas().front().top() + 13), i == 0 ? "A" : "B");
  }
}

/// A frame while the chart has the focus, and a bar next to the panel of the keys.
void ChartView::drawFocus(QPainter& painter) const {
  constexpr qreal kWidth = 2.0, kBar = 4.0;
  painter.setPen(QPen(current_theme().accent, kWidth));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(viewport()->rect()).adjusted(1, 1, -1, -1));
  const auto& areas = scene_->plotAreas();
  if (areas.size() < 2 || panel_ >= areas.size()) return;
  const QRectF& area = areas[panel_];
  painter.fillRect(QRectF(area.left() - kBar, area.top(), kBar, area.height()),
                   current_theme().accent);
}

void ChartView::focusInEvent(QFocusEvent* event) {
  QGraphicsView::focusInEvent(event);
  viewport()->update();
}

void ChartView::focusOutEvent(QFocusEvent* event) {
  QGraphicsView::focusOutEvent(event);
  viewport()->update();
}

}  // namespace adore::desktop
