#include "agore/views.hpp"

#include "agore/kept.hpp"
#include "agore/sketch.hpp"
#include "agore/view_scene.hpp"
#include "base/errors.hpp"
#include "desktop/axis_scale.hpp"

#include <QFontMetricsF>
#include <QTransform>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::agore {

std::array<double, 3> mark_from_outside(const results::Sol8Element& element, double angle) {
  if (element.angles == std::array<double, 3>{}) return {};
  const Vec3 axis = rotation(element.angles).col(2);
  const double x = axis.x(), y = axis.y(), z = axis.z();
  return {-y * std::cos(angle) - z * std::sin(angle), x,
          -y * std::sin(angle) + z * std::cos(angle)};
}

namespace {

constexpr double kKeyIndent = 26.0;
constexpr double kTooLow = 200.0;  ///< for more than the remark [pixels]

double key_line() { return QFontMetricsF(desktop::ui_font(12)).height() + 2.0; }

/// A remark in lines that fit, broken between its parts.
QStringList wrapped(const QString& remark, double width) {
  const QFontMetricsF metrics(desktop::ui_font(12));
  QStringList out;
  for (const QString& part : remark.split("  ·  ", Qt::SkipEmptyParts)) {
    const QString longer = out.isEmpty() ? part : out.back() + "  ·  " + part;
    if (!out.isEmpty() && metrics.horizontalAdvance(longer) <= width)
      out.back() = longer;
    else
      out << part;
  }
  return out;
}

}  // namespace

void draw_key(const Sketch& sketch, const std::vector<KeyEntry>& all, const QString& remark) {
  const std::vector<KeyEntry> entries =
      sketch.area().height() < kTooLow ? std::vector<KeyEntry>{} : all;
  QPainter& p = sketch.painter();
  const auto& area = sketch.area();
  p.setFont(desktop::ui_font(12));
  const QFontMetricsF metrics(p.font());
  const double line = key_line(), x = area.left() + 4;
  const QStringList remarks = wrapped(remark, area.width() - 12.0);
  double width = 0.0;
  for (const QString& text : remarks) width = std::max(width, metrics.horizontalAdvance(text));
  for (const auto& entry : entries)
    width = std::max(width, metrics.horizontalAdvance(entry.text) + kKeyIndent);
  width = std::min(width, area.width() - 8);
  const double height =
      line * (static_cast<double>(entries.size()) + static_cast<double>(remarks.size()));
  // What stands below stays readable and does not disturb.
  QColor paper = sketch.theme().surface;
  paper.setAlpha(215);
  p.setPen(Qt::NoPen);
  p.setBrush(paper);
  p.drawRoundedRect(QRectF(x - 4, area.bottom() - height - 2, width + 10, height + 2), 4, 4);
  double y = area.bottom() - 6;
  const auto write = [&](const QString& text, double left) {
    p.setPen(sketch.theme().muted);
    p.drawText(QPointF(left, y), metrics.elidedText(text, Qt::ElideRight, area.right() - left - 4));
  };
  for (auto text = remarks.rbegin(); text != remarks.rend(); ++text) {
    write(*text, x);
    y -= line;
  }
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    write(entry->text, x + kKeyIndent);
    p.setPen(QPen(entry->colour, 3));
    p.drawLine(QPointF(x, y - 4), QPointF(x + 18, y - 4));
    y -= line;
  }
}

QPointF element_centre(const Scene& s, std::size_t k) {
  const auto& element = s.frame.elements[k];
  const auto polar = [](double r, double a) { return QPointF(-r * std::sin(a), r * std::cos(a)); };
  if (!s.animation.has_cage) return polar(element.r, element.theta);
  const double a = s.pocket_azimuth(k);
  const QPointF radial = polar(1.0, a),
                across(std::cos(a), std::sin(a));  // z and y axes of the pocket
  return s.place(s.animation.cage_of(s.index, k)) + radial * s.pitch_radius() +
         (across * element.pocket_vector[1] + radial * element.pocket_vector[2]) * s.factor;
}

