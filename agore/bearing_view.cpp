#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "agore/ways.hpp"
#include "desktop/axis_scale.hpp"

#include <QLineF>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

/// The bearing and its cage, seen along the axis.
namespace adore::agore {

namespace {

/// Side rings of the cage or its segments, drawn behind the elements or below the bars.
void draw_rails(const Scene& s) {
  for (int part = 0; part < s.animation.segments; ++part) {
    const QPointF centre = s.place(s.animation.part(s.index, part));
    if (s.animation.segments == 1) {
      s.sketch.cage_rail(centre, s.animation);
      continue;
    }
    const auto [begin, end] = segment_sector(s.animation, part);
    const double turned = s.animation.cage_part_angle(s.index, part);
    s.sketch.cage_rail(centre, s.animation, begin + turned, end + turned);
  }
}

void draw_cage(const Scene& s) {
  const double outside = s.geometry().cage_outer_radius;
  for (int part = 0; part < s.animation.segments; ++part)
    s.sketch.cage(s.place(s.animation.part(s.index, part)),
                  s.animation.cage_part_angle(s.index, part), outside,
                  s.cages.of(s.animation, s.pocket_radius(), part, outside * s.sketch.scale()));
}

/// A factor that cannot be used is named.
QString exaggeration_remark(const Scene& s) {
  const QString given =
      s.factor == 1.0 ? QString("clearances to scale") : QString("clearances × %1").arg(s.factor);
  const double asked = s.options.exaggeration;
  return asked > s.factor ? given + QString(" (maximum; × %1 specified)").arg(asked) : given;
}

/// Arrows from the center of the cage, or of each segment, to where its busier land touches the
/// race.
void draw_land_arrows(const Scene& s) {
  const double reach = s.animation.guide == Guide::Outer ? s.geometry().cage_outer_radius
                                                         : s.geometry().cage_inner_radius;
  for (int part = 0; part < s.animation.segments; ++part) {
    const GuideLandContact first = s.animation.land_contact(s.index, part, 0),
                           second = s.animation.land_contact(s.index, part, 1);
    const GuideLandContact& busier = second.force > first.force ? second : first;
    if (!(busier.force > 0.0)) continue;
    const QPointF cage = s.place(s.animation.part(s.index, part));
    s.sketch.arrow(
        s.sketch.at(cage.x(), cage.y()),
        s.sketch.around(cage, reach, s.animation.cage_part_angle(s.index, part) + busier.angle),
        s.sketch.theme().red, 3.2);
  }
}

/// Land arrows have the length of the cage radius for any force. Missing contacts are listed in the
/// same place, without a mark.
void add_cage_contacts(const Scene& s, std::vector<PictureLegendEntry>& key) {
  const auto entry = [&](bool now, const char* there, const char* none, LegendMark mark) {
    key.push_back(optional_entry(s.sketch.theme().red, now, there, none, mark));
  };
  const auto& elements = s.frame.elements;
  entry(std::any_of(elements.begin(), elements.end(),
                    [](const auto& element) { return element.pocket_force > 0.0; }),
        "pocket contact", "no pocket contact", LegendMark::Star);
  if (s.animation.guide == Guide::None) return;
  bool touches = false;
  for (int part = 0; part < s.animation.segments; ++part)
    for (const std::size_t land : {0U, 1U})
      touches = touches || s.animation.land_contact(s.index, part, land).force > 0.0;
  entry(touches, "direction of land contact", "no land contact", LegendMark::Line);
}

QString frame_name(const Scene& s) {
  return s.animation.segments > 1 ? QString("frame of segment %1").arg(s.segment() + 1)
                                  : QString("cage frame");
}

/// @return are there any?
bool draw_trails(const Scene& s) {
  std::vector<std::vector<TrajectoryPoint>> ways;
  bool any = false;
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
    std::vector<TrajectoryPoint>& way = ways.emplace_back();
    for (const TrailPoint& point : element_trail(s, k))
      way.push_back({s.sketch.at(point.centre.x(), point.centre.y()), point.joined});
    any = any || !way.empty();
  }
  draw_trajectories(s.sketch.painter(), s.sketch.area(), ways,
                    {trail_colour(s), 2.0, s.sketch.theme().surface});
  return any;
}

/// Forces of both races on every element, the largest of the run with the length of an element
/// radius if the outer race is as thick: its arrows end below the element numbers.
/// @return are there any, by race?
std::array<bool, 2> draw_all_loads(const Scene& s) {
  std::array<bool, 2> any{};
  const auto* const all = s.animation.contacts_at(s.index);
  if (all == nullptr || !(s.animation.contacts->largest_load > 0.0)) return any;
  const auto& contacts = *all;
  const double radius = s.geometry().element_radius;
  const double longest = longest_load_arrow(s, radius, outer_rim(s.geometry()));
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const QPointF centre = element_centre(s, k);
    const double distance = std::hypot(centre.x(), centre.y());
    if (!(distance > 0.0)) continue;
    for (std::size_t j = 0; j < 2; ++j) {
      const double part = contacts[k].load[j] / s.animation.contacts->largest_load;
      if (!(part >= kLeastLoad)) continue;
      const QPointF outward = (j == 0 ? 1.0 : -1.0) / distance * centre;
      const QPointF tip = centre + radius * outward, tail = tip + part * longest * outward;
      const QPointF from = s.sketch.at(tail.x(), tail.y()), to = s.sketch.at(tip.x(), tip.y());
      const QColor& colour = s.sketch.theme().curves[j];
      if (!draw_load_arrow(s, from, to, colour, 2.6))
        draw_load_stub(s.sketch.painter(), from, to, colour, s.sketch.theme().surface);
      any[j] = true;
    }
  }
  return any;
}

