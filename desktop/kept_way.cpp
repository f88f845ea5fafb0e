#include "desktop/kept_way.hpp"

#include <algorithm>
#include <cmath>

namespace adore::desktop {
namespace {

constexpr double kReach = 4.0;  ///< strokes beside the frame reach into it [px]

/// Could a stroke be seen in `area`?
bool meets(const QRectF& area, const QPointF& p, const QPointF& q) {
  return std::min(p.x(), q.x()) <= area.right() && std::max(p.x(), q.x()) >= area.left() &&
         std::min(p.y(), q.y()) <= area.bottom() && std::max(p.y(), q.y()) >= area.top();
}

}  // namespace

bool KeptWay::holds(const PlaneScale& scale, const QRectF& seen) const {
  // An axis that moves changes its scale by rounding.
  constexpr double kRounding = 1e-9;
  const auto same = [](double one, double other) {
    return std::abs(one - other) <= kRounding * std::abs(one);
  };
  return same(scale.x_per, x_per_) && same(scale.y_per, y_per_) && around_.contains(seen);
}

std::vector<QPolygonF> KeptWay::inside(const std::vector<double>& x, const std::vector<double>& y,
                                       const PlaneScale& scale, const QRectF& area) {
  const QPointF origin(scale.x_at, scale.y_at);
  const QRectF seen = area.translated(-origin).adjusted(-kReach, -kReach, kReach, kReach);
  if (!holds(scale, seen)) {
    const double across = 0.5 * seen.width(), up = 0.5 * seen.height();
    around_ = seen.adjusted(-across, -up, across, up);
    x_per_ = scale.x_per;
    y_per_ = scale.y_per;
    way_ = seen_way(x, y, {0.0, x_per_, 0.0, y_per_}, around_);
  }
  std::vector<QPolygonF> out;
  for (const QPolygonF& part : way_) {
    bool goes_on = false;
    for (qsizetype i = 1; i < part.size(); ++i) {
      if (!meets(seen, part[i - 1], part[i])) {
        goes_on = false;
        continue;
      }
      if (!goes_on) out.push_back({part[i - 1] + origin});
      out.back().append(part[i] + origin);
      goes_on = true;
    }
  }
  return out;
}

}  // namespace adore::desktop
