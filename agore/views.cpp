#include "agore/views.hpp"

#include "agore/pocket_outline.hpp"
#include "agore/sketch.hpp"
#include "base/errors.hpp"
#include "desktop/axis_scale.hpp"

#include <QFontMetricsF>
#include <QTransform>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::agore {
namespace {

constexpr double kPi = std::numbers::pi;
/// Speeds by differences of three-digit angles are good to about 1 %; finer detail is not shown.
constexpr double kRatioSpan = 0.05;

struct KeyEntry {
  QColor colour;
  QString text;
};

/// Everything that the views of one frame share.
struct Scene {
  const Sketch& sketch;
  const Animation& animation;
  std::size_t index;
  const results::Sol8Frame& frame;
  double factor;  ///< exaggeration
  const ViewOptions& options;

  [[nodiscard]] const results::Sol8Geometry& geometry() const { return animation.file.geometry; }
  [[nodiscard]] double pitch_radius() const { return 0.5 * geometry().pitch_diameter; }
  /// Exaggerated position (y, z) of a body.
  [[nodiscard]] QPointF place(const results::Sol8Body& body) const {
    return QPointF(body.position[1], body.position[2]) * factor;
  }
  [[nodiscard]] double pocket_radius() const {
    return geometry().element_radius + 0.5 * factor * geometry().pocket_clearance_1;
  }
  [[nodiscard]] double cage_angle() const { return animation.cage_angle[index]; }
  [[nodiscard]] int busier_land() const {
    return frame.land_force[1] > frame.land_force[0] ? 1 : 0;
  }
};

/// Outer radius of the picture's outer race: a little beyond its groove where the file gives none.
double outer_rim(const results::Sol8Geometry& g) {
  return std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius);
}

/// Ball centre (y, z): its pocket's centre plus the exaggerated way out of it, or its own place
/// when there is no cage.
QPointF ball_centre(const Scene& s, std::size_t k) {
  const auto& element = s.frame.elements[k];
  const auto polar = [](double r, double a) { return QPointF(-r * std::sin(a), r * std::cos(a)); };
  if (!s.animation.has_cage) return polar(element.r, element.theta);
  const double a = s.cage_angle() + s.animation.pocket_angle[k];
  const QPointF radial = polar(1.0, a),
                across(std::cos(a), std::sin(a));  // z and y axes of the pocket
  return s.place(s.frame.cage) + radial * s.pitch_radius() +
         (across * element.pocket_vector[1] + radial * element.pocket_vector[2]) * s.factor;
}

/// Direction of an element's orientation mark, its body's z axis: right, up, towards the viewer,
/// seen from +X.
std::array<double, 3> mark_from_axis(const results::Sol8Element& element) {
  const Vec3 z = rotation(element.angles).col(2);
  return {z.y(), z.z(), z.x()};
}

/// Seen along the bearing axis.
void draw_element(const Scene& s, std::size_t k) {
  const auto mark = mark_from_axis(s.frame.elements.at(k));
  const double radius = s.animation.file.geometry.element_radius;
  if (s.animation.file.bearing_type == 1)
    s.sketch.ball(ball_centre(s, k), radius, mark);
  else
    s.sketch.roller_end(ball_centre(s, k), radius, mark);
}

/// The same seen from outside along the pocket axis at azimuth `angle`: right is increasing
/// azimuth, up is X.
std::array<double, 3> mark_from_outside(const results::Sol8Element& element, double angle) {
  const Vec3 axis = rotation(element.angles).col(2);
  const double x = axis.x(), y = axis.y(), z = axis.z();
  return {-y * std::cos(angle) - z * std::sin(angle), x,
          -y * std::sin(angle) + z * std::cos(angle)};
}

void draw_key(const Sketch& sketch, const std::vector<KeyEntry>& entries, const QString& remark) {
  QPainter& p = sketch.painter();
  const auto& area = sketch.area();
  p.setFont(desktop::ui_font(12));
  const QFontMetricsF metrics(p.font());
  double y = area.bottom() - 6;
  const double x = area.left() + 4;
  const auto write = [&](const QString& text, double left) {
    p.setPen(sketch.theme().muted);
    p.drawText(QPointF(left, y), text);
  };
  if (!remark.isEmpty()) {
    write(remark, x);
    y -= metrics.height() + 2;
  }
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    write(entry->text, x + 26);
    p.setPen(QPen(entry->colour, 3));
    p.drawLine(QPointF(x, y - 4), QPointF(x + 18, y - 4));
    y -= metrics.height() + 2;
  }
}

