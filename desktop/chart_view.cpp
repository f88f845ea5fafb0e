#include "desktop/chart_view.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>

namespace adore::desktop {

ChartView::ChartView(QWidget* parent)
    : QGraphicsView(parent), scene_(new ChartScene(ChartStyle::Page, this)) {
  setScene(scene_);
  setFrameShape(QFrame::NoFrame);
  setRenderHint(QPainter::Antialiasing);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
  setMouseTracking(true);
  setMinimumSize(480, 360);
}

void ChartView::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  scene_->setPageSize(viewport()->size());
}

void ChartView::wheelEvent(QWheelEvent* event) {
  const double centre = scene_->abscissaAt(mapToScene(event->position().toPoint()).x());
  const double factor = std::pow(0.8, event->angleDelta().y() / 120.0);
  scene_->setView(centre - (centre - scene_->viewLow()) * factor,
                  centre + (scene_->viewHigh() - centre) * factor);
  event->accept();
}

void ChartView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  dragging_ = true;
  drag_from_ = scene_->abscissaAt(mapToScene(event->position().toPoint()).x());
}

void ChartView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF position = mapToScene(event->position().toPoint());
  if (dragging_) {
    const double shift = drag_from_ - scene_->abscissaAt(position.x());
    const double low = scene_->viewLow() + shift, high = scene_->viewHigh() + shift;
    const auto& x = scene_->page().x;
    // Moving beyond the data would squeeze the view, so it stops at the ends.
    if (!x.empty() && low >= x.front() && high <= x.back()) scene_->setView(low, high);
  }
  const QString text = scene_->readout(position);
  pointer_ = text.isEmpty() ? -1.0 : position.x();
  emit readoutChanged(text);
  viewport()->update();
}

void ChartView::mouseReleaseEvent(QMouseEvent*) { dragging_ = false; }

void ChartView::mouseDoubleClickEvent(QMouseEvent*) { scene_->resetView(); }

void ChartView::leaveEvent(QEvent* event) {
  pointer_ = -1.0;
  emit readoutChanged({});
  viewport()->update();
  QGraphicsView::leaveEvent(event);
}

void ChartView::drawForeground(QPainter* painter, const QRectF&) {
  if (pointer_ < 0.0) return;
  painter->setPen(QPen(current_theme().accent, 1, Qt::DotLine));
  for (const auto& area : scene_->plotAreas())
    painter->drawLine(QLineF(pointer_, area.top(), pointer_, area.bottom()));
}

}  // namespace adore::desktop
