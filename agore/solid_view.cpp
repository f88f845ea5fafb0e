#include "agore/solid_view.hpp"

#include "agore/solid_model.hpp"
#include "agore/view_layout.hpp"
#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace adore::agore {

Eye::Eye(double yaw, double elevation) {
  const double a = yaw * kPi / 180.0, e = elevation * kPi / 180.0;
  toward = {std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e)};
  right = {-std::sin(a), std::cos(a), 0.0};
  up = toward.cross(right);
}

double viewers_azimuth(const Eye& eye) { return std::atan2(-eye.toward.y(), eye.toward.z()); }

bool is_outer_mark_visible(const Scene& s, const Eye& eye) {
  const double from =
      std::remainder(s.animation.race_angle[0][s.index] - viewers_azimuth(eye), 2.0 * kPi);
  return std::abs(from) > kOpen;
}

QColor solid_rotation_mark_color(const desktop::Theme& theme, bool coloured) {
  if (coloured) return {"#1c1c1c"};
  return theme.kind == desktop::ThemeKind::Dark ? QColor("#0f4a30") : QColor("#1c6b47");
}

namespace {

/// Those that no body hides, over the arrows of loads. @return is there one, by race?
std::array<bool, 2> draw_spots(const Scene& s, const SolidLayer& layer, const Eye& eye) {
  QPainter& p = s.sketch.painter();
  const desktop::Theme& t = s.sketch.theme();
  std::array<bool, 2> out{};
  for (const RaceRotationMark& spot : race_rotation_marks(s, eye)) {
    const QPointF at = s.sketch.at(spot.centre.dot(eye.right), spot.centre.dot(eye.up));
    const double radius = race_rotation_mark_radius(s) * s.sketch.scale();
    const double front = s.sketch.scale() * spot.centre.dot(eye.toward) + radius;
    if (!std::isfinite(at.x() + at.y() + front)) continue;  // the file has no position of it
    if (layer.hides(at, front)) continue;
    p.setPen(QPen(t.surface, kCasing));
    p.setBrush(race_colour(t, spot.race));
    p.drawEllipse(at, radius + 0.5 * kCasing, radius + 0.5 * kCasing);
    out[spot.race] = true;
  }
  return out;
}

/// Paths and loads, by their appearance: only dashed if they are completely behind bodies. The
/// dashes are explained once.
void name_lines(const Scene& s, const LineVisibility& paths,
                const std::array<LineVisibility, 2>& loads, std::vector<PictureLegendEntry>& key) {
  const desktop::Theme& t = s.sketch.theme();
  QColor dashed;
  const auto name = [&](PictureLegendEntry entry, const LineVisibility& drawn) {
    if (entry.mark == LegendMark::Line && !drawn.seen && drawn.hidden)
      entry.mark = LegendMark::Dashed;
    if (drawn.hidden && !dashed.isValid()) dashed = entry.colour;
    key.push_back(std::move(entry));
  };
  const bool lines = s.options.trails && s.animation.known_trails != Known::None;  // not dots
  if (s.options.trails)
    name(trail_entry(s, paths.seen || paths.hidden), lines ? paths : LineVisibility{});
  const bool known = s.options.contacts && s.animation.contacts_at(s.index) != nullptr;
  if (s.options.contacts && !known)
    key.push_back(
        {t.muted,
         QString::fromStdString("no race loads: " + s.animation.missing_loads_reason(s.index)),
         LegendMark::None});
  for (std::size_t j = 0; j < 2 && known; ++j)
    name(loads_entry(s, j, loads[j].seen || loads[j].hidden), loads[j]);
  if (lines || known)
    key.push_back(optional_entry(dashed.isValid() ? dashed : t.muted, dashed.isValid(),
                                 "dashed: behind a body", "nothing hidden", LegendMark::Dashed));
}

/// Of the marks in space.
void name_solid_mark(const Scene& s, std::vector<PictureLegendEntry>& key) {
  const std::size_t before = key.size();
  add_rotation_mark_entry(s, std::nullopt, key);
  const bool coloured =
      element_colors(s.animation, s.index, s.options.colour, s.options.scale).any();
  for (std::size_t i = before; i < key.size(); ++i)
    key[i].colour = solid_rotation_mark_color(s.sketch.theme(), coloured);
}

}  // namespace

double solid_picture_radius(const Animation& animation) {
  const auto& g = animation.file.geometry;
  const double rim = std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius);
  return 1.06 * std::hypot(rim, 0.5 * dimension_in_file_unit(animation, "outer_race_width"));
}

void solid_view(const Scene& s, SolidLayer& layer) {
  QPainter& p = s.sketch.painter();
  const auto& t = s.sketch.theme();
  constexpr int kStill = 2;
  layer.draw(s, s.options.moving ? 1 : kStill, p.device()->devicePixelRatioF());
  const Eye eye(s.options.yaw, s.options.elevation);
  LineVisibility paths;
  std::array<LineVisibility, 2> loads{};
  if (s.options.trails) paths = draw_paths(s, layer, eye);
  if (s.options.contacts) loads = draw_loads(s, layer, eye);
  const std::array<bool, 2> spots = draw_spots(s, layer, eye);  // no arrow hides them
  std::vector<PictureLegendEntry> key;
  key.push_back(
      optional_entry(race_colour(t, 0), spots[0], "outer race mark",
                     is_outer_mark_visible(s, eye) ? "outer mark hidden" : "outer mark cut off",
                     LegendMark::Spot));
  key.push_back(optional_entry(race_colour(t, 1), spots[1], "inner race mark", "inner mark hidden",
                               LegendMark::Spot));
  if (!land_sections(s.animation).empty()) key.push_back({t.red, kGuideLands});
  name_solid_mark(s, key);
  name_lines(s, paths, loads, key);
  if (s.options.colour != ColourBy::None)
    draw_color_scale(s, element_colors(s.animation, s.index, s.options.colour, s.options.scale));
  // The axes of the bearing, in the upper left corner.
  const double high = s.sketch.area().height();
  const double arm = high < 200.0 ? 10.0 : high < 420.0 ? 18.0 : 30.0;
  const int letters = high < 200.0 ? 9 : 12;
  const QPointF corner = s.sketch.area().topLeft() + 1.6 * QPointF(arm, arm);
  const std::array<std::pair<Vec3, const char*>, 3> axes{
      {{Vec3::UnitX(), "x"}, {Vec3::UnitY(), "y"}, {Vec3::UnitZ(), "z"}}};
  for (const auto& [axis, name] : axes) {
    const QPointF way(axis.dot(eye.right), -axis.dot(eye.up));
    s.sketch.arrow(corner, corner + arm * way, t.muted, 1.8);
    s.sketch.label(corner + (arm + 0.75 * letters) * way, name, t.muted, letters, true);
  }
  std::string remark = s.animation.has_cage ? fmt::format("radial clearances × {}",
                                                          desktop::pretty_number(s.factor, 3))
                                            : std::string("to scale");
  const double factor = layer.roller_factor(s.animation);
  if (s.animation.file.bearing_type != 1)
    remark += !(factor > 0.0) ? std::string("  ·  no skew, no tilt")
              : factor == 1.0
                  ? std::string("  ·  skew and tilt to scale")
                  : fmt::format("  ·  skew and tilt × {}", desktop::pretty_number(factor, 4));
  // First: colors have no meaning without the scale.
  const std::vector<PictureLegendEntry> scale = scale_entries(s);
  key.insert(key.begin(), scale.begin(), scale.end());
  draw_legend(s, key, QString::fromStdString(remark));
}

}  // namespace adore::agore
