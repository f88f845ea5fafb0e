#include "agore/pocket_outline.hpp"
#include "agore/ring_profile.hpp"
#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"

#include <QTransform>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::agore {
namespace {

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
  if (animation.file.bearing_type == 1) {
    constexpr double kLeast = -1.0, kMost = 4.0;  // of kPocType
    pocket.code =
        static_cast<int>(std::clamp(size_number(animation, "pocket_code"), kLeast, kMost));
  } else {
    const RollerProfile roller = roller_profile(animation);
    pocket.roller_length = 2.0 * roller.half;
    pocket.taper = roller.slope;
    if (animation.motion)
      pocket.leaning =
          leaning_walls(roller, nominal_lean(animation) - cage_profile(animation).lean);
  }
  return pocket;
}

/// A roller's axis about its pocket [rad]: across it towards increasing azimuth, and towards who
/// looks from outside along the pocket's axis, which leans as a conical cage does. A file without
/// the cage's cone does not tell the latter.
AxisAngles in_pocket(const Animation& animation, const results::Sol8Element& element,
                     double azimuth) {
  const Vec3 axis = rotation(element.angles).col(0);
  const double sine = std::sin(azimuth), cosine = std::cos(azimuth);
  const double skewed = -axis.y() * cosine - axis.z() * sine;
  if (!animation.motion) return {0.0, std::atan2(skewed, axis.x())};
  const double cone = cage_profile(animation).lean;
  const double out = -axis.y() * sine + axis.z() * cosine;
  const double along = axis.x() * std::cos(cone) + out * std::sin(cone);
  return {std::atan2(out * std::cos(cone) - axis.x() * std::sin(cone), std::hypot(along, skewed)),
          std::atan2(skewed, along)};
}

/// "top leans 7.5° towards the viewer": of a lean that can be seen.
std::string lean_remark(double lean) {
  constexpr double kSeen = 0.5;  // [degrees]
  const double degrees = lean * 180.0 / kPi;
  if (std::abs(degrees) < kSeen) return {};
  return fmt::format("  ·  top leans {}° {}", desktop::tick_text(std::abs(degrees), 1),
                     degrees > 0.0 ? "towards the viewer" : "away");
}

}  // namespace

double pocket_picture_radius(const Animation& animation) {
  const auto& g = animation.file.geometry;
  const QSizeF hole = pocket_half(pocket_of(animation));
  return std::max({2.6 * g.element_radius, hole.height() + 1.4 * g.element_radius,
                   hole.width() + 1.4 * g.element_radius});
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
  const RollerProfile roller = rollers ? roller_profile(s.animation) : RollerProfile{};
  const bool shape_known = s.animation.motion != nullptr;
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
  if (const QPainterPath far = pocket_far_edge(pocket); !far.isEmpty()) {
    p.setPen(QPen(t.cage.darker(145), 1.2, Qt::DashLine));
    p.setBrush(Qt::NoBrush);
    p.drawPath(to_picture.map(far));
  }
  const QPointF centre(-element.pocket_vector[1] * factor, element.pocket_vector[0] * factor);
  const double azimuth = s.pocket_azimuth(k);
  const AxisAngles lies = rollers ? in_pocket(s.animation, element, azimuth) : AxisAngles{};
  if (rollers) {
    QTransform turned = to_picture;
    turned.translate(centre.x(), centre.y())
        .rotateRadians(0.5 * kPi - drawn_skew(roller, lies.skew, factor));  // the axis upright
    QLinearGradient shade(to_picture.map(centre - QPointF(g.element_radius, 0)),
                          to_picture.map(centre + QPointF(g.element_radius, 0)));
    shade.setColorAt(0.0, t.steel_dark);
    shade.setColorAt(0.4, t.steel_light);
    shade.setColorAt(1.0, t.steel_dark);
    p.setPen(QPen(t.steel_dark.darker(150), 1));
    p.setBrush(shade);
    p.drawPath(turned.map(roller.outline(lies.lean)));
    p.setBrush(Qt::NoBrush);
    p.drawPath(turned.map(roller.end_seen(lies.lean)));
  } else {
    s.sketch.ball(centre, g.element_radius, mark_from_outside(element, azimuth));
  }
  const double direction =
      s.animation.cage_angle.back() >= s.animation.cage_angle.front() ? 1.0 : -1.0;
  constexpr double kHalfHead = 15.0;  // pixels of the arrow
  const double top = high + std::max(0.3 * g.element_radius, kHalfHead / s.sketch.scale());
  s.sketch.arrow(s.sketch.at(-direction * g.element_radius, top),
                 s.sketch.at(direction * g.element_radius, top), t.red, 7.0);
  // A small picture has no room for it below the view's title.
  const QPointF above = s.sketch.at(0, top) - QPointF(0.0, 22.0);
  const bool arrow_named = above.y() > s.sketch.area().top() - 2.0;
  if (arrow_named) s.sketch.label(above, "cage rotation", t.muted, 13);
  if (element.pocket_force > 0.0) {
    const QPointF u = touched_wall(rollers, centre, element.pocket_angle, direction);
    s.sketch.arrow(  // from the middle, as the classic tool draws it
        s.sketch.at(centre.x(), centre.y()),
        s.sketch.at(centre.x() + u.x() * g.element_radius, centre.y() + u.y() * g.element_radius),
        t.red, 2.6);
  }
  const std::string force =
      desktop::pretty_quantity(element.pocket_force, s.animation.file.units[2], 3);
  draw_key(
      s,
      {{element.pocket_force > 0.0 ? t.red : QColor(),
        element.pocket_force > 0.0 ? QString::fromStdString(fmt::format(
                                         "contact in the pocket: {} at {}°", force,
                                         desktop::tick_text(element.pocket_angle * 180.0 / kPi, 0)))
        : rollers ? QString("no contact with the side walls; end walls are not stored")
                  : QString("no contact")}},
      QString::fromStdString(fmt::format(
          "pocket {} of {}  ·  {} × {}  ·  seen from outside, axis up{}{}{}", k + 1,
          s.frame.elements.size(),
          rollers && !roller.is_barrel() ? "clearance and skew" : "clearance",
          desktop::pretty_number(factor, 3) + (roller.is_barrel() ? ", skew to scale" : ""),
          s.sketch.area().height() < kTooLow ? "" : lean_remark(lies.lean),
          arrow_named || s.sketch.area().height() < kTooLow ? "" : "  ·  arrow: cage rotation",
          shape_known || (!rollers && !(g.pocket_clearance_2 > 0.0)) ? ""
          : rollers ? "  ·  as long as wide: SOL8 does not hold the length of rollers"
                    : "  ·  drawn round: SOL8 does not hold the pocket's shape")));
}

}  // namespace adore::agore
