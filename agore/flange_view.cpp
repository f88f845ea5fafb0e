#include "agore/roller_outline.hpp"
#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"

#include <QPainterPath>
#include <QTransform>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// A roller between the flanges of one race, seen from outside: +x to the right, up against
/// increasing azimuth, so that it is rotated by Phi of SOL1. Gaps are magnified by the stated
/// factor; a loaded flange is drawn at the roller end, for any penetration.
namespace adore::agore {
double flange_picture_radius(const Animation& animation) {
  return 0.95 * std::max(2.0 * roller_profile(animation).half,
                         2.0 * animation.file.geometry.element_radius);
}

void draw_flange_view(const Scene& s) {
  const auto& t = s.sketch.theme();
  QPainter& p = s.sketch.painter();
  const auto k = static_cast<std::size_t>(s.options.element - 1);
  const std::size_t race = s.options.flange_race;
  const RollerProfile roller = roller_profile(s.animation);
  const double length = 2.0 * roller.half, radius = s.geometry().element_radius;
  // Drawn clearance of both ends together: a fifth of the length, for the widest of the run.
  const results::MotionChannel* gaps = s.animation.motion->channel("flange.gap");
  const results::MotionChannel* forces = s.animation.motion->channel("flange.force");
  double widest = 0.0, largest = 0.0;
  const auto place = [&](std::size_t side) { return 4 * k + 2 * race + side; };
  for (std::size_t i = 0; gaps != nullptr && forces != nullptr && i < s.animation.exact; ++i)
    for (std::size_t side = 0; side < 2; ++side) {
      widest = std::max(widest, gaps->at(i, place(side)));
      largest = std::max(largest, forces->at(i, place(side)));
    }
  const double factor = widest > 0.0 ? 0.1 * length / widest : 1.0;
  const Vec3 axis = rotation(s.frame.elements.at(k).angles).col(0);
  const double azimuth = s.frame.elements.at(k).theta;
  const double skew =
      std::asin(std::clamp(axis.y() * std::cos(azimuth) + axis.z() * std::sin(azimuth), -1.0, 1.0));
  QTransform to_picture = QTransform::fromTranslate(s.sketch.at(0, 0).x(), s.sketch.at(0, 0).y());
  to_picture.scale(s.sketch.scale(), -s.sketch.scale());
  QTransform turned = to_picture;
  turned.rotateRadians(skew);
  QLinearGradient shade(to_picture.map(QPointF(0, radius)), to_picture.map(QPointF(0, -radius)));
  shade.setColorAt(0.0, t.steel_dark);
  shade.setColorAt(0.4, t.steel_light);
  shade.setColorAt(1.0, t.steel_dark);
  p.setPen(QPen(t.steel_dark.darker(150), 1));
  p.setBrush(shade);
  p.drawPath(turned.map(roller.outline()));
  std::vector<PictureLegendEntry> key;
  bool open = false;  // a gap is drawn
  for (std::size_t side = 0; side < 2; ++side) {
    if (!has_flange(s.animation, race, side)) continue;
    const double way = side == 0 ? -1.0 : 1.0;
    const double gap = s.animation.value("flange.gap", s.index, place(side)),
                 force = s.animation.value("flange.force", s.index, place(side));
    const bool near = std::isfinite(gap) && gap != 0.0;
    const double face = way * (0.5 * length + (near ? std::max(gap, 0.0) * factor : 0.14 * length));
    open = open || (near && gap > 0.0);
    const double wall = 0.12 * length;
    QPainterPath flange;
    flange.addRect(QRectF(std::min(face, face + way * wall), -1.25 * radius, wall, 2.5 * radius));
    QColor colour = t.steel_dark;
    if (!near) colour.setAlpha(120);
    p.setPen(QPen(t.steel_dark.darker(150), 1.2));
    p.setBrush(colour);
    p.drawPath(to_picture.map(flange));
    bool drawn = false;
    if (force > 0.0 && largest > 0.0) {
      const double tail = way * (0.5 * length + 0.35 * length * force / largest);
      drawn = draw_load_arrow(s, s.sketch.at(tail, 0.0), s.sketch.at(way * 0.5 * length, 0.0),
                              flange_force_colour(t), 3.2);
    }
    const std::string unit = s.animation.file.units[0];
    key.push_back(
        {drawn ? flange_force_colour(t) : QColor(),
         QString::fromStdString(fmt::format(
             "flange at {}x: {}", side == 0 ? "−" : "+",
             s.animation.behind(s.index) ? "unknown (" + s.animation.sol8_only_note() + ")"
             : !near                     ? std::string("roller end far away")
                                         : fmt::format("{}, {} {}",
                                   force > 0.0 ? desktop::pretty_quantity(
                                                                         force, s.animation.file.units[2], 3)
                                                                   : std::string("no contact"),
                                   gap < 0.0 ? "penetration (not drawn)" : "gap",
                                                       desktop::pretty_quantity(std::abs(gap), unit, 3))))});
  }
  draw_legend(
      s, key,
      QString::fromStdString(fmt::format(
          "roller {} at the {} race{}  ·  skew to the bearing axis (Phi) {}°, to scale{}", k + 1,
          race == 0 ? "outer" : "inner",
          open ? "  ·  gap × " + desktop::pretty_number(factor, 3) : "",
          desktop::tick_text(skew * 180.0 / kPi, 3),
          is_too_low(s.options, s.sketch.area().height()) ? ""
                                                          : "  ·  outside view, +x to the right")));
}

}  // namespace adore::agore