QString exaggeration_remark(double factor) {
  return factor == 1.0 ? QString("clearances to scale") : QString("clearances × %1").arg(factor);
}

void draw_contact_marks(const Scene& s, bool numbers) {
  const auto& t = s.sketch.theme();
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
    const QPointF centre = ball_centre(s, k);
    const bool contact = s.frame.elements[k].pocket_force > 0.0;
    if (s.animation.has_cage && contact)
      s.sketch.asterisk(
          s.sketch.at(centre.x(), centre.y()),
          std::clamp(0.42 * s.geometry().element_radius * s.sketch.scale(), 5.0, 13.0), t.red);
    if (!numbers) continue;
    const double angle = std::atan2(-centre.x(), centre.y());
    const double outside = s.options.view == View::Cage
                               ? s.geometry().cage_outer_radius + s.geometry().element_radius * 0.55
                               : outer_rim(s.geometry()) + 14.0 / s.sketch.scale();
    s.sketch.label(s.sketch.around({0, 0}, outside, angle), QString::number(k + 1),
                   contact && s.animation.has_cage ? t.red : t.muted, 12, contact);
  }
}

/// Arrow from the cage centre to where the busier land touches the race.
void draw_land_arrow(const Scene& s) {
  const int land = s.busier_land();
  if (!s.animation.has_cage || !(s.frame.land_force.at(static_cast<std::size_t>(land)) > 0.0))
    return;
  const double angle = s.cage_angle() + s.frame.land_angle.at(static_cast<std::size_t>(land));
  const double reach = s.animation.guide == Guide::Outer ? s.geometry().cage_outer_radius
                                                         : s.geometry().cage_inner_radius;
  const QPointF cage = s.place(s.frame.cage);
  s.sketch.arrow(s.sketch.at(cage.x(), cage.y()), s.sketch.around(cage, reach, angle),
                 s.sketch.theme().red, 3.2);
}

void bearing_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const QPointF outer = s.place(s.frame.races[0]), inner = s.place(s.frame.races[1]),
                cage = s.place(s.frame.cage);
  // The guiding surface is drawn at the exaggerated clearance, so that the cage touches it in the
  // picture when it does in the bearing.
  const double guide_radius = s.animation.guide == Guide::Inner
                                  ? g.cage_inner_radius - s.factor * s.animation.guide_clearance
                              : s.animation.guide == Guide::Outer
                                  ? g.cage_outer_radius + s.factor * s.animation.guide_clearance
                                  : 0.0;
  s.sketch.ring(outer, g.outer_race_inner_radius, outer_rim(g), t.steel_light, t.steel_dark);
  s.sketch.ring(inner, g.inner_race_inner_radius, g.inner_race_outer_radius, t.steel_light,
                t.steel_dark);
  // The shoulder that carries the guide land, behind the elements.
  QColor pale_light = t.steel_light, pale_dark = t.steel_dark;
  pale_light.setAlpha(120);
  pale_dark.setAlpha(120);
  if (s.animation.guide == Guide::Inner && guide_radius > g.inner_race_outer_radius)
    s.sketch.ring(inner, g.inner_race_outer_radius, guide_radius, pale_light, pale_dark);
  if (s.animation.guide == Guide::Outer && guide_radius < g.outer_race_inner_radius)
    s.sketch.ring(outer, guide_radius, g.outer_race_inner_radius, pale_light, pale_dark);
  if (s.animation.has_cage) s.sketch.cage_rail(cage, s.animation);
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) draw_element(s, k);
  if (s.animation.has_cage) {
    s.sketch.cage(cage, s.cage_angle(), s.animation, s.pocket_radius());
    if (guide_radius > 0.0)
      s.sketch.circle(s.animation.guide == Guide::Outer ? outer : inner, guide_radius,
                      QPen(t.red, 1.6, Qt::DashLine));
  }
  const double bore = g.inner_race_inner_radius;
  s.sketch.frame({0, 0}, s.animation.race_angle[0][s.index], 0.78 * bore, t.light_blue);
  s.sketch.frame({0, 0}, s.animation.race_angle[1][s.index], 0.62 * bore, t.blue);
  if (s.animation.has_cage) s.sketch.frame({0, 0}, s.cage_angle(), 0.46 * bore, t.green);
  draw_land_arrow(s);
  draw_contact_marks(s, true);
  std::vector<KeyEntry> key{{t.light_blue, "outer race frame"}, {t.blue, "inner race frame"}};
  if (s.animation.has_cage) {
    key.push_back({t.green, "cage frame"});
    key.push_back({t.red, "contacts of the cage"});
  }
  draw_key(s.sketch, key, s.animation.has_cage ? exaggeration_remark(s.factor) : QString());
}

