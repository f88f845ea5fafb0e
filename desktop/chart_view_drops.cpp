#include "desktop/chart_view.hpp"

#include <QApplication>
#include <QDrag>
#include <QDropEvent>
#include <QFontMetrics>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>

#include <algorithm>

/// Curves dragged out of a chart, and what is dropped on it.
namespace adore::desktop {

std::optional<LegendEntry> ChartView::legendAt(QPointF position) const {
  for (const LegendEntry& entry : scene_->legend())
    if (entry.place.adjusted(-3, -3, 3, 3).contains(position)) return entry;
  return std::nullopt;
}

/// The numbers and the title next to a panel.
std::optional<std::size_t> ChartView::panelTitleAt(QPointF position) const {
  const auto& areas = scene_->plotAreas();
  for (std::size_t p = 0; p < areas.size(); ++p)
    if (position.x() < areas[p].left() && position.y() > areas[p].top() &&
        position.y() < areas[p].bottom())
      return p;
  return std::nullopt;
}

void ChartView::enableDrops(const QStringList& types) {
  drop_types_ = types;
  viewport()->setAcceptDrops(!types.isEmpty());
  setAcceptDrops(!types.isEmpty());
}

/// @param curve of the panel; none: all of them
void ChartView::startDrag(std::size_t panel, std::optional<std::size_t> curve) {
  const auto& panels = scene_->page().panels;
  if (drop_types_.isEmpty() || panel >= panels.size() || scene_->page().equal_axes) return;
  auto* mime = new QMimeData;
  mime->setData(kCurveMime, QByteArray::number(static_cast<qulonglong>(panel)) + ' ' +
                                (curve ? QByteArray::number(static_cast<qulonglong>(*curve))
                                       : QByteArray("-1")));
  const std::string& name = curve ? panels[panel].curves.at(*curve).name : panels[panel].title;
  mime->setText(QString::fromStdString(name));
  auto* drag = new QDrag(this);
  drag->setMimeData(mime);
  const QFontMetrics metrics(font());
  QPixmap label(metrics.horizontalAdvance(mime->text()) + 16, metrics.height() + 8);
  label.fill(palette().color(QPalette::ToolTipBase));
  QPainter painter(&label);
  painter.setPen(palette().color(QPalette::ToolTipText));
  painter.drawText(label.rect(), Qt::AlignCenter, mime->text());
  painter.end();
  drag->setPixmap(label);
  drag->exec(Qt::MoveAction | Qt::CopyAction, Qt::MoveAction);
}

bool ChartView::acceptsDrop(const QMimeData* mime) const {
  return std::any_of(drop_types_.begin(), drop_types_.end(),
                     [mime](const QString& type) { return mime->hasFormat(type); });
}

void ChartView::showDropTarget(std::optional<QPoint> at) {
  drop_panel_.reset();
  if (at) drop_panel_ = scene_->panelAt(mapToScene(*at));
  viewport()->update();
}

void ChartView::dragEnterEvent(QDragEnterEvent* event) {
  if (!acceptsDrop(event->mimeData())) return event->ignore();
  event->acceptProposedAction();
  showDropTarget(event->position().toPoint());
}

void ChartView::dragMoveEvent(QDragMoveEvent* event) {
  if (!acceptsDrop(event->mimeData())) return event->ignore();
  event->acceptProposedAction();
  showDropTarget(event->position().toPoint());
}

void ChartView::dragLeaveEvent(QDragLeaveEvent* event) {
  showDropTarget(std::nullopt);
  event->accept();
}

void ChartView::dropEvent(QDropEvent* event) {
  if (!acceptsDrop(event->mimeData())) return event->ignore();
  event->acceptProposedAction();
  const auto panel = scene_->panelAt(mapToScene(event->position().toPoint()));
  showDropTarget(std::nullopt);
  emit dropped(event->mimeData(), panel);
}

void ChartView::drawDropTarget(QPainter& painter) const {
  if (!drop_panel_ || *drop_panel_ >= scene_->plotAreas().size()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(current_theme().accent, 2.0));
  painter.drawRect(scene_->plotAreas()[*drop_panel_].adjusted(1, 1, -1, -1));
}

}  // namespace adore::desktop
