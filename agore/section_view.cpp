#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"

#include <QPainterPath>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// The cut through one element and the bearing's axis, to scale: +x to the right, outwards up. What
/// cannot be seen along the axis is here: contact angle, axial position, tilt of a roller.
namespace adore::agore {
namespace {

/// Sizes of RESULTS.h5 in the file's unit of length; angles in rad.
class Sizes {
 public:
  explicit Sizes(const Animation& animation) : animation_(animation) {}
  [[nodiscard]] double number(const char* name, double otherwise = 0.0) const {
    const auto found = animation_.motion->geometry().find(name);
    return found == animation_.motion->geometry().end() || !std::isfinite(found->second)
               ? otherwise
               : found->second;
  }
  [[nodiscard]] double length(const char* name, double otherwise = 0.0) const {
    const double value = number(name, -1.0);
    const double unit = animation_.file.units[0] == "in" ? 0.0254 : 1.0;
    return value > 0.0 ? value / unit : otherwise;
  }

 private:
  const Animation& animation_;
};

/// From (x, r) to the picture; the middle of the picture is (0, pitch radius).
class Cut {
 public:
  explicit Cut(const Scene& scene) : scene_(scene) {}
  [[nodiscard]] QPointF at(double x, double r) const {
    return scene_.sketch.at(x, r - scene_.pitch_radius());
  }
  [[nodiscard]] QPainterPath box(double left, double right, double low, double high) const {
    QPainterPath path;
    path.addRect(QRectF(at(left, high), at(right, low)).normalized());
    return path;
  }
  [[nodiscard]] QPainterPath circle(double x, double r, double radius) const {
    QPainterPath path;
    path.addEllipse(at(x, r), radius * scene_.sketch.scale(), radius * scene_.sketch.scale());
    return path;
  }

 private:
  const Scene& scene_;
};

void fill(const Scene& s, const QPainterPath& path, const QColor& colour) {
  QPainter& p = s.sketch.painter();
  p.setPen(QPen(colour.darker(140), 1.2));
  p.setBrush(colour);
  p.drawPath(path);
}

/// Displacement of a race outwards at an azimuth.
double outward(const results::Sol8Body& body, double azimuth) {
  return -body.position[1] * std::sin(azimuth) + body.position[2] * std::cos(azimuth);
}

void draw_ball_races(const Scene& s, const Cut& cut, const Sizes& sizes, double azimuth) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const double depth = 0.5 * g.element_radius;
  const double outer_groove = sizes.length("outer_groove_radius", 1.04 * g.element_radius),
               inner_groove = sizes.length("inner_groove_radius", 1.04 * g.element_radius);
  const double unit = s.animation.file.units[0] == "in" ? 0.0254 : 1.0;
  for (const std::size_t race : {0U, 1U}) {
    const auto& body = s.frame.races[race];
    const double dx = body.position[0], dr = outward(body, azimuth);
    const double centre_x =
        sizes.number(race == 0 ? "outer_race_centre_x" : "inner_race_centre_x") / unit + dx;
    const double half = 0.5 * sizes.length(race == 0 ? "outer_race_width" : "inner_race_width",
                                           2.2 * g.element_radius);
    if (race == 0) {
      const double shoulder =
          sizes.length("outer_shoulder_radius", g.outer_race_inner_radius - depth);
      const double high = std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius);
      fill(s,
           cut.box(dx - half, dx + half, shoulder + dr, high + dr)
               .subtracted(cut.circle(centre_x, g.outer_race_inner_radius - outer_groove + dr,
                                      outer_groove)),
           t.steel_dark);
    } else {
      const double shoulder =
          sizes.length("inner_shoulder_radius", g.inner_race_outer_radius + depth);
      fill(s,
           cut.box(dx - half, dx + half, g.inner_race_inner_radius + dr, shoulder + dr)
               .subtracted(cut.circle(centre_x, g.inner_race_outer_radius + inner_groove + dr,
                                      inner_groove)),
           t.steel_dark);
    }
  }
}