/// Orbit of a body's centre, enlarged to `radius` of the picture's lengths; returns the
/// enlargement.
double draw_orbit(const Scene& s, double radius, double reference,
                  const std::vector<QPointF>& orbit) {
  double largest = reference;
  for (const auto& p : orbit) largest = std::max(largest, std::hypot(p.x(), p.y()));
  if (!(largest > 0.0)) return 0.0;
  const double enlargement = radius / largest;
  const auto& t = s.sketch.theme();
  if (reference > 0.0)
    s.sketch.circle({0, 0}, reference * enlargement, QPen(t.red, 1.2, Qt::DashLine));
  QPolygonF line;
  for (std::size_t i = 0; i <= s.index; ++i)
    line.append(s.sketch.at(orbit[i].x() * enlargement, orbit[i].y() * enlargement));
  QPolygonF rest;
  for (std::size_t i = s.index; i < orbit.size(); ++i)
    rest.append(s.sketch.at(orbit[i].x() * enlargement, orbit[i].y() * enlargement));
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
  return enlargement;
}

void cage_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const QPointF cage = s.place(s.frame.cage);
  s.sketch.cage_rail(cage, s.animation);
  s.sketch.cage(cage, s.cage_angle(), s.animation, s.pocket_radius());
  std::vector<QPointF> orbit;
  for (const auto& frame : s.animation.file.frames)
    orbit.emplace_back(frame.cage.position[1], frame.cage.position[2]);
  const double enlargement =
      draw_orbit(s, 0.42 * g.cage_inner_radius, s.animation.guide_clearance, orbit);
  s.sketch.frame(cage, s.cage_angle(), 0.66 * g.cage_inner_radius, t.green);
  draw_land_arrow(s);
  draw_contact_marks(s, true);
  std::vector<KeyEntry> key{{t.green, "cage frame"},
                            {t.red, "contacts; dashed: guide clearance"},
                            {t.curves[0], "orbit of the mass centre"}};
  const QString scale = enlargement > 0.0
                            ? QString::fromStdString(
                                  fmt::format("orbit × {}", desktop::pretty_number(enlargement, 3)))
                            : QString("no orbit");
  draw_key(s.sketch, key, scale + "  ·  " + exaggeration_remark(s.factor));
}

/// Exaggeration of the pocket view: the clearance is drawn as 0.44 element radii.
double pocket_factor(const results::Sol8Geometry& g) {
  return g.pocket_clearance_1 > 0.0 ? 0.44 * g.element_radius / g.pocket_clearance_1 : 1.0;
}

/// As RESULTS.h5 has it; from SOL8 alone round, and rollers as long as wide.
PocketOutline pocket_of(const Animation& animation) {
  const auto& g = animation.file.geometry;
  const double factor = pocket_factor(g);
  PocketOutline pocket{.radius = g.element_radius,
                       .clearance_1 = factor * g.pocket_clearance_1,
                       .clearance_2 = factor * g.pocket_clearance_2};
  if (animation.contacts) {
    pocket.code = animation.contacts->pocket_code;
    pocket.roller_length = animation.contacts->roller_length;
  } else if (animation.file.bearing_type != 1) {
    pocket.roller_length = 2.0 * g.element_radius;
  }
  return pocket;
}

