#pragma once

#include "desktop/chart_scene.hpp"

#include <QFontMetricsF>
#include <QGraphicsSimpleTextItem>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <vector>

/// Visible texts of a chart.
namespace adore::test {

/// Numbers of one axis that lie on each other, titles of which less than two words are left, panels
/// too low to be read, texts that leave the page; empty: none.
inline QStringList unreadable(const desktop::ChartScene& scene, qreal least_panel) {
  constexpr qreal kAside = 16.0, kBelow = 14.0, kRound = 2.0;
  QStringList out;
  std::vector<const QGraphicsSimpleTextItem*> texts;
  for (const QGraphicsItem* item : scene.items())
    if (const auto* text = dynamic_cast<const QGraphicsSimpleTextItem*>(item)) {
      if (text->text().isEmpty()) continue;
      texts.push_back(text);
      const QRectF place = text->sceneBoundingRect();
      if (!scene.sceneRect().adjusted(-kRound, -kRound, kRound, kRound).contains(place))
        out << QString("\"%1\" leaves the page").arg(text->text());
      const QString whole = text->text().section(QChar(0x2026), 0, 0).trimmed();
      if (text->rotation() != 0.0 && whole != text->text() && !whole.contains(' '))
        out << QString("title \"%1\"").arg(text->text());
    }
  for (const QRectF& area : scene.plotAreas()) {
    if (area.height() < least_panel) out << QString("a panel %1 high").arg(area.height());
    std::vector<const QGraphicsSimpleTextItem*> beside, below;
    for (const auto* text : texts) {
      const QRectF place = text->sceneBoundingRect();
      if (text->rotation() != 0.0) continue;
      if (place.right() < area.left() && place.right() > area.left() - kAside &&
          place.center().y() > area.top() - kBelow && place.center().y() < area.bottom() + kBelow)
        beside.push_back(text);
      if (place.top() > area.bottom() && place.top() < area.bottom() + kBelow)
        below.push_back(text);
    }
    for (const auto* a : beside)
      for (const auto* b : beside) {
        // Digits are as high as capitals.
        const qreal digits = QFontMetricsF(a->font()).capHeight();
        const qreal apart =
            b->sceneBoundingRect().center().y() - a->sceneBoundingRect().center().y();
        if (a != b && apart >= 0.0 && apart < digits + 1.0)
          out << QString("%1 on %2").arg(a->text(), b->text());
      }
    for (const auto* a : below)
      for (const auto* b : below)
        if (a < b && a->sceneBoundingRect().intersects(b->sceneBoundingRect()))
          out << QString("%1 on %2").arg(a->text(), b->text());
  }
  return out;
}

}  // namespace adore::test