/// The guiding surface is drawn at the exaggerated clearance, so that the cage touches it in the
/// picture when it does in the bearing; 0: no race guides.
double drawn_guide_radius(const Scene& s) {
  const auto& g = s.geometry();
  return s.animation.guide == Guide::Inner
             ? g.cage_inner_radius - s.factor * s.animation.guide_clearance
         : s.animation.guide == Guide::Outer
             ? g.cage_outer_radius + s.factor * s.animation.guide_clearance
             : 0.0;
}

struct TurningFrame {
  double angle, length;
  QColor colour;
};

/// Distance of a point from a line between two others.
double away_from(QPointF place, QPointF from, QPointF to) {
  const QPointF way = to - from;
  const double size = QPointF::dotProduct(way, way);
  const double part =
      size > 0.0 ? std::clamp(QPointF::dotProduct(place - from, way) / size, 0.0, 1.0) : 0.0;
  return QLineF(place, from + part * way).length();
}

/// Arms of frames about the bearing axis. In a picture all or none have names, so that the key on
/// arms is valid for all. @return are they named?
bool draw_frames(const Scene& s, const std::vector<TurningFrame>& frames) {
  const bool named = std::all_of(frames.begin(), frames.end(), [&](const TurningFrame& frame) {
    return s.sketch.can_label_frame(frame.length);
  });
  for (const TurningFrame& frame : frames)
    s.sketch.frame({0, 0}, frame.angle, frame.length, frame.colour, named);
  return named;
}

/// Names of the frames, on the side of the arms that is farther from previous names and from all
/// other arms.
void name_frames(const Scene& s, const std::vector<TurningFrame>& frames) {
  std::vector<QPointF> taken;
  const auto heads_of = [&](const TurningFrame& frame) {
    return std::array<QPointF, 2>{s.sketch.around({0, 0}, frame.length, frame.angle),
                                  s.sketch.around({0, 0}, frame.length, frame.angle - 0.5 * kPi)};
  };
  for (const TurningFrame& frame : frames) {
    const auto room = [&](double side) {
      double least = std::numeric_limits<double>::infinity();
      for (const QPointF& name :
           s.sketch.frame_label_positions({0, 0}, frame.angle, frame.length, side)) {
        for (const QPointF& other : taken) least = std::min(least, QLineF(name, other).length());
        for (const TurningFrame& other : frames)
          if (&other != &frame)
            for (const QPointF& head : heads_of(other))
              least = std::min(least, away_from(name, s.sketch.at(0, 0), head));
      }
      return least;
    };
    const double side = room(-1.0) > room(1.0) ? -1.0 : 1.0;
    s.sketch.draw_frame_labels({0, 0}, frame.angle, frame.length, frame.colour, side);
    for (const QPointF& name :
         s.sketch.frame_label_positions({0, 0}, frame.angle, frame.length, side))
      taken.push_back(name);
  }
}

}  // namespace

