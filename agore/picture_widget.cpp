#include "agore/agore_window.hpp"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace adore::agore {

PictureWidget::PictureWidget(QWidget* parent) : QWidget(parent) {
  setMinimumSize(480, 326);  // fits a screen of 640x480 with the buttons and the view bar
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Picture of the bearing"));
  setFocusPolicy(Qt::StrongFocus);  // a screen reader announces the focus
  tell();
}

void PictureWidget::show(MotionPicture* picture, std::size_t frame, const ViewOptions& options) {
  picture_ = picture;
  frame_ = frame;
  options_ = options;
  tell();
  update();
}

/// Views, frame and time for screen readers. They are announced when playing stops, because nobody
/// could follow the frames.
void PictureWidget::tell() {
  QString told = tr("No file is open.");
  if (picture_) {
    QStringList views;
    for (std::size_t i = 0; i < 1 + options_.beside.size(); ++i) {
      const ViewOptions of = options_.tile(i);
      QString view = QString::fromStdString(view_title(of.view));
      if (of.view == View::Pocket || of.view == View::Element || of.view == View::Flange ||
          of.view == View::Section || of.view == View::Raceways)
        view += " " + QString::number(of.element);
      views << view;
    }
    told = views.join(", ") + "; ";
    if (options_.moving)
      told += tr("playing");
    else
      told += tr("frame %1 of %2, %3")
                  .arg(frame_ + 1)
                  .arg(picture_->frames())
                  .arg(QString::fromStdString(
                      desktop::pretty_quantity(picture_->animation().time.at(frame_), "s", 5)));
  }
  if (told != accessibleDescription()) setAccessibleDescription(told);
}

void PictureWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (picture_) {
    ViewOptions now = options_;
    now.moving = now.moving || rotating_view_;
    picture_->paint(painter, rect(), frame_, now);
    return;
  }
  const auto& t = theme_of(options_);
  painter.fillRect(rect(), t.surface);
  painter.setPen(t.muted);
  painter.setFont(desktop::ui_font(14));
  painter.drawText(rect(), Qt::AlignCenter,
                   tr("Open (File > Open) or drop an animation file (SOL8 or RESULTS.h5)."));
}

std::optional<std::size_t> PictureWidget::tileAt(QPointF position) const {
  if (!picture_) return std::nullopt;
  const auto tiles =
      MotionPicture::pictureAreas(rect(), 1 + options_.beside.size(), options_.shown);
  for (std::size_t i = 0; i < tiles.size(); ++i)
    if (tiles[i].contains(position)) return i;
  return std::nullopt;
}

void PictureWidget::mousePressEvent(QMouseEvent* event) {
  repeat_range_start_.reset();
  moved_ = false;
  drag_from_ = event->position();
  if (event->modifiers() & Qt::ShiftModifier) {
    drag_tile_ = tileAt(drag_from_);
    repeat_range_start_ = timeAtPosition(drag_from_);
    if (repeat_range_start_) return;
  }
  drag_tile_ = tileAt(drag_from_);
  rotating_view_ = false;
  if (drag_tile_) {
    const ViewOptions tile = options_.tile(*drag_tile_);
    pan_from_ = tile.pan;
    rotating_view_ = tile.view == View::Solid && !(event->modifiers() & Qt::ShiftModifier);
    yaw_from_ = options_.yaw, elevation_from_ = options_.elevation;
  }
  seek(event->position());
}

void PictureWidget::mouseMoveEvent(QMouseEvent* event) {
  if (!picture_ || !(event->buttons() & Qt::LeftButton)) return;
  moved_ = moved_ ||
           (event->position() - drag_from_).manhattanLength() > QApplication::startDragDistance();
  if (repeat_range_start_) {
    // Keeps the height at which dragging began.
    const auto to = timeAtPosition({event->position().x(), drag_from_.y()});
    if (to && *to != *repeat_range_start_) emit repeatRangeMarked(*repeat_range_start_, *to);
    return;
  }
  if (!drag_tile_) {
    seek(event->position());
    return;
  }
  const auto tiles =
      MotionPicture::pictureAreas(rect(), 1 + options_.beside.size(), options_.shown);
  if (*drag_tile_ >= tiles.size()) return;
  const QRectF& area = tiles[*drag_tile_];
  const QPointF way = event->position() - drag_from_;
  if (rotating_view_) {
    constexpr double kPerPixel = 0.4;  // [degrees]
    emit eyeMoved(std::remainder(yaw_from_ - kPerPixel * way.x(), 360.0),
                  std::clamp(elevation_from_ + kPerPixel * way.y(), -89.0, 89.0));
    return;
  }
  emit viewMoved(*drag_tile_, options_.tile(*drag_tile_).zoom,
                 pan_from_ + QPointF(way.x() / area.width(), way.y() / area.height()));
}

void PictureWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (picture_ && drag_tile_ && !moved_ && !repeat_range_start_ &&
      event->button() == Qt::LeftButton)
    if (const auto element = picture_->elementAt(rect(), event->position(), frame_, options_))
      emit elementPicked(*element);
  const bool was = std::exchange(rotating_view_, false);
  if (was) update();  // the finer picture
}

void PictureWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  const auto tile = tileAt(event->position());
  if (!tile) return;
  if (options_.tile(*tile).view == View::Solid)
    emit eyeMoved(ViewOptions{}.yaw, ViewOptions{}.elevation);
  emit viewMoved(*tile, 1.0, {0, 0});
}

void PictureWidget::wheelEvent(QWheelEvent* event) {
  const auto number = tileAt(event->position());
  if (!number) return event->ignore();
  const QRectF area =
      MotionPicture::pictureAreas(rect(), 1 + options_.beside.size(), options_.shown).at(*number);
  const ViewOptions tile = options_.tile(*number);
  const double zoom =
      std::clamp(tile.zoom * std::pow(1.25, event->angleDelta().y() / 120.0), 1.0, 200.0);
  // The point under the pointer stays there.
  const QPointF from = event->position() - picture_middle(picture_->animation(), tile, area);
  const QPointF here(from.x() / area.width(), from.y() / area.height());
  const QPointF pan = here + (tile.pan - here) * (zoom / tile.zoom);
  emit viewMoved(*number, zoom, zoom == 1.0 ? QPointF(0.0, 0.0) : pan);
  event->accept();
}

namespace {

/// Time at a position of the time bar, with some tolerance; none elsewhere.
std::optional<double> progress_at(const QRectF& area, QPointF position) {
  const QRectF bar = MotionPicture::timeBar(area);
  if (!bar.adjusted(-12, -10, 12, 10).contains(position)) return std::nullopt;
  return std::clamp((position.x() - bar.left()) / bar.width(), 0.0, 1.0);
}

}  // namespace

bool PictureWidget::seek(QPointF position) {
  if (!picture_) return false;
  if (const auto progress = progress_at(rect(), position)) {
    emit progressRequested(*progress);
    return true;
  }
  const auto time = picture_->timeAt(rect(), position, options_.shown);
  if (time) emit frameRequested(picture_->frameAt(*time));
  return time.has_value();
}

std::optional<double> PictureWidget::timeAtPosition(QPointF position) const {
  if (!picture_) return std::nullopt;
  const auto& time = picture_->animation().time;
  if (const auto progress = progress_at(rect(), position))
    return time.front() + *progress * (time.back() - time.front());
  return picture_->timeAt(rect(), position, options_.shown);
}

}  // namespace adore::agore
