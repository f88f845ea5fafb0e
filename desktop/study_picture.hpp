#pragma once

#include "desktop/study_chart.hpp"
#include "desktop/theme.hpp"

#include <QGraphicsItem>

#include <memory>
#include <utility>

namespace adore::desktop {

/// A picture of a study as the only thing of a scene.
class StudyPicture : public QGraphicsItem {
 public:
  StudyPicture(std::shared_ptr<const StudyChart> chart, const Theme& theme, QSizeF size)
      : chart_(std::move(chart)), theme_(theme), size_(size) {}
  [[nodiscard]] QRectF boundingRect() const override { return {QPointF(0, 0), size_}; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* /*option*/,
             QWidget* /*widget*/) override {
    paint_study(*chart_, *painter, size_, theme_);
  }

 private:
  std::shared_ptr<const StudyChart> chart_;
  const Theme& theme_;
  QSizeF size_;
};

}  // namespace adore::desktop
