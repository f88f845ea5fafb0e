#pragma once

#include <QImage>

#include <set>

namespace adore::adrplot {

/// Of every second pixel both ways: a picture of curves has many, an empty one few.
inline int distinct_colours(const QImage& image) {
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); y += 2)
    for (int x = 0; x < image.width(); x += 2) colours.insert(image.pixel(x, y));
  return static_cast<int>(colours.size());
}

}  // namespace adore::adrplot