/// A roller and its raceways: along its axis u and across it v, from the middle of the roller.
struct RollerShape {
  double half = 0.0, radius = 0.0, slope = 0.0, crown = 0.0;
  [[nodiscard]] double side(double u) const {
    const double drop =
        crown > half ? crown - std::sqrt(crown * crown - std::min(u * u, 0.99 * crown * crown))
                     : 0.0;
    return radius + u * slope - drop;
  }
};

/// (u, v) of a body at (x, r) whose axis leans outwards by `angle`.
QPointF turned(double x, double r, double angle, double u, double v) {
  return {x + u * std::cos(angle) - v * std::sin(angle),
          r + u * std::sin(angle) + v * std::cos(angle)};
}

void draw_roller_section(const Scene& s, const Cut& cut, const Sizes& sizes, std::size_t k) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const auto& e = s.frame.elements.at(k);
  const Vec3 axis = rotation(e.angles).col(0);
  const auto lean = [&](const Vec3& a, double azimuth) {
    const double along = std::abs(a.x()) > 1e-9 ? a.x() : 1.0;
    return std::atan((-a.y() * std::sin(azimuth) + a.z() * std::cos(azimuth)) / along);
  };
  const double now = lean(axis, e.theta);
  // The races lean as the roller did at first; the raceway follows its side.
  const auto& first = s.animation.frame(0).elements.at(k);
  const double nominal = lean(rotation(first.angles).col(0), first.theta);
  const double race = sizes.number("outer_race_angle"), roller = sizes.number("contact_angle");
  const double sign = nominal * roller < 0.0 ? -1.0 : 1.0;
  RollerShape shape;
  shape.half = 0.5 * sizes.length("roller_length", 2.0 * g.element_radius);
  shape.radius = g.element_radius;
  shape.slope = std::tan(sign * (race - roller));
  shape.crown = s.animation.file.bearing_type >= 3 ? sizes.length("roller_crown_radius") : 0.0;
  if (s.animation.file.bearing_type == 4) shape.crown = 0.0;
  const double middle_r = 0.5 * (g.outer_race_inner_radius + g.inner_race_outer_radius);
  constexpr int kParts = 24;
  for (const std::size_t j : {0U, 1U}) {
    const auto& body = s.frame.races[j];
    const double dx = body.position[0], dr = outward(body, e.theta);
    const double up = j == 0 ? 1.0 : -1.0;
    const double half =
        0.5 * sizes.length(j == 0 ? "outer_race_width" : "inner_race_width", 2.6 * shape.half);
    const double far = j == 0
                           ? std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius)
                           : g.inner_race_inner_radius;
    QPolygonF ring;
    for (int i = 0; i <= kParts; ++i) {
      const double u = std::max(half, shape.half) * 1.02 * (2.0 * i / kParts - 1.0);
      const QPointF p = turned(first.x + dx, middle_r + dr, nominal, u, up * shape.side(u));
      ring.append(cut.at(p.x(), p.y()));
    }
    const double left = turned(first.x + dx, 0.0, nominal, -half * 1.02, 0.0).x(),
                 right = turned(first.x + dx, 0.0, nominal, half * 1.02, 0.0).x();
    ring.append(cut.at(right, far + dr));
    ring.append(cut.at(left, far + dr));
    QPainterPath path;
    path.addPolygon(ring);
    path.closeSubpath();
    fill(s, path, t.steel_dark);
    for (const std::size_t side : {0U, 1U}) {
      if (!has_flange(s.animation, j, side)) continue;
      const double way = side == 0 ? -1.0 : 1.0;
      const double height =
          sizes.length(fmt::format("{}_flange_{}_height", j == 0 ? "outer" : "inner",
                                   side == 0 ? "minus_x" : "plus_x")
                           .c_str(),
                       0.2 * shape.radius);
      QPolygonF block;
      for (const auto& [u, v] : {std::pair{1.0, 0.0}, {1.0, 1.0}, {1.12, 1.0}, {1.12, 0.0}}) {
        const double along = way * u * shape.half;
        const double from = shape.side(way * shape.half);
        const QPointF p =
            turned(first.x + dx, middle_r + dr, nominal, along, up * (from - v * height));
        block.append(cut.at(p.x(), p.y()));
      }
      QPainterPath flange;
      flange.addPolygon(block);
      flange.closeSubpath();
      fill(s, flange, t.steel_dark);
    }
  }
  QPolygonF body;
  for (const double up : {1.0, -1.0})
    for (int i = 0; i <= kParts; ++i) {
      const double u = shape.half * (2.0 * i / kParts - 1.0) * up;
      const QPointF p = turned(e.x, e.r, now, u, up * shape.side(u));
      body.append(cut.at(p.x(), p.y()));
    }
  QPainterPath path;
  path.addPolygon(body);
  path.closeSubpath();
  fill(s, path, t.steel_light);
}

}  // namespace