void pocket_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  QPainter& p = s.sketch.painter();
  const auto k = static_cast<std::size_t>(s.options.element - 1);
  const auto& element = s.frame.elements.at(k);
  // Seen from outside along the pocket axis: bearing axis up, direction of increasing azimuth to
  // the right.
  const double factor = pocket_factor(g);
  const PocketOutline pocket = pocket_of(s.animation);
  const bool rollers = s.animation.file.bearing_type != 1;
  const bool shape_known = s.animation.contacts.has_value();
  const QSizeF hole = pocket_half(pocket);
  // From the pocket's centre, y up, to the picture.
  QTransform to_picture = QTransform::fromTranslate(s.sketch.at(0, 0).x(), s.sketch.at(0, 0).y());
  to_picture.scale(s.sketch.scale(), -s.sketch.scale());
  p.setPen(QPen(t.cage.darker(145), 1.6));
  p.setBrush(t.cage);
  QPainterPath body;
  const double wide = std::max(1.75 * g.element_radius, hole.width() + 0.5 * g.element_radius),
               high = std::max(1.75 * g.element_radius, hole.height() + 0.5 * g.element_radius);
  body.addRoundedRect(QRectF(-wide, -high, 2.0 * wide, 2.0 * high), 0.2 * g.element_radius,
                      0.2 * g.element_radius);
  body.addPath(pocket_hole(pocket));
  p.drawPath(to_picture.map(body));
  const QPointF centre(-element.pocket_vector[1] * factor, element.pocket_vector[0] * factor);
  const double azimuth = s.cage_angle() + s.animation.pocket_angle[k];
  if (rollers) {
    const Vec3 axis = rotation(element.angles).col(0);
    const double skew =
        std::atan2(-axis.y() * std::cos(azimuth) - axis.z() * std::sin(azimuth), axis.x());
    QTransform turned = to_picture;
    turned.translate(centre.x(), centre.y()).rotateRadians(-skew);
    QLinearGradient shade(to_picture.map(centre - QPointF(g.element_radius, 0)),
                          to_picture.map(centre + QPointF(g.element_radius, 0)));
    shade.setColorAt(0.0, t.steel_dark);
    shade.setColorAt(0.4, t.steel_light);
    shade.setColorAt(1.0, t.steel_dark);
    p.setPen(QPen(t.steel_dark.darker(150), 1));
    p.setBrush(shade);
    p.drawPath(turned.map(roller_side(pocket)));
  } else {
    s.sketch.ball(centre, g.element_radius, mark_from_outside(element, azimuth));
  }
  const double direction =
      s.animation.cage_angle.back() >= s.animation.cage_angle.front() ? 1.0 : -1.0;
  const double top = high + 0.3 * g.element_radius;
  s.sketch.arrow(s.sketch.at(-direction * g.element_radius, top),
                 s.sketch.at(direction * g.element_radius, top), t.red, 7.0);
  s.sketch.label(s.sketch.at(0, top + 22.0 / s.sketch.scale()), "cage rotation", t.muted, 13);
  if (element.pocket_force > 0.0) {
    const double way = std::hypot(centre.x(), centre.y());
    // The wall that is touched lies where the element has gone; without a way out, the stored angle
    // tells (0: the cage drives).
    const QPointF u = way > 0.0 ? centre / way
                                : QPointF(-direction * std::cos(element.pocket_angle),
                                          std::sin(element.pocket_angle));
    s.sketch.arrow(
        s.sketch.at(centre.x(), centre.y()),
        s.sketch.at(centre.x() + u.x() * g.element_radius, centre.y() + u.y() * g.element_radius),
        t.red, 2.6);
  }
  const std::string force =
      desktop::pretty_quantity(element.pocket_force, s.animation.file.units[2], 3);
  draw_key(s.sketch,
           {{t.red, element.pocket_force > 0.0
                        ? QString::fromStdString(fmt::format("contact: {} at {:.0f}°", force,
                                                             element.pocket_angle * 180.0 / kPi))
                        : QString("no contact")}},
           QString::fromStdString(fmt::format(
               "pocket {} of {}  ·  clearance × {}  ·  seen from outside, axis up{}", k + 1,
               s.frame.elements.size(), desktop::pretty_number(factor, 3),
               shape_known || (!rollers && !(g.pocket_clearance_2 > 0.0)) ? ""
               : rollers ? "  ·  as long as wide: SOL8 does not hold the length of rollers"
                         : "  ·  drawn round: SOL8 does not hold the pocket's shape")));
}