std::vector<TrailPoint> element_trail(const Scene& s, std::size_t k) {
  constexpr std::size_t kMost = 400;
  const double pitch = 2.0 * kPi / std::max(1, s.animation.file.elements);
  std::vector<TrailPoint> out;
  double swept = 0.0;
  for (std::size_t i = s.index; out.size() < kMost; --i) {
    const Scene then{s.sketch, s.animation, i, s.animation.frame(i), s.factor, s.options, s.cages};
    const auto& element = then.frame.elements.at(k);
    out.push_back({element_centre(then, k), element.x});
    if (i == 0) break;
    swept += std::abs(
        std::remainder(element.theta - s.animation.frame(i - 1).elements.at(k).theta, 2.0 * kPi));
    if (swept > 0.8 * pitch) break;
  }
  return out;
}

namespace {

/// Outer radius of the picture's outer race: a little beyond its groove where the file gives none.
double outer_rim(const results::Sol8Geometry& g) {
  return std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius);
}

/// Direction of an element's orientation mark, its body's z axis: right, up, towards the viewer,
/// seen from +X.
std::array<double, 3> mark_from_axis(const results::Sol8Element& element) {
  if (element.angles == std::array<double, 3>{}) return {};  // its turning was not followed
  const Vec3 z = rotation(element.angles).col(2);
  return {z.y(), z.z(), z.x()};
}

/// Seen along the bearing axis; `tint` invalid: steel.
void draw_element(const Scene& s, std::size_t k, const QColor& tint = {}) {
  const auto mark = mark_from_axis(s.frame.elements.at(k));
  const double radius = s.animation.file.geometry.element_radius;
  if (s.animation.file.bearing_type == 1)
    s.sketch.ball(element_centre(s, k), radius, mark, tint);
  else
    s.sketch.roller_end(element_centre(s, k), radius, mark, tint);
}

/// All of them, coloured as the options ask, with the scale.
void draw_elements(const Scene& s) {
  const Colouring colours = colouring(s.animation, s.index, s.options.colour);
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k)
    draw_element(
        s, k,
        k < colours.value.size() && colours.largest > 0.0 && std::isfinite(colours.value[k])
            ? scale_colour(colours.value[k] / colours.largest)
            : QColor());
  if (s.options.colour != ColourBy::None) draw_scale(s.sketch, colours);
}

void draw_cage(const Scene& s) {
  for (int part = 0; part < s.animation.segments; ++part)
    s.sketch.cage(s.place(s.animation.part(s.index, part)), s.animation.part_angle(s.index, part),
                  s.geometry().cage_outer_radius, s.cages.of(s.animation, s.pocket_radius(), part));
}

QString exaggeration_remark(double factor) {
  return factor == 1.0 ? QString("clearances to scale") : QString("clearances × %1").arg(factor);
}