double section_picture_radius(const Animation& animation) {
  const auto& g = animation.file.geometry;
  const Sizes sizes(animation);
  const double high = std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius);
  const double pitch = 0.5 * g.pitch_diameter;
  const double wide =
      0.5 * std::max(sizes.length("outer_race_width"), sizes.length("inner_race_width"));
  return 1.12 * std::max({high - pitch, pitch - g.inner_race_inner_radius, wide});
}

void section_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const Cut cut(s);
  const Sizes sizes(s.animation);
  const auto k = static_cast<std::size_t>(s.options.element - 1);
  const auto& e = s.frame.elements.at(k);
  const bool ball = s.animation.file.bearing_type == 1;
  if (ball) {
    draw_ball_races(s, cut, sizes, e.theta);
    QPainter& p = s.sketch.painter();
    p.setPen(QPen(t.steel_dark.darker(150), 1));
    p.setBrush(t.steel_light);
    p.drawPath(cut.circle(e.x, e.r, g.element_radius));
  } else {
    draw_roller_section(s, cut, sizes, k);
  }
  if (s.animation.has_cage) {
    const double half = 0.5 * sizes.length("cage_width");
    const double hole = ball ? g.element_radius : 0.53 * sizes.length("roller_length");
    QColor colour = t.cage;
    colour.setAlpha(170);
    const auto& cage = s.animation.cage_of(s.index, k);
    for (const double side : {-1.0, 1.0})
      if (half > hole)
        fill(s,
             cut.box(cage.position[0] + std::min(side * hole, side * half),
                     cage.position[0] + std::max(side * hole, side * half), g.cage_inner_radius,
                     g.cage_outer_radius),
             colour);
  }
  std::vector<KeyEntry> key;
  const char* const names[] = {"outer race", "inner race"};
  for (std::size_t j = 0; j < 2 && s.animation.contacts; ++j) {
    const auto& contact = s.animation.contacts->frames.at(s.index).at(k);
    const double angle = s.animation.value("contact.angle", s.index, 2 * k + j);
    if (!(contact.load[j] > 0.0)) {
      key.push_back({t.curves[j], QString("%1: no contact").arg(names[j])});
      continue;
    }
    const double way = j == 0 ? 1.0 : -1.0;
    const QPointF u(way * std::sin(angle), way * std::cos(angle));
    const double part = contact.load[j] / s.animation.contacts->largest_load;
    const QPointF tip(e.x + u.x() * g.element_radius, e.r + u.y() * g.element_radius);
    const QPointF tail = tip + 1.2 * part * g.element_radius * u;
    s.sketch.painter().setPen(QPen(t.curves[j], 1, Qt::DashLine));
    s.sketch.painter().drawLine(cut.at(e.x, e.r), cut.at(tip.x(), tip.y()));
    s.sketch.arrow(cut.at(tail.x(), tail.y()), cut.at(tip.x(), tip.y()), t.curves[j], 3.2);
    key.push_back({t.curves[j], QString::fromStdString(fmt::format(
                                    "{}: {} at {:.2f}°", names[j],
                                    desktop::pretty_quantity(contact.load[j],
                                                             s.animation.contacts->load_unit, 4),
                                    angle * 180.0 / kPi))});
  }
  draw_key(s.sketch, key,
           QString::fromStdString(
               fmt::format("element {} at {:.1f}°, to scale  ·  +x to the right, outwards up",
                           k + 1, std::remainder(e.theta, 2.0 * kPi) * 180.0 / kPi)));
}

}  // namespace adore::agore
