#include "desktop/chart_scene_parts.hpp"

#include <QGraphicsItem>
#include <QPainter>

#include <algorithm>

/// Frames of panels: the lines at their ticks. One item draws all of a panel's.
namespace adore::desktop {
namespace {

class GridItem : public QGraphicsItem {
 public:
  /// @param aside distance of the vertical axis from the area: the start of a curve is not on it
  GridItem(const QRectF& area, std::vector<qreal> across, std::vector<qreal> up, bool axis_up,
           qreal aside, const Theme& theme)
      : area_(area),
        across_(std::move(across)),
        up_(std::move(up)),
        axis_up_(axis_up),
        left_(area.left() - (axis_up ? aside : 0.0)),
        grid_(theme.grid, 1),
        frame_(theme.frame, 1) {}
  [[nodiscard]] QRectF boundingRect() const override {
    return area_.adjusted(left_ - area_.left() - kTick - 1.0, -1.0, 1.0, kTick + 1.0);
  }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    painter->setPen(grid_);
    for (const qreal x : across_) painter->drawLine(QLineF(x, area_.top(), x, area_.bottom()));
    for (const qreal y : up_) painter->drawLine(QLineF(left_, y, area_.right(), y));
    painter->setPen(frame_);
    painter->drawLine(QLineF(left_, area_.bottom(), area_.right(), area_.bottom()));
    for (const qreal x : across_)
      painter->drawLine(QLineF(x, area_.bottom(), x, area_.bottom() + kTick));
    if (!axis_up_) return;
    painter->drawLine(QLineF(left_, area_.top(), left_, area_.bottom()));
    for (const qreal y : up_)
      painter->drawLine(QLineF(std::min(area_.left() - kTick, left_ - kShort), y, left_, y));
  }

 private:
  static constexpr qreal kTick = 4.0, kShort = 3.0;
  QRectF area_;
  std::vector<qreal> across_, up_;
  bool axis_up_;
  qreal left_;  ///< the upright axis
  QPen grid_, frame_;
};

/// Positions of the ticks along an axis with that many pixels.
std::vector<qreal> places(const std::vector<AxisTick>& ticks, const AxisScale& axis, qreal length) {
  std::vector<qreal> out;
  for (const AxisTick& tick : ticks)
    out.push_back(std::clamp((tick.at - axis.min) / (axis.max - axis.min), 0.0, 1.0) * length);
  return out;
}

}  // namespace

void ChartScene::addFrame(const QRectF& area, const AxisScale& x_scale, const AxisScale& y_scale,
                          const QString& x_title, const QString& y_title, bool x_labels,
                          bool y_labels, const Metrics& m) {
  lines_.push_back(0);
  if (page_.schematic) return;
  const std::vector<AxisTick> x_ticks = axis_ticks(x_scale),
                              y_ticks = y_labels ? axis_ticks(y_scale) : std::vector<AxisTick>();
  std::vector<qreal> across = places(x_ticks, x_scale, area.width()),
                     up = places(y_ticks, y_scale, area.height());
  for (qreal& x : across) x += area.left();
  for (qreal& y : up) y = area.bottom() - y;
  constexpr qreal kAside = 4.0;
  addItem(new GridItem(area, std::move(across), std::move(up), y_labels,
                       page_.equal_axes ? 0.0 : kAside, *theme_));
  addLabels(area, x_scale, y_scale, x_title, y_title, x_labels ? x_ticks : std::vector<AxisTick>(),
            y_ticks, m);
}

}  // namespace adore::desktop