void draw_bearing_rings(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const QPointF outer = s.place(s.frame.races[0]), inner = s.place(s.frame.races[1]);
  s.sketch.ring(outer, g.outer_race_inner_radius, outer_rim(g), t.steel_light, t.steel_dark);
  s.sketch.ring(inner, g.inner_race_inner_radius, g.inner_race_outer_radius, t.steel_light,
                t.steel_dark);
  // The shoulder that carries the guide land, behind the elements.
  const double guide_radius = drawn_guide_radius(s);
  QColor pale_light = t.steel_light, pale_dark = t.steel_dark;
  pale_light.setAlpha(120);
  pale_dark.setAlpha(120);
  if (s.animation.guide == Guide::Inner && guide_radius > g.inner_race_outer_radius)
    s.sketch.ring(inner, g.inner_race_outer_radius, guide_radius, pale_light, pale_dark);
  if (s.animation.guide == Guide::Outer && guide_radius < g.outer_race_inner_radius)
    s.sketch.ring(outer, guide_radius, g.outer_race_inner_radius, pale_light, pale_dark);
}

void ring_warned_bodies(const Scene& s, std::vector<PictureLegendEntry>& key) {
  const WarnedBodies& warned = s.options.warned;
  if (warned.empty()) return;
  const auto& g = s.geometry();
  const QColor& red = s.sketch.theme().red;
  const QPen pen(red, 3.0);
  for (const int element : warned.elements)
    if (const auto k = static_cast<std::size_t>(element - 1); k < s.frame.elements.size())
      s.sketch.circle(element_centre(s, k), 1.08 * g.element_radius, pen);
  for (int part = 0; warned.cage && s.animation.has_cage && part < s.animation.segments; ++part)
    s.sketch.circle(s.place(s.animation.part(s.index, part)), g.cage_outer_radius, pen);
  if (warned.races[0]) s.sketch.circle(s.place(s.frame.races[0]), outer_rim(g), pen);
  if (warned.races[1]) s.sketch.circle(s.place(s.frame.races[1]), g.inner_race_inner_radius, pen);
  const bool balls = s.animation.file.bearing_type == 1;
  key.push_back({red, QString::fromStdString("warning: " + warned.names(balls))});
}

