#include "desktop/text_faults.hpp"

#include <QGraphicsSimpleTextItem>
#include <QGraphicsTextItem>
#include <fmt/format.h>

namespace adore::desktop {
namespace {

struct Words {
  QRectF place;
  std::string text;
};

/// Of the letters, without the room above and below them.
QRectF ink(const QGraphicsItem& item) {
  QRectF box = item.boundingRect();
  const qreal room = 0.2 * box.height();
  box.adjust(1.0, room, -1.0, -room);
  return item.mapRectToScene(box);
}

}  // namespace

std::vector<std::string> text_faults(const ChartScene& scene) {
  std::vector<Words> words;
  for (const QGraphicsItem* item : scene.items()) {
    if (!item->isVisible()) continue;
    QString text;
    if (const auto* simple = dynamic_cast<const QGraphicsSimpleTextItem*>(item))
      text = simple->text();
    else if (const auto* rich = dynamic_cast<const QGraphicsTextItem*>(item))
      text = rich->toPlainText();
    if (!text.trimmed().isEmpty()) words.push_back({ink(*item), text.toStdString()});
  }
  std::vector<std::string> out;
  const QRectF page = scene.sceneRect();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].text.find("…") != std::string::npos)
      out.push_back(fmt::format("\"{}\" is shortened", words[i].text));
    if (!page.contains(words[i].place))
      out.push_back(fmt::format("\"{}\" is cut off at the page's edge", words[i].text));
    for (std::size_t k = i + 1; k < words.size(); ++k)
      if (words[i].place.intersects(words[k].place))
        out.push_back(fmt::format("\"{}\" lies over \"{}\"", words[i].text, words[k].text));
  }
  return out;
}

}  // namespace adore::desktop
