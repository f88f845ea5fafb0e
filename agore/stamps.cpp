#include "agore/stamps.hpp"

#include <QPaintDevice>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace adore::agore {

namespace {

constexpr double kSmall = 64.0;  // reach [pixels of the device] that is kept in quarters
constexpr double kLargest =
    700.0;  // reach: larger ones are drawn, because their images need too much memory

double bytes_of(const QImage& image) { return static_cast<double>(image.sizeInBytes()); }

}  // namespace

void SpriteCache::make_room(double bytes) {
  if (bytes_ + bytes <= room_) return;
  // A quarter more than is needed: the next one shall not have to search again.
  const double wanted = std::max(0.0, 0.75 * room_ - bytes);
  std::vector<std::pair<std::uint64_t, const Key*>> oldest;
  for (const auto& [key, image] : images_) oldest.emplace_back(image.drawn, &key);
  std::sort(oldest.begin(), oldest.end());
  for (const auto& [drawn, key] : oldest) {
    if (bytes_ <= wanted) break;
    const auto found = images_.find(*key);
    bytes_ -= bytes_of(found->second.image);
    images_.erase(found);
  }
}

void SpriteCache::draw(QPainter& painter, QPointF middle, double reach,
                       const DrawingAppearance& look,
                       const std::function<void(QPainter&, QPointF)>& paint) {
  const double ratio = painter.device()->devicePixelRatioF();
  const double far = reach * ratio;
  if (!(far < kLargest) || !std::isfinite(middle.x() + middle.y())) return paint(painter, middle);
  const int parts = far < kSmall ? 4 : 2;
  const auto place = [&](double at) {
    const double here = std::round(at * ratio * parts) / parts;
    const double whole = std::floor(here);
    return std::pair{whole, static_cast<int>(std::lround((here - whole) * parts))};
  };
  const auto [x, right] = place(middle.x());
  const auto [y, down] = place(middle.y());
  const double half = std::ceil(far) + 1.0;
  Key key{look, right, down, ratio};
  auto found = images_.find(key);
  if (found == images_.end()) {
    const int side = 2 * static_cast<int>(half) + 1;
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::transparent);
    QPainter once(&image);
    once.setRenderHint(QPainter::Antialiasing);
    paint(once, QPointF(half + static_cast<double>(right) / parts,
                        half + static_cast<double>(down) / parts) /
                    ratio);
    once.end();
    make_room(bytes_of(image));
    bytes_ += bytes_of(image);
    found = images_.emplace(key, Image{std::move(image)}).first;
  }
  found->second.drawn = ++draw_count_;
  painter.drawImage(QPointF(x - half, y - half) / ratio, found->second.image);
}

}  // namespace adore::agore