void draw_bearing_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const double guide_radius = drawn_guide_radius(s);
  draw_rails(s);
  draw_elements(s);
  if (s.animation.has_cage) {
    draw_cage(s);
    if (guide_radius > 0.0)
      s.sketch.dashed_circle(s.place(s.frame.races[s.animation.guide == Guide::Outer ? 0 : 1]),
                             guide_radius, t.red, 1.6);
  }
  const double bore = g.inner_race_inner_radius;
  std::vector<TurningFrame> frames{
      {s.animation.race_angle[0][s.index], 0.78 * bore, race_colour(t, 0)},
      {s.animation.race_angle[1][s.index], 0.62 * bore, race_colour(t, 1)}};
  if (s.animation.has_cage) frames.push_back({s.cage_angle(), 0.46 * bore, t.green});
  const bool named = draw_frames(s, frames);
  draw_land_arrows(s);
  const bool trails = s.options.trails && draw_trails(s);
  if (s.options.trails) draw_rotation_marks(s);  // paths run through the middle of elements
  std::array<bool, 2> loads{};
  if (s.options.contacts) loads = draw_all_loads(s);
  draw_contact_marks(s);
  if (named) name_frames(s, frames);
  std::vector<PictureLegendEntry> key{{race_colour(t, 0), "outer race frame"},
                                      {race_colour(t, 1), "inner race frame"}};
  if (s.animation.has_cage) {
    key.push_back({t.green, frame_name(s)});
    add_cage_contacts(s, key);
    if (guide_radius > 0.0) key.push_back({t.red, kGuideLands, LegendMark::Dashed});
  }
  add_frame_arms_entry(s, named, key);
  add_rotation_mark_entry(s, std::nullopt, key);
  if (s.options.trails) key.push_back(trail_entry(s, trails));
  if (s.options.contacts && s.animation.contacts_at(s.index) != nullptr) {
    for (const std::size_t race : {0U, 1U}) key.push_back(loads_entry(s, race, loads[race]));
  } else if (s.options.contacts) {
    key.push_back(
        {t.muted,
         QString::fromStdString("no race loads: " + s.animation.missing_loads_reason(s.index)),
         LegendMark::None});
  }
  ring_warned_bodies(s, key);
  if (s.options.picked)
    s.sketch.circle(element_centre(s, static_cast<std::size_t>(s.options.element - 1)),
                    1.1 * g.element_radius, QPen(t.accent, 3.0));
  // First: colors have no meaning without the scale.
  const std::vector<PictureLegendEntry> scale = scale_entries(s);
  key.insert(key.begin(), scale.begin(), scale.end());
  draw_legend(s, key, s.animation.has_cage ? exaggeration_remark(s) : QString());
}

void draw_cage_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const QPointF cage = s.place(s.cage());
  draw_rails(s);
  draw_cage(s);
  std::vector<QPointF> orbit;
  for (std::size_t i = 0; i < s.animation.frames(); ++i) {
    const auto& p = s.animation.part(i, s.segment()).position;
    orbit.emplace_back(p[1], p[2]);
  }
  const DrawnOrbit drawn =
      draw_orbit(s, 0.42 * g.cage_inner_radius, s.animation.guide_clearance, orbit);
  const auto [enlargement, now] = drawn;
  // At the position of the orbit, so that a picture has a single cage center.
  const double arm = 0.5 * g.cage_inner_radius;
  const QPointF origin = enlargement > 0.0 ? now : cage;
  const bool named = s.sketch.can_label_frame(arm);
  s.sketch.frame(origin, s.cage_angle(), arm, t.green, named);
  draw_land_arrows(s);
  draw_orbit_center(s, drawn);
  draw_contact_marks(s);
  if (named) s.sketch.draw_frame_labels(origin, s.cage_angle(), arm, t.green);
  const QString way = s.animation.segments > 1 ? QString("orbit of the segment origin")
                                               : QString("orbit of the mass center");
  std::vector<PictureLegendEntry> key{{t.green, frame_name(s)}};
  add_cage_contacts(s, key);
  const bool cleared = s.animation.guide_clearance > 0.0;
  if (cleared) key.push_back({t.red, "clearance circle", LegendMark::Dashed});
  if (enlargement > 0.0) {
    key.push_back(trajectory_entry(
        t.curves[0], s.animation.known_centres, cleared ? way : QString("orbit about its center"),
        s.animation.segments > 1 ? "segment at each frame" : "center at each frame"));
    key.push_back({t.curves[0], s.animation.segments > 1 ? "segment origin now" : "mass center now",
                   LegendMark::Spot});
    key.push_back(remaining_orbit_entry(s));
  }
  add_frame_arms_entry(s, named, key);
  const QString scale = enlargement > 0.0
                            ? QString::fromStdString(
                                  fmt::format("orbit × {}", desktop::pretty_number(enlargement, 3)))
                            : QString("no orbit");
  draw_legend(s, key, scale + "  ·  " + exaggeration_remark(s));
}

}  // namespace adore::agore