void draw_contact_marks(const Scene& s, bool numbers) {
  const auto& t = s.sketch.theme();
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
    const QPointF centre = element_centre(s, k);
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

void draw_trails(const Scene& s) {
  QPainter& p = s.sketch.painter();
  p.setBrush(Qt::NoBrush);
  p.setPen(QPen(s.sketch.theme().accent, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
    QPolygonF line;
    for (const TrailPoint& point : element_trail(s, k))
      line.append(s.sketch.at(point.centre.x(), point.centre.y()));
    p.drawPolyline(line);
  }
}

/// Forces of both races on every element, the largest of the run as long as an element's radius.
void draw_all_loads(const Scene& s) {
  if (!s.animation.contacts || !(s.animation.contacts->largest_load > 0.0)) return;
  const auto& contacts = s.animation.contacts->frames.at(s.index);
  const double radius = s.geometry().element_radius;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const QPointF centre = element_centre(s, k);
    const double distance = std::hypot(centre.x(), centre.y());
    if (!(distance > 0.0)) continue;
    for (std::size_t j = 0; j < 2; ++j) {
      const double part = contacts[k].load[j] / s.animation.contacts->largest_load;
      if (!(part > 0.0)) continue;
      const QPointF outward = (j == 0 ? 1.0 : -1.0) / distance * centre;
      const QPointF tip = centre + radius * outward, tail = tip + part * radius * outward;
      s.sketch.arrow(s.sketch.at(tail.x(), tail.y()), s.sketch.at(tip.x(), tip.y()),
                     s.sketch.theme().curves[0], 2.6);
    }
  }
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
  if (s.animation.segments == 1) s.sketch.cage_rail(cage, s.animation);
  draw_elements(s);
  if (s.animation.has_cage) {
    draw_cage(s);
    if (guide_radius > 0.0)
      s.sketch.circle(s.animation.guide == Guide::Outer ? outer : inner, guide_radius,
                      QPen(t.red, 1.6, Qt::DashLine));
  }
  const double bore = g.inner_race_inner_radius;
  s.sketch.frame({0, 0}, s.animation.race_angle[0][s.index], 0.78 * bore, t.light_blue);
  s.sketch.frame({0, 0}, s.animation.race_angle[1][s.index], 0.62 * bore, t.blue);
  if (s.animation.has_cage) s.sketch.frame({0, 0}, s.cage_angle(), 0.46 * bore, t.green);
  draw_land_arrow(s);
  if (s.options.trails) draw_trails(s);
  if (s.options.contacts) draw_all_loads(s);
  draw_contact_marks(s, true);
  std::vector<KeyEntry> key{{t.light_blue, "outer race frame"}, {t.blue, "inner race frame"}};
  if (s.animation.has_cage) {
    key.push_back({t.green, s.animation.segments > 1 ? "frame of segment 1" : "cage frame"});
    key.push_back({t.red, "contacts of the cage"});
  }
  if (s.options.contacts && s.animation.contacts) {
    key.push_back(
        {t.curves[0], QString::fromStdString(fmt::format(
                          "race loads, longest arrow {}",
                          desktop::pretty_quantity(s.animation.contacts->largest_load,
                                                   s.animation.contacts->load_unit, 3)))});
  } else if (s.options.contacts) {
    key.push_back({t.muted, QString::fromStdString("no race loads: " + s.animation.no_contacts)});
  }
  draw_key(s.sketch, key, s.animation.has_cage ? exaggeration_remark(s.factor) : QString());
}

/// Orbit of a body's centre, enlarged to `radius` of the picture's lengths; returns the
/// enlargement. Without a reference length it is drawn about its middle, which is not magnified:
/// only motion is. A body that moves less than an atom's size stands still: 0.
double draw_orbit(const Scene& s, double radius, double reference, std::vector<QPointF> orbit) {
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
  if (!(largest > desktop::least_span_of(s.animation.file.units[0]))) return 0.0;
  const double enlargement = radius / largest;
  const auto& t = s.sketch.theme();
  if (reference > 0.0)
    s.sketch.circle({0, 0}, reference * enlargement, QPen(t.red, 1.2, Qt::DashLine));
  const auto place = [&](const QPointF& p) {
    return s.sketch.at(p.x() * enlargement, p.y() * enlargement);
  };
  // What lies within half a pixel of the last point adds nothing to the line.
  const auto path = [&](std::size_t first, std::size_t last) {
    QPolygonF line{place(orbit[first])};
    for (std::size_t i = first + 1; i <= last; ++i) {
      const QPointF next = place(orbit[i]), way = next - line.back();
      if (std::abs(way.x()) + std::abs(way.y()) > 0.5 || i == last) line.append(next);
    }
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
  return enlargement;
}

void cage_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const QPointF cage = s.place(s.frame.cage);
  if (s.animation.segments == 1) s.sketch.cage_rail(cage, s.animation);
  draw_cage(s);
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

/// Forces of the two races on element k as arrows on its surface, as long as its diameter for the
/// largest load of the file, with load and slip in the key.
void draw_contact_loads(const Scene& s, std::size_t k, QPointF centre, std::vector<KeyEntry>& key) {
  const ContactFrames& all = *s.animation.contacts;
  const ContactFrame& contact = all.frames.at(s.index).at(k);
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
  const QPointF centre = element_centre(s, k);
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

/// Lengths below an atom's size are rounding.
double atoms(double length, const Scene& s) {
  return std::abs(length) < desktop::least_span_of(s.animation.file.units[0]) ? 0.0 : length;
}

void race_view(const Scene& s) {
  const auto& g = s.geometry();
  const std::string& unit = s.animation.file.units[0];
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
           QString::fromStdString(
               (enlargement > 0.0 ? fmt::format("path about its middle × {}",
                                                desktop::pretty_number(enlargement, 3))
                                  : std::string("the race centre does not move")) +
               fmt::format("  ·  it stands at y = {}, z = {}",
                           desktop::pretty_quantity(atoms(orbit[s.index].x(), s), unit, 3),
                           desktop::pretty_quantity(atoms(orbit[s.index].y(), s), unit, 3))));
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
    case View::Pocket:
      return pocket_picture_radius(animation);
    case View::Section:
      return section_picture_radius(animation);
    case View::Solid:
      return solid_picture_radius(animation);
    case View::Flange:
      return flange_picture_radius(animation);
    case View::InnerRace:
      return g.inner_race_outer_radius * (1.0 + margin);
  }
  return outer_rim(g);
}

/// Lines that the key of a view has at most, about 260 pixels wide.
int key_lines(const Animation& animation, const ViewOptions& options) {
  const int loads = options.contacts ? 1 : 0;
  switch (options.view) {
    case View::Bearing:
      return 3 + (animation.has_cage ? 2 : 0) + loads;
    case View::Solid:
      return 3 + 2 * loads;
    case View::Cage:
    case View::Element:
      return 4;
    case View::Pocket:
    case View::Section:
    case View::Flange:
    case View::OuterRace:
    case View::InnerRace:
      return 3;
  }
  return 0;
}

/// Width of a view's key [pixels], as its longest line needs it.
double key_width(const ViewOptions& options) {
  switch (options.view) {
    case View::Solid:
      return 290.0;
    case View::Element:
      return 350.0;
    case View::OuterRace:
    case View::InnerRace:
      return 400.0;
    default:
      return options.contacts ? 240.0 : 210.0;
  }
}

/// Height at the bottom of a picture that it leaves to its key: as little as lifts a round picture
/// out of the key's corner, and all of the key where the picture is not round.
double key_foot(const Animation& animation, const ViewOptions& options, QSizeF size) {
  constexpr double kWide = 520.0;
  const bool low = size.height() < kTooLow;
  const bool round =
      options.view != View::Pocket && options.view != View::Section && options.view != View::Flange;
  double lines = key_lines(animation, options) + (size.width() < kWide ? 1 : 0);
  if (low) lines = options.view == View::Bearing ? 1.0 : round || size.width() > 260.0 ? 2.0 : 3.0;
  const double height = std::min(lines * key_line() + 4.0, 0.45 * size.height());
  if (!round) return height;
  const double beside = std::max(0.0, 0.5 * size.width() - key_width(options));
  // Rings end a margin before the picture does; the numbers of elements stand in it.
  const double half = 0.5 * std::min(size.width(), size.height());
  const bool numbers = options.view == View::Bearing || options.view == View::Cage;
  const double rim = options.view == View::Solid ? 0.13 * half : numbers ? 0.0 : 20.0;
  for (double foot = 0.0; foot < height; foot += 4.0) {
    const double radius = 0.5 * std::min(size.width(), size.height() - foot);
    const double below = std::max(0.0, size.height() - height - 0.5 * (size.height() - foot));
    if (std::hypot(beside, below) > radius - rim) return foot;
  }
  return height;
}

}  // namespace

