#include "agore/agore_window.hpp"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace adore::agore {

PictureWidget::PictureWidget(QWidget* parent) : QWidget(parent) {
  setMinimumSize(640, 440);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
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
  painter.drawText(rect(), Qt::AlignCenter, tr("Open an animation file (SOL8) with File > Open."));
}

void PictureWidget::mousePressEvent(QMouseEvent* event) { seek(event->position()); }

void PictureWidget::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) seek(event->position());
}

void PictureWidget::seek(QPointF position) {
  const QRectF bar = MotionPicture::timeBar(rect());
  if (!picture_ || !bar.adjusted(-12, -10, 12, 10).contains(position)) return;
  emit soughtTo(std::clamp((position.x() - bar.left()) / bar.width(), 0.0, 1.0));
}

}  // namespace adore::agore
