#include "desktop/few_colours.hpp"

#include <QList>

#include <algorithm>
#include <vector>

namespace adore::desktop {
namespace {

constexpr int kBits = 5;  // of each channel: 32,768 boxes of like colours

int box_of(QRgb c) {
  constexpr int kShift = 8 - kBits;
  return (qRed(c) >> kShift) << (2 * kBits) | (qGreen(c) >> kShift) << kBits | (qBlue(c) >> kShift);
}

struct Box {
  long count = 0, red = 0, green = 0, blue = 0;
  [[nodiscard]] QRgb mean() const {
    return qRgb(static_cast<int>(red / count), static_cast<int>(green / count),
                static_cast<int>(blue / count));
  }
};

int apart(QRgb a, QRgb b) {
  const int r = qRed(a) - qRed(b), g = qGreen(a) - qGreen(b), d = qBlue(a) - qBlue(b);
  return r * r + g * g + d * d;
}

}  // namespace

QImage in_few_colours(const QImage& picture, std::size_t most) {
  const QImage image = picture.convertToFormat(QImage::Format_RGB32);
  std::vector<Box> boxes(std::size_t{1} << (3 * kBits));
  for (int y = 0; y < image.height(); ++y) {
    const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    for (int x = 0; x < image.width(); ++x) {
      Box& box = boxes[static_cast<std::size_t>(box_of(line[x]))];
      ++box.count, box.red += qRed(line[x]), box.green += qGreen(line[x]),
          box.blue += qBlue(line[x]);
    }
  }
  // Colour after colour where most pixels are furthest from those chosen before.
  struct Used {
    std::size_t box;
    QRgb mean;
    double away;
    uchar index;
  };
  std::vector<Used> used;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].count > 0) used.push_back({i, boxes[i].mean(), 1e9, 0});
  QList<QRgb> table;
  while (static_cast<std::size_t>(table.size()) < std::min(most, used.size())) {
    const auto next = std::max_element(used.begin(), used.end(), [&](const Used& a, const Used& b) {
      return a.away * static_cast<double>(boxes[a.box].count) <
             b.away * static_cast<double>(boxes[b.box].count);
    });
    if (!(next->away > 0.0)) break;
    const QRgb chosen = next->mean;
    for (Used& other : used) {
      const double away = apart(other.mean, chosen);
      if (away >= other.away) continue;
      other.away = away;
      other.index = static_cast<uchar>(table.size());
    }
    table.append(chosen);
  }
  std::vector<uchar> index(boxes.size(), 0);
  for (const Used& each : used) index[each.box] = each.index;
  QImage out(image.size(), QImage::Format_Indexed8);
  out.setColorTable(table);
  for (int y = 0; y < image.height(); ++y) {
    const auto* from = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    uchar* line = out.scanLine(y);
    for (int x = 0; x < image.width(); ++x)
      line[x] = index[static_cast<std::size_t>(box_of(from[x]))];
  }
  return out;
}

}  // namespace adore::desktop
