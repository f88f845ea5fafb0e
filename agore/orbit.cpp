#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"

#include <algorithm>
#include <cmath>

namespace adore::agore {

DrawnOrbit draw_orbit(const Scene& s, double radius, double reference, std::vector<QPointF> orbit) {
  QPointF middle(0.0, 0.0);
  if (!(reference > 0.0)) {
    double left = orbit[0].x(), right = left, low = orbit[0].y(), high = low;
    for (const auto& p : orbit) {
      left = std::min(left, p.x()), right = std::max(right, p.x());
      low = std::min(low, p.y()), high = std::max(high, p.y());
    }
    middle = {0.5 * (left + right), 0.5 * (low + high)};
  }
  double largest = reference;
  for (auto& p : orbit) {
    p -= middle;
    largest = std::max(largest, std::hypot(p.x(), p.y()));
  }
  if (!(largest > desktop::least_span_of(s.animation.file.units[0]))) return {};
  const double enlargement = radius / largest;
  const auto& t = s.sketch.theme();
  if (reference > 0.0)
    s.sketch.circle({0, 0}, reference * enlargement, QPen(t.red, 1.2, Qt::DashLine));
  const auto place = [&](const QPointF& p) {
    return s.sketch.at(p.x() * enlargement, p.y() * enlargement);
  };
  const auto path = [&](std::size_t first, std::size_t last) {
    QPolygonF line{place(orbit[first])};
    for (std::size_t i = first + 1; i < last; ++i) append_seen(line, place(orbit[i]));
    if (last > first) line.append(place(orbit[last]));
    return line;
  };
  const QPolygonF line = path(0, s.index), rest = path(s.index, orbit.size() - 1);
  QPainter& p = s.sketch.painter();
  p.setBrush(Qt::NoBrush);
  QColor pale = t.curves[0];
  pale.setAlpha(70);
  p.setPen(QPen(pale, 1.2));
  p.drawPolyline(rest);
  p.setPen(QPen(t.curves[0], 1.6));
  p.drawPolyline(line);
  p.setPen(QPen(t.surface, 1.5));
  p.setBrush(t.curves[0]);
  p.drawEllipse(line.back(), 5.5, 5.5);
  return {enlargement, orbit[s.index] * enlargement};
}

}  // namespace adore::agore
