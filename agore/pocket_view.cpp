#include "agore/pocket_outline.hpp"
#include "agore/ring_profile.hpp"
#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "base/rotation.hpp"
#include "desktop/axis_scale.hpp"

#include <QTransform>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace adore::agore {
namespace {

/// Guide faces of record 7.3 where their planes cross the middle plane of the pocket (z = 0), which
/// is where a face without tilt touches; empty for a plain window. Lengths in the file's unit.
std::vector<GuideFace> guide_faces(const Animation& animation) {
  std::vector<GuideFace> out;
  const double unit = length_unit(animation);
  for (int i = 1;; ++i) {
    const auto number = [&](const char* name, double otherwise = 0.0) {
      return dimension_in_si(animation, fmt::format("pocket_face{}_{}", i, name).c_str(),
                             otherwise);
    };
    const double length = number("length", -1.0);
    if (!(length > 0.0)) return out;
    const Mat3 to_face = passive_matrix({number("angle_x"), number("angle_y"), number("angle_z")});
    const Vec3 along = to_face.row(0), normal = to_face.row(1),
               centre{number("x"), number("y"), number("z")};
    if (!(normal.y() > 0.0)) continue;
    const double half = 0.5 * length * std::abs(along.x());
    const auto at = [&](double x) {
      return (normal.dot(centre) - normal.x() * x) / normal.y() / unit;
    };
    const double low = centre.x() - half, high = centre.x() + half;
    out.push_back({low / unit, high / unit, at(low), at(high)});
  }
}

/// Exaggeration of the pocket view: the clearance is drawn as 0.44 element radii.
double pocket_factor(const Animation& animation) {
  const auto& g = animation.file.geometry;
  double clearance = g.pocket_clearance_1;
  if (const std::vector<GuideFace> faces = guide_faces(animation); !faces.empty()) {
    const double slope = roller_profile(animation).slope;
    double least = std::numeric_limits<double>::infinity();
    for (const GuideFace& face : faces)
      least = std::min({least, face.at_low - slope * face.low, face.at_high - slope * face.high});
    clearance = 2.0 * (least - g.element_radius);
  }
  return clearance > 0.0 ? 0.44 * g.element_radius / clearance : 1.0;
}

/// As RESULTS.h5 has it; from SOL8 alone round, and rollers as long as wide. Its clearances are
/// `factor` times as large.
PocketOutline pocket_of(const Animation& animation, double factor) {
  const auto& g = animation.file.geometry;
  PocketOutline pocket{.radius = g.element_radius,
                       .clearance_1 = factor * g.pocket_clearance_1,
                       .clearance_2 = factor * g.pocket_clearance_2};
  if (animation.file.bearing_type == 1) {
    constexpr double kLeast = -1.0, kMost = 4.0;  // of kPocType
    pocket.code =
        static_cast<int>(std::clamp(dimension_in_si(animation, "pocket_code"), kLeast, kMost));
  } else {
    const RollerProfile roller = roller_profile(animation);
    pocket.roller_length = 2.0 * roller.half;
    pocket.taper = roller.slope;
    pocket.faces = guide_faces(animation);
    for (GuideFace& face : pocket.faces)
      for (const auto& [x, y] : {std::pair{face.low, &face.at_low}, {face.high, &face.at_high}}) {
        const double roller_side = pocket.radius + pocket.taper * x;
        *y = roller_side + factor * (*y - roller_side);
      }
    if (animation.motion)
      pocket.leaning =
          end_wall_offsets(roller, nominal_lean(animation) - cage_profile(animation).lean);
  }
  return pocket;
}

/// A roller's axis about its pocket [rad], in the cage's frame, tilted as it is: across the pocket
/// toward increasing azimuth, and toward who looks from outside along the pocket's axis, which
/// leans as a conical cage does. A file without the cage's cone does not tell the latter.
/// @param pocket_angle azimuth of the pocket in its cage [rad]
AxisAngles in_pocket(const Animation& animation, const results::Sol8Element& element,
                     const results::Sol8Body& cage, double pocket_angle) {
  const Vec3 axis = rotation(cage.angles).transpose() * rotation(element.angles).col(0);
  const double sine = std::sin(pocket_angle), cosine = std::cos(pocket_angle);
  const double skewed = -axis.y() * cosine - axis.z() * sine;
  if (!animation.motion) return {0.0, std::atan2(skewed, axis.x())};
  const double cone = cage_profile(animation).lean;
  const double out = -axis.y() * sine + axis.z() * cosine;
  const double along = axis.x() * std::cos(cone) + out * std::sin(cone);
  return {std::atan2(out * std::cos(cone) - axis.x() * std::sin(cone), std::hypot(along, skewed)),
          std::atan2(skewed, along)};
}

/// Walls at the left and right of a roller: gaps in the length unit of the file, forces in its
/// force unit.
struct SideWalls {
  std::array<double, 2> gap{}, force{}, angle{};
  std::array<std::optional<double>, 2> along{};  ///< contact points, from the pocket center
};

/// Drawn position of a roller in its pocket, and its gaps to the side walls.
struct RollerPose {
  QPointF centre;
  double skew = 0.0;  ///< as drawn [rad]
  SideWalls walls;
  std::array<QPointF, 2> touch;  ///< contact points with those walls
};

/// For each side the guide surface with the largest load, or else the nearest: surfaces are stored
/// in pairs, the driving one first. No value without pairs.
std::optional<SideWalls> stored_walls(const Animation& animation, std::size_t frame,
                                      std::size_t element, bool to_the_right) {
  if (!animation.motion || animation.behind(frame)) return std::nullopt;
  const results::MotionChannel* const gap = animation.motion->channel("pocket.gap");
  const results::MotionChannel* const force = animation.motion->channel("pocket.force");
  const results::MotionChannel* const angle = animation.motion->channel("pocket.theta");
  const std::size_t surfaces = animation.motion->pocket_surfaces(), first = element * surfaces;
  if (surfaces == 0 || surfaces % 2 != 0) return std::nullopt;
  for (const results::MotionChannel* channel : {gap, force, angle})
    if (channel == nullptr || first + surfaces > channel->width) return std::nullopt;
  // With two surfaces their middles are at the pocket middle; for more this is unknown here.
  const results::MotionChannel* const place =
      surfaces == 2 ? animation.motion->channel("pocket.position") : nullptr;
  SideWalls out;
  for (std::size_t i = 0; i < surfaces; ++i) {
    const std::size_t side = (i % 2 == 0) == to_the_right ? 0 : 1, at = first + i;
    const double f = force->at(frame, at), g = gap->at(frame, at);
    const bool nearer = f > out.force[side] || (f == out.force[side] && g < out.gap[side]);
    if (i >= 2 && !nearer) continue;
    out.gap[side] = g, out.force[side] = f, out.angle[side] = angle->at(frame, at);
    if (place != nullptr && at < place->width) out.along[side] = place->at(frame, at);
  }
  return out;
}

/// The drawing keeps the ratio of the gaps: side gaps from the run, so that a roller touches where
/// it carries load; end gaps from its shape, to scale.
RollerPose roller_pose(const Scene& s, const PocketOutline& drawn, const AxisAngles& lies,
                       double factor, bool to_the_right) {
  const auto k = static_cast<std::size_t>(s.options.element - 1);
  const auto& way = s.frame.elements.at(k).pocket_vector;
  const QPainterPath silhouette = roller_profile(s.animation).outline(lies.lean);
  const PocketOutline pocket = pocket_of(s.animation, 1.0);
  RollerPose out;
  out.skew = drawn_skew(silhouette, pocket.taper, lies.skew, factor);
  const QPolygonF roller = upright(silhouette, lies.skew), seen = upright(silhouette, out.skew);
  const PocketGaps ends = pocket_gaps(pocket, roller.translated(0.0, way[0]));
  const double up = moved(pocket_gaps(drawn, seen).ends, ends.ends);
  const PocketGaps sides = pocket_gaps(pocket, roller.translated(-way[1], way[0]));
  const auto& element = s.frame.elements.at(k);
  if (const auto stored = stored_walls(s.animation, s.index, k, to_the_right)) {
    out.walls = *stored;
  } else {  // SOL8 contains the force of one contact
    out.walls.gap = sides.sides;
    const std::size_t side = (std::cos(element.pocket_angle) > 0.0) == to_the_right ? 0 : 1;
    out.walls.force[side] = element.pocket_force;
    out.walls.angle[side] = element.pocket_angle;
  }
  out.centre = {moved(pocket_gaps(drawn, seen.translated(0.0, up)).sides, out.walls.gap), up};
  for (const std::size_t side : {0U, 1U}) {
    std::optional<double> along = out.walls.along[side];
    if (along) *along += up - way[0];  // the end play of the roller is magnified
    out.touch[side] = wall_contact_point(seen.translated(out.centre), pocket.taper, side, along);
  }
  return out;
}

/// A contact in the pocket: its point on the element as drawn, and the direction to the wall. An
/// arrow from the center of the element, as in the classic tool, is against the force and does not
/// show the point.
struct WallTouch {
  QPointF at, wall;
  double force, angle;
};

/// Of a roller: each of the side walls that carries.
std::vector<WallTouch> touches_of(const RollerPose& pose, double direction) {
  std::vector<WallTouch> out;
  for (const std::size_t side : {0U, 1U}) {
    const double force = pose.walls.force[side], angle = pose.walls.angle[side];
    if (force > 0.0)
      out.push_back(
          {pose.touch[side], wall_contact_direction(true, {}, angle, direction), force, angle});
  }
  return out;
}

/// For a ball: each loaded surface of the run, or the one of the frame.
std::vector<WallTouch> touches_of(const Scene& s, std::size_t k, const PocketOutline& pocket,
                                  QPointF centre, double direction) {
  std::vector<WallTouch> out;
  const double radius = s.geometry().element_radius;
  // Flat and elongated walls are not in the direction of the displacement of the ball.
  const bool round = pocket.code != 2 && pocket.code != 3;
  const auto add = [&](double force, double angle) {
    if (!(force > 0.0)) return;
    const QPointF wall =
        wall_contact_direction(false, round ? centre : QPointF(), angle, direction);
    out.push_back({centre + radius * wall, wall, force, angle});
  };
  const bool stored = s.animation.motion && !s.animation.behind(s.index);
  const results::MotionChannel* const force =
      stored ? s.animation.motion->channel("pocket.force") : nullptr;
  const results::MotionChannel* const angle =
      stored ? s.animation.motion->channel("pocket.theta") : nullptr;
  const std::size_t surfaces = stored ? s.animation.motion->pocket_surfaces() : 0;
  const std::size_t first = k * surfaces;
  const bool all = surfaces > 1 && force != nullptr && angle != nullptr &&
                   first + surfaces <= std::min(force->width, angle->width);
  for (std::size_t i = first; all && i < first + surfaces; ++i)
    add(force->at(s.index, i), angle->at(s.index, i));
  const auto& element = s.frame.elements.at(k);
  if (!all) add(element.pocket_force, element.pocket_angle);
  return out;
}

/// "top leans 7.5° toward the viewer": of a lean that can be seen.
std::string lean_remark(double lean) {
  constexpr double kSeen = 0.5;  // [degrees]
  const double degrees = lean * 180.0 / kPi;
  if (std::abs(degrees) < kSeen) return {};
  return fmt::format("  ·  top tilted {}° {}", desktop::tick_text(std::abs(degrees), 1),
                     degrees > 0.0 ? "toward the viewer" : "away");
}

/// "skew in the pocket 3.6° to the right, drawn as 15.8°", or "skew in it × 4.4" of a small
/// picture: against the pocket's axis, not the bearing's, from which SOL1 and the flange view count
/// Phi.
std::string skew_remark(double skew, double drawn, bool low) {
  constexpr double kSeen = 0.05;  // [degrees], as drawn
  const auto degrees = [](double angle) { return std::abs(angle) * 180.0 / kPi; };
  if (degrees(drawn) < kSeen) return {};
  if (low) return fmt::format("  ·  skew × {}", desktop::pretty_number(drawn / skew, 2));
  return fmt::format("  ·  skew in the pocket {}° to the {}, drawn as {}°",
                     desktop::pretty_number(degrees(skew), 2), skew > 0.0 ? "right" : "left",
                     desktop::tick_text(degrees(drawn), 1));
}

/// "side walls: left touched, right 38.1 µm away". A wall without force is not touched, even if the
/// gap is 0 within the digits of the file.
QString gaps_text(const SideWalls& walls, const std::string& unit) {
  const auto text = [&](std::size_t side) {
    return walls.gap[side] <= 0.0 && walls.force[side] > 0.0
               ? std::string("touched")
               : desktop::pretty_quantity(std::max(walls.gap[side], 0.0), unit, 3) + " away";
  };
  return QString::fromStdString(fmt::format("side walls: left {}, right {}", text(0), text(1)));
}

}  // namespace

