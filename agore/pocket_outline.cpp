#include "agore/pocket_outline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace adore::agore {
namespace {

/// Of a roller's pocket at its end 0 (-x) or 1.
double wall(const PocketOutline& p, std::size_t end) {
  return 0.5 * (p.roller_length + p.clearance_1) + p.leaning.at(end);
}

}  // namespace

QSizeF pocket_half(const PocketOutline& p) {
  const double half = p.radius + 0.5 * p.clearance_1;
  if (p.roller_length > 0.0) {
    const double high = wall(p, p.taper < 0.0 ? 0 : 1);
    return {half + std::abs(p.taper) * high, std::max(wall(p, 0), wall(p, 1))};
  }
  switch (p.code) {
    case 2:  // elongated round the bearing
      return {half + 0.5 * p.clearance_2, half};
    case 3:  // rectangular
      return {half, p.radius + 0.5 * p.clearance_2};
    case 4: {  // conical: the wider of its two ends
      const double wide = p.radius + 0.5 * std::max(p.clearance_1, p.clearance_2);
      return {wide, wide};
    }
    default:
      return {half, half};
  }
}

QPainterPath pocket_hole(const PocketOutline& p) {
  const QSizeF half = pocket_half(p);
  const QRectF box(-half.width(), -half.height(), 2.0 * half.width(), 2.0 * half.height());
  QPainterPath path;
  if (p.roller_length > 0.0) {
    const double middle = p.radius + 0.5 * p.clearance_1;
    QPolygonF window;
    for (const auto& [side, up] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
      const double high = up * wall(p, up < 0.0 ? 0 : 1);
      window.append({side * (middle + p.taper * high), high});
    }
    path.addPolygon(window);
    path.closeSubpath();
  } else if (p.code == 3)
    path.addRect(box);
  else
    path.addRoundedRect(box, half.height(), half.height());
  return path;
}

QPointF touched_wall(bool roller, QPointF centre, double angle, double direction) {
  if (roller) return {-direction * std::cos(angle), 0.0};
  const double way = std::hypot(centre.x(), centre.y());
  return way > 0.0 ? centre / way : QPointF(-direction * std::cos(angle), std::sin(angle));
}

QPainterPath pocket_far_edge(const PocketOutline& p) {
  QPainterPath path;
  constexpr int kConical = 4;
  if (p.code != kConical || p.roller_length > 0.0 || p.clearance_1 == p.clearance_2) return path;
  const double narrow = p.radius + 0.5 * std::min(p.clearance_1, p.clearance_2);
  path.addEllipse(QPointF(0.0, 0.0), narrow, narrow);
  return path;
}

}  // namespace adore::agore
