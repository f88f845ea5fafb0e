#include "desktop/flow_layout.hpp"

#include <QSpacerItem>

#include <algorithm>

namespace adore::desktop {
namespace {

bool grows(const QLayoutItem& item) { return item.expandingDirections().testFlag(Qt::Horizontal); }

/// Stretches are ignored at the start of a row.
bool is_stretch(QLayoutItem* item) { return item->spacerItem() != nullptr; }

}  // namespace

FlowLayout::~FlowLayout() { qDeleteAll(items_); }

void FlowLayout::addStretch() {
  addItem(new QSpacerItem(0, 0, QSizePolicy::Expanding, QSizePolicy::Minimum));
}

QLayoutItem* FlowLayout::takeAt(int index) {
  return index >= 0 && index < items_.size() ? items_.takeAt(index) : nullptr;
}

int FlowLayout::heightForWidth(int width) const { return flow({0, 0, width, 0}, false); }

QSize FlowLayout::minimumSize() const {
  QSize size;
  for (const QLayoutItem* item : items_) size = size.expandedTo(item->minimumSize());
  const QMargins m = contentsMargins();
  return size + QSize(m.left() + m.right(), m.top() + m.bottom());
}

QSize FlowLayout::sizeHint() const {
  QSize size;
  for (const QLayoutItem* item : items_) {
    if (item->isEmpty() && item->widget() != nullptr) continue;
    const QSize one = item->sizeHint();
    size = {size.width() + one.width() + (size.width() > 0 ? spacing() : 0),
            std::max(size.height(), one.height())};
  }
  const QMargins m = contentsMargins();
  return size + QSize(m.left() + m.right(), m.top() + m.bottom());
}

void FlowLayout::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  flow(rect, true);
}

int FlowLayout::flow(const QRect& rect, bool place) const {
  const QMargins m = contentsMargins();
  const QRect inside = rect.marginsRemoved(m);
  int y = inside.top();
  for (qsizetype first = 0; first < items_.size();) {
    // As many as fit, at least one.
    qsizetype end = first;
    int used = 0, height = 0, growing = 0;
    for (; end < items_.size(); ++end) {
      QLayoutItem* item = items_[end];
      if (item->isEmpty() && !is_stretch(item)) continue;
      const QSize size = item->sizeHint();
      const int more = size.width() + (used > 0 && !is_stretch(item) ? spacing() : 0);
      if (used > 0 && used + more > inside.width()) break;
      used += more;
      height = std::max(height, size.height());
      growing += grows(*item) ? 1 : 0;
    }
    int x = inside.left(), left = std::max(inside.width() - used, 0);
    for (qsizetype i = first; i < end && place; ++i) {
      QLayoutItem* item = items_[i];
      if (item->isEmpty() && !is_stretch(item)) continue;
      if (x > inside.left() && !is_stretch(item)) x += spacing();
      QSize size = item->sizeHint();
      if (grows(*item) && growing > 0) {
        const int share = left / growing--;
        size.rwidth() += share;
        left -= share;
      }
      size.setWidth(std::min(size.width(), inside.width()));
      item->setGeometry({QPoint(x, y + (height - size.height()) / 2), size});
      x += size.width();
    }
    y += height;
    first = end;
    if (first < items_.size()) y += spacing();
  }
  return y - rect.top() + m.bottom();
}

}  // namespace adore::desktop
