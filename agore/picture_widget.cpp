#include "agore/agore_window.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace adore::agore {

PictureWidget::PictureWidget(QWidget* parent) : QWidget(parent) {
  setMinimumSize(520, 380);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Picture of the bearing"));
}

void PictureWidget::show(MotionPicture* picture, std::size_t frame, const ViewOptions& options) {
  picture_ = picture;
  frame_ = frame;
  options_ = options;
  update();
}

void PictureWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (picture_) {
    picture_->paint(painter, rect(), frame_, options_);
    return;
  }
  const auto& t = theme_of(options_);
  painter.fillRect(rect(), t.surface);
  painter.setPen(t.muted);
  painter.setFont(desktop::ui_font(14));
  painter.drawText(
      rect(), Qt::AlignCenter,
      tr("Open an animation file (SOL8 or RESULTS.h5) with File > Open, or drop one here."));
}

void PictureWidget::mousePressEvent(QMouseEvent* event) {
  drag_from_ = event->position();
  pan_from_ = options_.pan;
  seek(event->position());
}

void PictureWidget::mouseMoveEvent(QMouseEvent* event) {
  if (!picture_ || !(event->buttons() & Qt::LeftButton) || seek(event->position())) return;
  const QRectF area = MotionPicture::pictureArea(rect());
  if (!area.contains(drag_from_)) return;
  const QPointF way = event->position() - drag_from_;
  emit viewMoved(options_.zoom,
                 pan_from_ + QPointF(way.x() / area.width(), way.y() / area.height()));
}

void PictureWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (MotionPicture::pictureArea(rect()).contains(event->position())) emit viewMoved(1.0, {0, 0});
}

void PictureWidget::wheelEvent(QWheelEvent* event) {
  const QRectF area = MotionPicture::pictureArea(rect());
  if (!picture_ || !area.contains(event->position())) return event->ignore();
  const double zoom =
      std::clamp(options_.zoom * std::pow(1.25, event->angleDelta().y() / 120.0), 1.0, 200.0);
  // What lies under the pointer stays there.
  const QPointF from = event->position() - area.center();
  const QPointF here(from.x() / area.width(), from.y() / area.height());
  const QPointF pan = here + (options_.pan - here) * (zoom / options_.zoom);
  emit viewMoved(zoom, zoom == 1.0 ? QPointF(0.0, 0.0) : pan);
  event->accept();
}

bool PictureWidget::seek(QPointF position) {
  if (!picture_) return false;
  const QRectF bar = MotionPicture::timeBar(rect());
  if (bar.adjusted(-12, -10, 12, 10).contains(position)) {
    emit soughtTo(std::clamp((position.x() - bar.left()) / bar.width(), 0.0, 1.0));
    return true;
  }
  const auto time = picture_->timeAt(rect(), position);
  if (time) emit soughtFrame(picture_->frameAt(*time));
  return time.has_value();
}

}  // namespace adore::agore