/// Forces of the two races on element k as arrows on its surface, as long as its diameter for the
/// largest load of the file, with load and slip in the key.
void draw_contact_loads(const Scene& s, std::size_t k, QPointF centre, std::vector<KeyEntry>& key) {
  const results::ContactFrames& all = *s.animation.contacts;
  const results::ContactFrame& contact = all.frames.at(s.index).at(k);
  const double distance = std::hypot(centre.x(), centre.y());
  if (!(distance > 0.0)) return;
  const QPointF outward = centre / distance;
  const double radius = s.geometry().element_radius;
  const std::array<const char*, 2> names{"outer race", "inner race"};
  for (std::size_t j = 0; j < 2; ++j) {
    const double side = j == 0 ? 1.0 : -1.0;  // the outer race presses from outside
    const QColor colour = s.sketch.theme().curves[j];
    if (contact.load[j] > 0.0 && all.largest_load > 0.0) {
      const double length = 2.0 * radius * contact.load[j] / all.largest_load;
      const QPointF tip = centre + side * radius * outward;
      const QPointF tail = tip + side * length * outward;
      s.sketch.arrow(s.sketch.at(tail.x(), tail.y()), s.sketch.at(tip.x(), tip.y()), colour, 3.0);
    }
    key.push_back(
        {colour, QString::fromStdString(
                     contact.load[j] > 0.0
                         ? fmt::format("{}: load {}, slip {}", names[j],
                                       desktop::pretty_quantity(contact.load[j], all.load_unit, 4),
                                       desktop::pretty_quantity(contact.slip[j], all.slip_unit, 3))
                         : fmt::format("{}: no contact", names[j]))});
  }
}

void element_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const auto k = static_cast<std::size_t>(s.options.element - 1);
  s.sketch.ring(s.place(s.frame.races[0]), g.outer_race_inner_radius, g.outer_race_outer_radius,
                t.steel_light, t.steel_dark);
  s.sketch.ring(s.place(s.frame.races[1]), g.inner_race_inner_radius, g.inner_race_outer_radius,
                t.steel_light, t.steel_dark);
  s.sketch.circle({0, 0}, s.pitch_radius(), QPen(t.frame, 1.2, Qt::DotLine));
  // The way of the element so far, half a turn at most.
  const auto& way = s.animation.file.frames;
  QPolygonF trail;
  double swept = 0.0;
  for (std::size_t i = s.index;; --i) {
    const auto& e = way[i].elements.at(k);
    trail.append(s.sketch.around({0, 0}, e.r, e.theta));
    if (i == 0 || swept > kPi) break;
    swept += std::abs(std::remainder(e.theta - way[i - 1].elements.at(k).theta, 2.0 * kPi));
  }
  s.sketch.painter().setPen(QPen(t.accent, 2.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  s.sketch.painter().setBrush(Qt::NoBrush);
  s.sketch.painter().drawPolyline(trail);
  const QPointF centre = ball_centre(s, k);
  draw_element(s, k);
  s.sketch.frame({0, 0}, s.animation.race_angle[1][s.index], 0.62 * g.inner_race_inner_radius,
                 t.blue);
  // Beside the arrow of the outer race, where there is one.
  const double rim = outer_rim(g) + 14.0 / s.sketch.scale();
  const double aside = s.animation.contacts ? 24.0 / (rim * s.sketch.scale()) : 0.0;
  s.sketch.label(s.sketch.around({0, 0}, rim, std::atan2(-centre.x(), centre.y()) + aside),
                 QString::number(k + 1), t.text, 13, true);
  std::vector<KeyEntry> key{{t.blue, "inner race frame"}};
  QString remark = QString::fromStdString("no contact loads: " + s.animation.no_contacts);
  if (s.animation.contacts) {
    draw_contact_loads(s, k, centre, key);
    remark = "loads and largest slip in the contacts, from RESULTS.h5";
  }
  draw_key(s.sketch, key, remark);
}

void race_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const std::size_t r = s.options.view == View::OuterRace ? 0 : 1;
  const double low = r == 0 ? g.outer_race_inner_radius : g.inner_race_inner_radius;
  const double high = r == 0 ? outer_rim(g) : g.inner_race_outer_radius;
  s.sketch.ring({0, 0}, low, high, t.steel_light, t.steel_dark);
  // A bright spot on the ring shows its rotation even when the frame is hidden by the orbit.
  s.sketch.asterisk(s.sketch.around({0, 0}, 0.5 * (low + high), s.animation.race_angle[r][s.index]),
                    6.0, t.blue);
  std::vector<QPointF> orbit;
  for (const auto& frame : s.animation.file.frames)
    orbit.emplace_back(frame.races.at(r).position[1], frame.races.at(r).position[2]);
  const double enlargement = draw_orbit(s, 0.45 * low, 0.0, orbit);
  s.sketch.frame({0, 0}, s.animation.race_angle[r][s.index], 0.7 * low, t.blue);
  draw_key(s.sketch, {{t.blue, "frame of the race"}, {t.curves[0], "path of the race centre"}},
           enlargement > 0.0 ? QString::fromStdString(
                                   fmt::format("path × {}", desktop::pretty_number(enlargement, 3)))
                             : QString("the race centre does not move"));
}

