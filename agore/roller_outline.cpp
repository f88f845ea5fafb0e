#include "agore/roller_outline.hpp"

#include "agore/ring_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::agore {
namespace {

/// Distance of a circle from its tangent at distance `at` from the tangent point; radius 0: none.
double sagitta(double radius, double at) {
  if (!(radius > 0.0)) return 0.0;
  const double reach = std::min(std::abs(at), 0.99 * radius);
  return reach * reach / (radius + std::sqrt(radius * radius - reach * reach));
}

}  // namespace

double RollerProfile::line(double u) const {
  return radius + u * slope - sagitta(crown, std::max(0.0, std::abs(u) - 0.5 * central));
}

double RollerProfile::side(double u) const {
  const double round = corner[u < 0.0 ? 0 : 1];
  const double into = std::clamp(std::abs(u) - (half - round), 0.0, round);
  return line(u) - (round - std::sqrt(round * round - into * into));
}

std::vector<QPointF> RollerProfile::meridian() const {
  constexpr int kBody = 24, kCorner = 6, kFace = 8;
  std::vector<QPointF> out;
  // An end from its corner inward; a dome recedes by its drop there.
  const auto end = [&](std::size_t k) {
    const double way = k == 0 ? -1.0 : 1.0, round = corner[k];
    const double at = line(way * half);
    const auto face = [&](double r) { return half - sagitta(dome[k], r); };
    std::vector<QPointF> points;
    for (int i = 1; round > 0.0 && i <= kCorner; ++i) {
      const double phi = 0.5 * std::numbers::pi * i / kCorner;
      const double r = at - round * (1.0 - std::cos(phi));
      points.emplace_back(way * std::min(half - round * (1.0 - std::sin(phi)), face(r)), r);
    }
    const double rim = at - round;
    const int parts = dome[k] > 0.0 ? kFace : 1;
    for (int i = 0; i <= parts; ++i) {
      const double r = rim * (parts - i) / parts;
      points.emplace_back(way * face(r), r);
    }
    return points;
  };
  out = end(0);
  std::reverse(out.begin(), out.end());
  // The side ends at its corner, or where a dome has receded farther.
  const auto body_end = [&](std::size_t k) {
    const double way = k == 0 ? -1.0 : 1.0, before = half - corner[k];
    const double widest = std::max(line(way * before), line(way * half));
    return way * std::min(before, half - sagitta(dome[k], widest));
  };
  const double first = body_end(0), last = body_end(1);
  for (int i = 0; i <= kBody; ++i) {
    const double u = first + (last - first) * i / kBody;
    out.emplace_back(u, line(u));
  }
  const std::vector<QPointF> right = end(1);
  out.insert(out.end(), right.begin(), right.end());
  return out;
}

QPainterPath RollerProfile::outline() const {
  const std::vector<QPointF> upper = meridian();
  QPolygonF polygon;
  for (const QPointF& p : upper) polygon.append(p);
  for (auto p = upper.rbegin(); p != upper.rend(); ++p) polygon.append({p->x(), -p->y()});
  QPainterPath path;
  path.addPolygon(polygon);
  path.closeSubpath();
  return path;
}

QPainterPath RollerProfile::outline(double lean) const {
  constexpr double kUpright = 1e-6;
  if (std::abs(std::sin(lean)) < kUpright) return outline();
  constexpr int kParts = 48;
  const double along = std::cos(lean), towards = std::sin(lean);
  std::vector<QPointF> points;
  for (const QPointF& disc : meridian())
    for (int i = 0; i < kParts; ++i) {
      const double phi = 2.0 * std::numbers::pi * i / kParts;
      points.emplace_back(disc.x() * along - disc.y() * std::cos(phi) * towards,
                          disc.y() * std::sin(phi));
    }
  std::sort(points.begin(), points.end(), [](const QPointF& a, const QPointF& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  // Andrew's monotone chain: lower side, then the upper one back.
  std::vector<QPointF> hull;
  const auto add = [&hull](const QPointF& p, std::size_t least) {
    const auto turn = [&] {
      const QPointF a = hull[hull.size() - 2], b = hull.back();
      return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    };
    while (hull.size() >= least && !(turn() > 0.0)) hull.pop_back();
    hull.push_back(p);
  };
  for (const QPointF& p : points) add(p, 2);
  const std::size_t lower = hull.size() + 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
  QPainterPath path;
  path.addPolygon(QPolygonF(QList<QPointF>(hull.begin(), hull.end())));
  path.closeSubpath();
  return path;
}

QPainterPath RollerProfile::visible_end_rim(double lean) const {
  QPainterPath path;
  constexpr double kSeen = 0.02;  // a smaller end is drawn as a line
  if (std::abs(std::sin(lean)) < kSeen) return path;
  const bool far_end = lean > 0.0;  // the end at +u looks toward the viewer
  const double way = far_end ? 1.0 : -1.0, round = corner[far_end ? 1 : 0];
  const double rim = line(way * half) - round;
  // The rim of a dome is behind its middle, which hides the far half of it until the tilt exceeds
  // the slope of the dome there.
  const double bulge = dome[far_end ? 1 : 0], u = way * (half - sagitta(bulge, rim));
  const double thin = rim * std::abs(std::sin(lean));
  const QRectF box(u * std::cos(lean) - thin, -rim, 2.0 * thin, 2.0 * rim);
  if (bulge > 0.0 && std::abs(std::sin(lean)) < rim / bulge) {
    const double start = far_end ? 90.0 : -90.0;  // the half toward the body
    path.arcMoveTo(box, start);
    path.arcTo(box, start, 180.0);
  } else {
    path.addEllipse(box);
  }
  return path;
}

RollerProfile roller_profile(const Animation& animation) {
  const auto& g = animation.file.geometry;
  const bool tapered = animation.file.bearing_type >= 4;
  RollerProfile out;
  out.half = 0.5 * dimension_in_file_unit(animation, "roller_length", 2.0 * g.element_radius);
  out.radius = g.element_radius;
  // The large end is that toward -x (contact/roller_profile.hpp).
  if (tapered) out.slope = -std::tan(dimension_in_si(animation, "roller_half_angle"));
  // A crown radius of meters is not visible.
  const double crown = dimension_in_file_unit(animation, "roller_crown_radius");
  if (crown > out.half && crown < 40.0 * out.half) {
    out.crown = crown;
    out.central = dimension_in_file_unit(animation, "roller_central_length");
  }
  const double most = 0.4 * std::min(out.half, out.radius);
  const char* const names[] = {"roller_minus_x_corner_radius", "roller_plus_x_corner_radius"};
  const char* const domes[] = {"roller_minus_x_end_radius", "roller_plus_x_end_radius"};
  for (std::size_t end = 0; end < 2; ++end) {
    out.corner[end] = std::min(dimension_in_file_unit(animation, names[end]), most);
    const double dome = dimension_in_file_unit(animation, domes[end]);
    if (dome > out.radius) out.dome[end] = dome;
  }
  out.mass_centre = dimension_in_si(animation, "roller_mass_offset") / length_unit(animation);
  return out;
}

}  // namespace adore::agore