double pocket_picture_radius(const Animation& animation) {
  const auto& g = animation.file.geometry;
  const QSizeF hole = pocket_half_size(pocket_of(animation, pocket_factor(animation)));
  return std::max({2.6 * g.element_radius, hole.height() + 1.4 * g.element_radius,
                   hole.width() + 1.4 * g.element_radius});
}

void draw_pocket_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  QPainter& p = s.sketch.painter();
  const auto k = static_cast<std::size_t>(s.options.element - 1);
  const auto& element = s.frame.elements.at(k);
  // Seen from outside along the pocket axis: bearing axis up, direction of increasing azimuth to
  // the right.
  const double factor = pocket_factor(s.animation);
  const PocketOutline pocket = pocket_of(s.animation, factor);
  const bool rollers = s.animation.file.bearing_type != 1;
  const RollerProfile roller = rollers ? roller_profile(s.animation) : RollerProfile{};
  const bool shape_known = s.animation.motion != nullptr;
  const QSizeF hole = pocket_half_size(pocket);
  // From the pocket's center, y up, to the picture.
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
  const double direction =
      s.animation.cage_angle.back() >= s.animation.cage_angle.front() ? 1.0 : -1.0;
  const double azimuth = s.pocket_azimuth(k);
  const AxisAngles lies =
      rollers ? in_pocket(s.animation, element, s.animation.cage_part_of(s.index, k),
                          s.animation.pocket_angle.at(k))
              : AxisAngles{};
  RollerPose pose;
  if (rollers) pose = roller_pose(s, pocket, lies, factor, direction > 0.0);
  const QPointF centre =
      rollers ? pose.centre
              : QPointF(-element.pocket_vector[1] * factor, element.pocket_vector[0] * factor);
  if (rollers) {
    QTransform turned = to_picture;
    turned.translate(centre.x(), centre.y())
        .rotateRadians(0.5 * kPi - pose.skew);  // the axis upright
    QLinearGradient shade(to_picture.map(centre - QPointF(g.element_radius, 0)),
                          to_picture.map(centre + QPointF(g.element_radius, 0)));
    shade.setColorAt(0.0, t.steel_dark);
    shade.setColorAt(0.4, t.steel_light);
    shade.setColorAt(1.0, t.steel_dark);
    p.setPen(QPen(t.steel_dark.darker(150), 1));
    p.setBrush(shade);
    p.drawPath(turned.map(roller.outline(lies.lean)));
    p.setBrush(Qt::NoBrush);
    p.drawPath(turned.map(roller.visible_end_rim(lies.lean)));
  } else {
    s.sketch.ball(centre, g.element_radius, mark_from_outside(element, azimuth));
  }
  constexpr double kHalfHead = 15.0, kHalfArrow = 4.0;  // pixels of the arrow
  // Inside the picture, below its title if there are several.
  const double most =
      (s.sketch.at(0, 0).y() - s.sketch.area().top() - kHalfArrow) / s.sketch.scale();
  const double wanted = high + std::max(0.3 * g.element_radius, kHalfHead / s.sketch.scale());
  const double top = s.options.zoom == 1.0 ? std::min(wanted, most) : wanted;
  s.sketch.arrow(s.sketch.at(-direction * g.element_radius, top),
                 s.sketch.at(direction * g.element_radius, top), t.green, 7.0);
  // A small picture has no space for it below the title.
  const QPointF above = s.sketch.at(0, top) - QPointF(0.0, 22.0);
  const bool arrow_named = above.y() > s.sketch.area().top() - 2.0;
  if (arrow_named) s.sketch.label(above, "cage rotation", t.muted, 13);
  const auto degrees = [](double angle) {  // 0 to 360, as in the plot files
    const double turn = 2.0 * kPi, rest = std::fmod(angle, turn);
    return std::fmod(std::round((rest < 0.0 ? rest + turn : rest) * 180.0 / kPi), 360.0);
  };
  std::string contacts;
  for (const WallTouch& touch :
       rollers ? touches_of(pose, direction) : touches_of(s, k, pocket, centre, direction)) {
    const QPointF tail = touch.at + 0.75 * g.element_radius * touch.wall;
    s.sketch.arrow(s.sketch.at(tail.x(), tail.y()), s.sketch.at(touch.at.x(), touch.at.y()), t.red,
                   2.6);
    contacts += fmt::format("{}{} at {}°", contacts.empty() ? "pocket contact: " : ", ",
                            desktop::pretty_quantity(touch.force, s.animation.file.units[2], 3),
                            desktop::tick_text(degrees(touch.angle), 0));
  }
  const bool low = is_too_low(s.options, s.sketch.area().height());
  if (!contacts.empty() && !low) contacts += ", see arrow";
  std::vector<PictureLegendEntry> key{
      {contacts.empty() ? QColor() : t.red,
       !contacts.empty() ? QString::fromStdString(contacts)
       : rollers         ? QString("no side wall contact (contacts with end walls are not stored)")
                         : QString("no contact")}};
  if (rollers && shape_known) key.push_back({{}, gaps_text(pose.walls, s.animation.file.units[0])});
  if (!rollers) add_rotation_mark_entry(s, k, key);
  if (!arrow_named) key.push_back({t.green, "cage rotation", LegendMark::Arrow});
  std::string remark = fmt::format("{}{} of {}  ·  clearance × {}{}", low ? "" : "pocket ", k + 1,
                                   s.frame.elements.size(), desktop::pretty_number(factor, 3),
                                   s.options.exaggeration > 0.0 ? " (this view only)" : "");
  if (rollers) remark += skew_remark(lies.skew, pose.skew, low);
  if (!low) remark += "  ·  outside view, axis up" + lean_remark(lies.lean);
  if (!shape_known && rollers)
    remark += "  ·  roller length unknown (not in SOL8)";
  else if (!shape_known && g.pocket_clearance_2 > 0.0)
    remark += "  ·  pocket shape unknown (not in SOL8)";
  draw_legend(s, key, QString::fromStdString(remark));
}

}  // namespace adore::agore