QPointF picture_middle(const Animation& animation, const ViewOptions& options, const QRectF& area) {
  return area.center() - QPointF(0.0, 0.5 * key_foot(animation, options, area.size()));
}

const desktop::Theme& theme_of(const ViewOptions& options) {
  return desktop::theme(options.dark ? desktop::ThemeKind::Dark : desktop::ThemeKind::Light);
}

void paint_picture(QPainter& painter, const QRectF& area, const Animation& animation,
                   std::size_t index, const ViewOptions& options, Kept* kept) {
  check_view(animation, options);
  Kept once;
  if (kept == nullptr) kept = &once;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (options.zoom != 1.0 || !options.pan.isNull()) painter.setClipRect(area);
  const double foot = key_foot(animation, options, area.size());
  const QSizeF room(area.width(), area.height() - foot);
  const Sketch sketch(painter, area,
                      picture_radius(animation, options, room) / std::max(options.zoom, 1e-3),
                      theme_of(options), options.pan, foot);
  const Scene scene{
      sketch,  animation,  index, animation.frame(index), used_exaggeration(animation, options),
      options, kept->cages};
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
    case View::Section:
      section_view(scene);
      break;
    case View::Solid:
      solid_view(scene, kept->solid);
      break;
    case View::Flange:
      flange_view(scene);
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

}  // namespace adore::agore