double picture_radius(const Animation& animation, const ViewOptions& options, QSizeF size) {
  const auto& g = animation.file.geometry;
  const double margin = 26.0 / (0.5 * std::min(size.width(), size.height()));
  switch (options.view) {
    case View::Bearing:
    case View::Element:
    case View::OuterRace:
      return outer_rim(g) * (1.0 + margin);
    case View::Cage:
      return (g.cage_outer_radius + g.element_radius) * (1.0 + margin);
    case View::Pocket: {
      const QSizeF hole = pocket_half(pocket_of(animation));
      return std::max({2.6 * g.element_radius, hole.height() + 1.4 * g.element_radius,
                       hole.width() + 1.4 * g.element_radius});
    }
    case View::InnerRace:
      return g.inner_race_outer_radius * (1.0 + margin);
  }
  return outer_rim(g);
}

}  // namespace

const desktop::Theme& theme_of(const ViewOptions& options) {
  return desktop::theme(options.dark ? desktop::ThemeKind::Dark : desktop::ThemeKind::Light);
}

void paint_picture(QPainter& painter, const QRectF& area, const Animation& animation,
                   std::size_t index, const ViewOptions& options) {
  check_view(animation, options);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const Sketch sketch(painter, area, picture_radius(animation, options, area.size()),
                      theme_of(options));
  const Scene scene{
      sketch, animation, index, animation.frame(index), used_exaggeration(animation, options),
      options};
  switch (options.view) {
    case View::Bearing:
      bearing_view(scene);
      break;
    case View::Cage:
      cage_view(scene);
      break;
    case View::Pocket:
      pocket_view(scene);
      break;
    case View::Element:
      element_view(scene);
      break;
    case View::OuterRace:
    case View::InnerRace:
      race_view(scene);
      break;
  }
  painter.restore();
}

desktop::ChartPage data_page(const Animation& animation, const ViewOptions& options) {
  desktop::ChartPage page;
  page.x = animation.time;
  page.x_title = "Time";
  page.x_unit = "s";
  const auto& units = animation.file.units;
  const auto history = [&](auto value) {
    std::vector<double> values;
    for (const auto& frame : animation.file.frames) values.push_back(value(frame));
    return values;
  };
  const auto k = static_cast<std::size_t>(options.element - 1);
  switch (options.view) {
    case View::Bearing: {
      page.title = "Guide land force";
      desktop::ChartPanel panel{"Force", units[2], {}, false};
      for (std::size_t land = 0; land < 2; ++land)
        panel.curves.push_back({"land " + std::to_string(land + 1),
                                history([land](const auto& f) { return f.land_force[land]; }),
                                {}});
      page.panels.push_back(std::move(panel));
      break;
    }
    case View::Cage:
      page.title = "Cage speeds over shaft speed";
      page.panels.push_back(
          {"Whirl", "", {{"", cage_whirl_ratio(animation), {}}}, false, kRatioSpan});
      page.panels.push_back(
          {"Rotation", "", {{"", cage_speed_ratio(animation), {}}}, false, kRatioSpan});
      break;
    case View::Pocket:
      page.title = fmt::format("Force in pocket {}", options.element);
      page.panels.push_back(
          {"Force",
           units[2],
           {{"", history([k](const auto& f) { return f.elements.at(k).pocket_force; }), {}}},
           false});
      break;
    case View::Element:
      page.title = fmt::format("Speeds of element {} over shaft speed", options.element);
      page.panels.push_back(
          {"Orbit", "", {{"", element_orbit_ratio(animation, k), {}}}, false, kRatioSpan});
      page.panels.push_back(
          {"Rotation", "", {{"", element_spin_ratio(animation, k), {}}}, false, kRatioSpan});
      break;
    case View::OuterRace:
    case View::InnerRace: {
      const std::size_t r = options.view == View::OuterRace ? 0 : 1;
      page.title = "Centre of the race";
      const char* names[] = {"X", "Y", "Z"};
      for (std::size_t c = 0; c < 3; ++c)
        page.panels.push_back(
            {names[c],
             units[0],
             {{"", history([r, c](const auto& f) { return f.races[r].position[c]; }), {}}},
             false});
      break;
    }
  }
  return page;
}

}  // namespace adore::agore
