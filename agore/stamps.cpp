#include "agore/stamps.hpp"

#include <QPaintDevice>

#include <cmath>

namespace adore::agore {

namespace {

constexpr double kSmall = 64.0;     // reach [pixels of the device] that is kept in quarters
constexpr double kLargest = 700.0;  // reach: larger ones are drawn, their images would be too dear
constexpr double kMost = 32e6;      // pixels of all images: 128 MB

}  // namespace

void Stamps::draw(QPainter& painter, QPointF middle, double reach, const Look& look,
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
    if (pixels_ + static_cast<double>(side) * side > kMost) images_.clear(), pixels_ = 0.0;
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::transparent);
    QPainter once(&image);
    once.setRenderHint(QPainter::Antialiasing);
    paint(once, QPointF(half + static_cast<double>(right) / parts,
                        half + static_cast<double>(down) / parts) /
                    ratio);
    once.end();
    pixels_ += static_cast<double>(side) * side;
    found = images_.emplace(key, std::move(image)).first;
  }
  painter.drawImage(QPointF(x - half, y - half) / ratio, found->second);
}

}  // namespace adore::agore
