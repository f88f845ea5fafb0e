#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <cmath>

/// One race and the path of its center.
namespace adore::agore {

namespace {

/// Lengths below an atom's size are rounding.
double atoms(double length, const Scene& s) {
  return std::abs(length) < desktop::min_axis_span(s.animation.file.units[0]) ? 0.0 : length;
}

struct Radii {
  double low, high;
};
Radii radii_of(const Scene& s) {
  const auto& g = s.geometry();
  return s.options.view == View::OuterRace
             ? Radii{g.outer_race_inner_radius, outer_rim(g)}
             : Radii{g.inner_race_inner_radius, g.inner_race_outer_radius};
}

}  // namespace

void draw_race_ring(const Scene& s) {
  const auto& t = s.sketch.theme();
  const auto [low, high] = radii_of(s);
  s.sketch.ring({0, 0}, low, high, t.steel_light, t.steel_dark);
}

void draw_race_view(const Scene& s) {
  const std::string& unit = s.animation.file.units[0];
  const auto& t = s.sketch.theme();
  const std::size_t r = s.options.view == View::OuterRace ? 0 : 1;
  const auto [low, high] = radii_of(s);
  // A bright spot on the ring shows its rotation even when the frame is hidden by the orbit.
  const QColor colour = race_colour(t, r);
  const double angle = s.animation.race_angle[r][s.index], arm = 0.7 * low;
  s.sketch.asterisk(s.sketch.around({0, 0}, 0.5 * (low + high), angle), 6.0, colour);
  std::vector<QPointF> orbit;
  for (const auto& frame : s.animation.file.frames)
    orbit.emplace_back(frame.races.at(r).position[1], frame.races.at(r).position[2]);
  const DrawnOrbit drawn = draw_orbit(s, 0.45 * low, 0.0, orbit);
  const auto [enlargement, now] = drawn;
  const bool named = s.sketch.can_label_frame(arm);
  s.sketch.frame(now, angle, arm, colour, named);
  draw_orbit_center(s, drawn);
  if (named) s.sketch.draw_frame_labels(now, angle, arm, colour);
  std::vector<PictureLegendEntry> key{{colour, r == 0 ? "outer race frame" : "inner race frame"},
                                      {colour, "race mark", LegendMark::Star}};
  if (enlargement > 0.0)
    for (const PictureLegendEntry& entry :
         {trajectory_entry(t.curves[0], s.animation.known_centres, "path of the race center",
                           "race center at each frame"),
          PictureLegendEntry{t.curves[0], "race center now", LegendMark::Spot},
          remaining_orbit_entry(s)})
      key.push_back(entry);
  add_frame_arms_entry(s, named, key);
  const bool small = is_too_low(s.options, s.sketch.area().height());
  const std::string path =
      enlargement > 0.0
          ? fmt::format(fmt::runtime(small ? "path × {}" : "path about its center × {}"),
                        desktop::pretty_number(enlargement, 3))
          : std::string(small ? "at rest" : "the race center does not move");
  draw_legend(
      s, key,
      QString::fromStdString(
          path +
          fmt::format(fmt::runtime(small ? "  ·  y {}  ·  z {}" : "  ·  position y = {}, z = {}"),
                      desktop::pretty_quantity(atoms(orbit[s.index].x(), s), unit, 3),
                      desktop::pretty_quantity(atoms(orbit[s.index].y(), s), unit, 3))));
}

}  // namespace adore::agore
