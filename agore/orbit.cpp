#include "agore/view_scene.hpp"
#include "agore/ways.hpp"
#include "desktop/axis_scale.hpp"

#include <algorithm>
#include <cmath>

namespace adore::agore {

namespace {

/// Color of the remaining orbit: grayer and paler than the path so far, but visible.
QColor later_colour(const desktop::Theme& theme) {
  return theme.kind == desktop::ThemeKind::Dark ? theme.muted.darker(130) : theme.curves[7];
}

}  // namespace

PictureLegendEntry remaining_orbit_entry(const Scene& s) {
  const bool later = s.index + 1 < s.animation.frames();
  return optional_entry(later_colour(s.sketch.theme()), later, "later frames", "no later frames");
}

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
  if (!(largest > desktop::min_axis_span(s.animation.file.units[0]))) return {};
  const double enlargement = radius / largest;
  const auto& t = s.sketch.theme();
  if (reference > 0.0)
    s.sketch.circle({0, 0}, reference * enlargement, QPen(t.red, 1.2, Qt::DashLine));
  const auto place = [&](const QPointF& p) {
    return s.sketch.at(p.x() * enlargement, p.y() * enlargement);
  };
  std::vector<TrajectoryPoint> way;
  const auto path = [&](std::size_t first, std::size_t last) {
    way.clear();
    for (std::size_t i = first; i <= last; ++i)
      way.push_back({place(orbit[i]), s.animation.is_path_known(i)});
  };
  QPainter& p = s.sketch.painter();
  path(s.index, orbit.size() - 1);
  draw_trajectory(p, s.sketch.area(), way, {later_colour(t), 1.2});
  path(0, s.index);
  draw_trajectory(p, s.sketch.area(), way, {t.curves[0], 1.6});
  return {enlargement, orbit[s.index] * enlargement};
}

void draw_orbit_center(const Scene& s, const DrawnOrbit& orbit) {
  const QPointF now = s.sketch.at(orbit.now.x(), orbit.now.y());
  if (!(orbit.enlargement > 0.0) || !std::isfinite(now.x() + now.y())) return;
  QPainter& p = s.sketch.painter();
  p.setPen(QPen(s.sketch.theme().surface, 1.5));
  p.setBrush(s.sketch.theme().curves[0]);
  p.drawEllipse(now, 5.5, 5.5);
}

}  // namespace adore::agore
