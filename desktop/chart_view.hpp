#pragma once

#include "desktop/chart_scene.hpp"

#include <QGraphicsView>

namespace adore::desktop {

/// A ChartScene in a window: the wheel zooms along the abscissa, dragging moves, a double click
/// shows everything again, and the values under the pointer are reported.
class ChartView : public QGraphicsView {
  Q_OBJECT
 public:
  explicit ChartView(QWidget* parent = nullptr);
  [[nodiscard]] ChartScene& chartScene() { return *scene_; }

 signals:
  void readoutChanged(const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;
  void leaveEvent(QEvent* event) override;

 private:
  ChartScene* scene_;
  bool dragging_ = false;
  double drag_from_ = 0.0;
  double pointer_ = -1.0;  ///< scene x of the pointer's line; negative = none
};

}  // namespace adore::desktop
