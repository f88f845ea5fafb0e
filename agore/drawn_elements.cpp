#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"

#include <QLineF>

#include <algorithm>
#include <cmath>

/// Positions and appearance of the elements, and the labels next to them.
namespace adore::agore {

std::array<double, 3> mark_from_outside(const results::Sol8Element& element, double angle) {
  if (element.angles == std::array<double, 3>{}) return {};
  const Vec3 axis = rotation(element.angles).col(2);
  const double x = axis.x(), y = axis.y(), z = axis.z();
  return {-y * std::cos(angle) - z * std::sin(angle), x,
          -y * std::sin(angle) + z * std::cos(angle)};
}

double longest_load_arrow(const Scene& s, double wanted, double edge) {
  const double radius = s.geometry().element_radius;
  const double room = edge - s.pitch_radius() - radius;
  return std::min(wanted, std::max(room, 0.3 * radius));  // shorter ones would show no loads
}

QPointF element_centre(const Animation& animation, std::size_t frame, double factor,
                       std::size_t k) {
  const auto& element = animation.frame(frame).elements[k];
  const auto polar = [](double r, double a) { return QPointF(-r * std::sin(a), r * std::cos(a)); };
  if (!animation.has_cage) return polar(element.r, element.theta);
  const int part = animation.pocket_part[k];
  const double a = animation.cage_part_angle(frame, part) + animation.pocket_angle[k];
  const QPointF radial = polar(1.0, a),
                across(std::cos(a), std::sin(a));  // z and y axes of the pocket
  const auto& cage = animation.part(frame, part).position;
  return QPointF(cage[1], cage[2]) * factor +
         radial * 0.5 * animation.file.geometry.pitch_diameter +
         (across * element.pocket_vector[1] + radial * element.pocket_vector[2]) * factor;
}

QPointF element_centre(const Scene& s, std::size_t k) {
  return element_centre(s.animation, s.index, s.factor, k);
}

QColor trail_colour(const Scene& s) { return s.sketch.theme().curves[3]; }

QString largest_load_text(const Scene& s, double load) {
  return QString::fromStdString(" ≤ " +
                                desktop::pretty_quantity(load, s.animation.contacts->load_unit, 3));
}

bool draw_load_arrow(const Scene& s, QPointF tail, QPointF tip, const QColor& colour,
                     double width) {
  constexpr double kSeen = 6.0;  // pixels; of shorter ones no pixel has the color
  if (QLineF(tail, tip).length() < kSeen) return false;
  s.sketch.arrow(tail, tip, colour, width);
  return true;
}

void draw_load_stub(QPainter& painter, QPointF tail, QPointF tip, const QColor& colour,
                    const QColor& casing) {
  constexpr double kLeast = 3.0, kWidth = 3.0;  // pixels
  const QPointF along = tail - tip;
  const double length = std::hypot(along.x(), along.y());
  const QPointF way = length > 0.0 ? along / length : QPointF(0.0, -1.0);
  const QPointF end = tip + std::max(length, kLeast) * way;
  painter.setPen(QPen(casing, kWidth + 2.0 * kCasing, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(tip, end + kCasing * way);
  painter.setPen(QPen(colour, kWidth, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(tip, end);
}

std::vector<TrailPoint> element_trail(const Scene& s, std::size_t k) {
  constexpr std::size_t kMost = 400;
  const double pitch = 2.0 * kPi / std::max(1, s.animation.file.elements);
  std::vector<TrailPoint> out;
  double swept = 0.0;
  for (std::size_t i = s.index; out.size() < kMost; --i) {
    const Scene then{s.sketch, s.animation, i,       s.animation.frame(i),
                     s.factor, s.options,   s.cages, s.key};
    const auto& element = then.frame.elements.at(k);
    out.push_back({element_centre(then, k), element.x,
                   i < s.index && s.animation.is_path_known(i + 1, k, true)});
    if (i == 0) break;
    swept += std::abs(
        std::remainder(element.theta - s.animation.frame(i - 1).elements.at(k).theta, 2.0 * kPi));
    if (swept > 0.8 * pitch) break;
  }
  // The current position is visible without a mark.
  if (out.size() == 1 || !out[1].joined) out.erase(out.begin());
  return out;
}

PictureLegendEntry trajectory_entry(const QColor& colour, Known known, const QString& what,
                                    const QString& places) {
  switch (known) {
    case Known::All:
      break;
    case Known::Some:
      return {colour, what + ", dots: unknown"};
    case Known::None:
      return {colour, places + ", path unknown", LegendMark::Dots};
  }
  return {colour, what};
}

PictureLegendEntry optional_entry(const QColor& colour, bool now, const QString& there,
                                  const QString& none, LegendMark mark) {
  return {colour, now ? there : none, now ? mark : LegendMark::None, now ? none : there};
}

QColor flange_force_colour(const desktop::Theme& theme) { return theme.curves[4]; }

QColor race_colour(const desktop::Theme& theme, std::size_t race) {
  return race == 0 ? theme.light_blue : theme.blue;
}

PictureLegendEntry loads_entry(const Scene& s, std::size_t race, bool any) {
  const QString name = race == 0 ? "outer race loads" : "inner race loads";
  return optional_entry(s.sketch.theme().curves[race], any,
                        name + largest_load_text(s, s.animation.contacts->largest_of_race[race]),
                        QString("no %1").arg(name));
}

void add_frame_arms_entry(const Scene& s, bool named, std::vector<PictureLegendEntry>& key) {
  if (!named) key.push_back({s.sketch.theme().muted, "long arm: z", LegendMark::Frame});
}

void add_rotation_mark_entry(const Scene& s, std::optional<std::size_t> element,
                             std::vector<PictureLegendEntry>& key) {
  const auto& all = s.frame.elements;
  const auto followed = [](const results::Sol8Element& e) {
    return e.angles != std::array<double, 3>{};
  };
  if (element ? !followed(all.at(*element)) : std::none_of(all.begin(), all.end(), followed))
    return;
  const bool ball = s.animation.file.bearing_type == 1;
  const bool scaled = s.options.view == View::Bearing || s.options.view == View::Solid;
  const bool coloured =
      scaled && element_colors(s.animation, s.index, s.options.colour, s.options.scale).any();
  key.push_back({rotation_mark_color(s.sketch.theme()),
                 "rotation mark",
                 ball ? LegendMark::Turning : LegendMark::Sector,
                 {},
                 coloured});
}

PictureLegendEntry trail_entry(const Scene& s, bool any) {
  PictureLegendEntry way = trajectory_entry(trail_colour(s), s.animation.known_trails,
                                            "element paths", "earlier frames");
  return optional_entry(way.colour, any, way.text,
                        s.animation.known_trails == Known::None ? "unknown paths" : "no paths",
                        way.mark);
}

namespace {

/// Direction of an element's orientation mark, its body's z axis: right, up, toward the viewer,
/// seen from +X.
std::array<double, 3> mark_from_axis(const Scene& s, std::size_t k) {
  const results::Sol8Element& element = s.frame.elements.at(k);
  if (element.angles == std::array<double, 3>{}) return {};  // its turning was not followed
  const Vec3 z = rotation(element.angles).col(2);
  // Of a roller on the end that is seen, however it leans.
  return {z.y(), z.z(), s.animation.file.bearing_type == 1 ? z.x() : 0.0};
}

}  // namespace

void draw_element(const Scene& s, std::size_t k, const QColor& tint, bool marked) {
  const auto mark = marked ? mark_from_axis(s, k) : std::array<double, 3>{};
  const double radius = s.animation.file.geometry.element_radius;
  if (s.animation.file.bearing_type == 1)
    s.sketch.ball(element_centre(s, k), radius, mark, tint);
  else
    s.sketch.roller_end(element_centre(s, k), radius, mark, tint);
}

void draw_elements(const Scene& s) {
  const ElementColors colours =
      element_colors(s.animation, s.index, s.options.colour, s.options.scale);
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k)
    draw_element(s, k, colours.of(k), !s.options.trails);
  if (s.options.colour != ColourBy::None) draw_color_scale(s, colours);
}

void draw_rotation_marks(const Scene& s) {
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k)
    s.sketch.draw_element_rotation_mark(element_centre(s, k), s.geometry().element_radius,
                                        mark_from_axis(s, k), s.animation.file.bearing_type != 1);
}

void draw_contact_marks(const Scene& s) {
  const auto& t = s.sketch.theme();
  const double star = std::clamp(0.42 * s.geometry().element_radius * s.sketch.scale(), 3.5, 13.0);
  // Outside the ring of the cage and its stars, which have an edge.
  constexpr double kHalfNumber = 9.0, kRim = 3.0;  // pixels
  const double outside =
      s.options.view == View::Cage
          ? std::max(s.geometry().cage_outer_radius + s.geometry().element_radius * 0.55,
                     s.pitch_radius() + (star + kRim + kHalfNumber) / s.sketch.scale())
          : outer_rim(s.geometry()) + 0.54 * numbers_margin(s.sketch.half()) / s.sketch.scale();
  // Numbers of a small picture are as small as leaves them apart.
  const double apart = 2.0 * kPi * outside * s.sketch.scale() /
                       static_cast<double>(std::max<std::size_t>(1, s.frame.elements.size()));
  const int letters = static_cast<int>(std::clamp(0.6 * apart, 8.0, 12.0));
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
    const QPointF centre = element_centre(s, k);
    const bool contact = s.frame.elements[k].pocket_force > 0.0;
    if (s.animation.has_cage && contact)
      s.sketch.asterisk(s.sketch.at(centre.x(), centre.y()), star, t.red);
    // Radius for labels around a ring: that of the cage if it is alone.
    const QPointF hub = s.options.view == View::Cage ? s.place(s.animation.cage_part_of(s.index, k))
                                                     : QPointF(0, 0);
    const QPointF from_hub = centre - hub;
    const double angle = std::atan2(-from_hub.x(), from_hub.y());
    s.sketch.label(s.sketch.around(hub, outside, angle), QString::number(k + 1),
                   contact && s.animation.has_cage ? t.red : t.muted, letters, contact);
  }
}

}  // namespace adore::agore
