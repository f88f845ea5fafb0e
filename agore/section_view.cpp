#include "agore/ring_profile.hpp"
#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "agore/ways.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/even_digits.hpp"

#include <QPainterPath>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// The cut through one element and the bearing's axis, to scale: +x to the right, outward up. What
/// cannot be seen along the axis is here: contact angle, axial position, tilt of a roller.
namespace adore::agore {
namespace {

/// From (x, r) to the picture; the middle of the picture is (0, pitch radius).
class Cut {
 public:
  explicit Cut(const Scene& scene) : scene_(scene) {}
  [[nodiscard]] QPointF at(double x, double r) const {
    return scene_.sketch.at(x, r - scene_.pitch_radius());
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

/// Displacement of a race outward at an azimuth.
double outward(const results::Sol8Body& body, double azimuth) {
  return -body.position[1] * std::sin(azimuth) + body.position[2] * std::cos(azimuth);
}

void draw_ring(const Scene& s, const Cut& cut, std::size_t race, double azimuth) {
  const auto& body = s.frame.races[race];
  const double dx = body.position[0], dr = outward(body, azimuth);
  QPolygonF ring;
  for (const QPointF& p : ring_outline(ring_profile(s.animation, race)))
    ring.append(cut.at(p.x() + dx, p.y() + dr));
  QPainterPath path;
  path.addPolygon(ring);
  path.closeSubpath();
  fill(s, path, s.sketch.theme().steel_dark);
}

void draw_roller(const Scene& s, const Cut& cut, std::size_t k) {
  const auto& e = s.frame.elements.at(k);
  const RollerProfile shape = roller_profile(s.animation);
  const double lean = axis_angles(e).lean;
  QPolygonF body;
  for (const QPointF& point : shape.outline().toFillPolygon()) {
    const QPointF p = tilted_point(e.x, e.r, lean, point.x() - shape.mass_centre, point.y());
    body.append(cut.at(p.x(), p.y()));
  }
  QPainterPath path;
  path.addPolygon(body);
  path.closeSubpath();
  fill(s, path, s.sketch.theme().steel_light);
}

/// The bars at both ends of the pocket.
void draw_cage_cut(const Scene& s, const Cut& cut, std::size_t k) {
  const CageProfile cage = cage_profile(s.animation);
  QColor colour = s.sketch.theme().cage;
  colour.setAlpha(170);
  const double x = s.animation.cage_part_of(s.index, k).position[0];
  for (const double side : {-1.0, 1.0}) {
    QPolygonF bar;
    const auto corner = [&](double u, double v) {
      const QPointF p = tilted_point(x, s.pitch_radius(), cage.lean, side * u, v);
      bar.append(cut.at(p.x(), p.y()));
    };
    constexpr int kParts = 16;
    for (int i = 0; i <= kParts; ++i) {
      const double v = cage.low + (cage.high - cage.low) * i / kParts;
      corner(std::min(cage.pocket_half_length_at(v, side < 0.0 ? 0 : 1), cage.half_width), v);
    }
    corner(cage.half_width, cage.high);
    corner(cage.half_width, cage.low);
    QPainterPath path;
    path.addPolygon(bar);
    path.closeSubpath();
    fill(s, path, colour);
  }
}

/// Lands of the cage near the guiding race: with a step if their diameter differs from that of the
/// cage.
void draw_lands(const Scene& s, const Cut& cut, std::size_t k,
                std::vector<PictureLegendEntry>& key) {
  const std::vector<LandSection> lands = land_sections(s.animation);
  const auto& t = s.sketch.theme();
  const auto& g = s.geometry();
  const auto& body = s.animation.cage_part_of(s.index, k);
  const CageProfile cage = cage_profile(s.animation);
  QColor colour = t.cage;
  colour.setAlpha(170);
  for (const LandSection& land : lands) {
    const auto [low, high] = land_range_on_bar(cage, s.pitch_radius(), land);
    const QPointF a = cut.at(low + body.position[0], land.on_cage),
                  b = cut.at(high + body.position[0], land.on_cage);
    const double side = land.race == 0 ? g.cage_outer_radius : g.cage_inner_radius;
    if ((land.on_cage - side) * (land.race == 0 ? 1.0 : -1.0) > 1e-3 * g.element_radius) {
      QPainterPath step;
      step.addRect(QRectF(a, cut.at(high + body.position[0], side)).normalized());
      fill(s, step, colour);
    }
    for (const auto& [ink, width] : {std::pair{t.surface, 2.4 + 2.0 * kCasing}, {t.red, 2.4}}) {
      s.sketch.painter().setPen(QPen(ink, width, Qt::SolidLine, Qt::FlatCap));
      s.sketch.painter().drawLine(a, b);
    }
  }
  if (!lands.empty()) key.push_back({t.red, kGuideLands});
}

/// Flange forces on the roller, at its ends. They are small compared with race loads: their arrows
/// have a larger scale, up to the length of the longest race arrow.
void draw_flange_forces(const Scene& s, const Cut& cut, std::size_t k,
                        std::vector<PictureLegendEntry>& key) {
  const results::MotionChannel* forces =
      s.animation.motion ? s.animation.motion->channel("flange.force") : nullptr;
  if (forces == nullptr || s.animation.contacts_at(s.index) == nullptr ||
      !(s.animation.contacts->largest_load > 0.0))
    return;
  const double longest = s.animation.contacts->largest_load;
  double largest = 0.0;
  for (const double force : forces->values) largest = std::max(largest, force);
  if (!(largest > 0.0)) return;
  double factor = 1.0;
  for (const double candidate : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
    if (candidate * largest <= longest) factor = candidate;
  const auto& t = s.sketch.theme();
  const auto& e = s.frame.elements.at(k);
  const RollerProfile shape = roller_profile(s.animation);
  const double lean = axis_angles(e).lean;
  for (std::size_t race = 0; race < 2; ++race)
    for (std::size_t side = 0; side < 2; ++side) {
      const double force = s.animation.value("flange.force", s.index, 4 * k + 2 * race + side);
      if (!has_flange(s.animation, race, side) || !(force > 0.0)) continue;
      const double height = s.animation.value("flange.height", s.index, 4 * k + 2 * race + side);
      const double way = side == 0 ? -1.0 : 1.0, up = race == 0 ? 1.0 : -1.0;
      const double across =
          up * (shape.line(way * shape.half) - (std::isfinite(height) ? height : 0.0));
      const double u = way * shape.half - shape.mass_centre;
      const double length = 0.75 * shape.radius * factor * force / longest;
      const QPointF tip = tilted_point(e.x, e.r, lean, u, across),
                    tail = tilted_point(e.x, e.r, lean, u + way * length, across);
      const bool drawn = draw_load_arrow(s, cut.at(tail.x(), tail.y()), cut.at(tip.x(), tip.y()),
                                         flange_force_colour(t), 3.2);
      key.push_back(
          {drawn ? flange_force_colour(t) : QColor(),
           QString::fromStdString(fmt::format(
               "{} flange at {}x: {}{}", race == 0 ? "outer" : "inner", side == 0 ? "−" : "+",
               desktop::zero_padded_quantity(force, s.animation.contacts->load_unit, 4),
               !drawn         ? std::string(kTooSmall)
               : factor > 1.0 ? fmt::format(", arrow × {}", desktop::pretty_number(factor, 3))
                              : std::string()))});
    }
}

/// The line of a contact from the center of the element, and its load on the element.
void draw_contact(const Scene& s, const Cut& cut, std::size_t k, std::size_t race, double load,
                  const char* angle_channel, const std::string& name,
                  std::vector<PictureLegendEntry>& key) {
  const auto& t = s.sketch.theme();
  const auto& e = s.frame.elements.at(k);
  const double radius = s.geometry().element_radius;
  const double angle = s.animation.value(angle_channel, s.index, 2 * k + race);
  const double way = race == 0 ? 1.0 : -1.0;
  const QPointF u(way * std::sin(angle), way * std::cos(angle));
  const double part = load / s.animation.contacts->largest_load;
  const QPointF tip(e.x + u.x() * radius, e.r + u.y() * radius);
  const QPointF tail = tip + 0.75 * part * radius * u;
  const std::vector<TrajectoryPoint> line{{cut.at(e.x, e.r), false, false},
                                          {cut.at(tip.x(), tip.y()), true, false}};
  // Dashes on gray steel are not visible next to a dark edge of the usual width.
  const double edge = t.kind == desktop::ThemeKind::Dark ? 0.5 * kCasing : kCasing;
  draw_trajectory(s.sketch.painter(), s.sketch.area(), line,
                  {t.curves[race], 2.4, t.surface, true, edge});
  const bool drawn =
      draw_load_arrow(s, cut.at(tail.x(), tail.y()), cut.at(tip.x(), tip.y()), t.curves[race], 3.2);
  key.push_back({t.curves[race],
                 QString::fromStdString(fmt::format(
                     "{}: {} at {}°{}", name,
                     desktop::zero_padded_quantity(load, s.animation.contacts->load_unit, 4),
                     desktop::tick_text(angle * 180.0 / kPi, 2), drawn ? "" : kTooSmall)),
                 drawn ? LegendMark::Contact : LegendMark::Dashed});
}

}  // namespace

double section_picture_radius(const Animation& animation) {
  const auto& g = animation.file.geometry;
  const double high = std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius);
  const double pitch = 0.5 * g.pitch_diameter;
  const double wide = 0.5 * std::max(dimension_in_file_unit(animation, "outer_race_width"),
                                     dimension_in_file_unit(animation, "inner_race_width"));
  return 1.12 * std::max({high - pitch, pitch - g.inner_race_inner_radius, wide});
}

void draw_section_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const Cut cut(s);
  const auto k = static_cast<std::size_t>(s.options.element - 1);
  const auto& e = s.frame.elements.at(k);
  for (const std::size_t race : {0U, 1U}) draw_ring(s, cut, race, e.theta);
  if (s.animation.file.bearing_type == 1) {
    QPainter& p = s.sketch.painter();
    p.setPen(QPen(t.steel_dark.darker(150), 1));
    p.setBrush(t.steel_light);
    p.drawPath(cut.circle(e.x, e.r, g.element_radius));
  } else {
    draw_roller(s, cut, k);
  }
  if (s.animation.has_cage) draw_cage_cut(s, cut, k);
  std::vector<PictureLegendEntry> key;
  const char* const names[] = {"outer race", "inner race"};
  const auto* const contacts = s.animation.contacts_at(s.index);
  if (contacts == nullptr)
    key.push_back(
        {{},
         QString::fromStdString("no race loads: " + s.animation.missing_loads_reason(s.index))});
  for (std::size_t j = 0; j < 2 && contacts != nullptr; ++j) {
    const auto& contact = contacts->at(k);
    if (!(contact.load[j] > 0.0)) {
      key.push_back({{}, QString("%1: no contact").arg(names[j])});
      continue;
    }
    const std::string name = names[j];
    draw_contact(s, cut, k, j, contact.load[j], "contact.angle", name, key);
    const double second = s.animation.value("second_contact.load", s.index, 2 * k + j);
    if (second > 0.0)
      draw_contact(s, cut, k, j, second, "second_contact.angle", name + ", other half", key);
  }
  draw_flange_forces(s, cut, k, key);
  if (s.animation.has_cage) draw_lands(s, cut, k, key);
  draw_legend(
      s, key,
      QString::fromStdString(fmt::format(
          "element {} at {}°  ·  to scale{}", k + 1,
          desktop::tick_text(std::remainder(e.theta, 2.0 * kPi) * 180.0 / kPi, 1),
          is_too_low(s.options, s.sketch.area().height()) ? ""
                                                          : "  ·  +x to the right, outward up")));
}

}  // namespace adore::agore
