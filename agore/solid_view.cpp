#include "agore/solid_view.hpp"

#include "agore/solid_model.hpp"
#include "agore/view_layout.hpp"
#include "agore/ways.hpp"
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

bool outer_spot_shown(const Scene& s, const Eye& eye) {
  const double from =
      std::remainder(s.animation.race_angle[0][s.index] - viewers_azimuth(eye), 2.0 * kPi);
  return std::abs(from) > kOpen;
}

QColor solid_mark_colour(const desktop::Theme& theme, const QColor& tint) {
  if (tint.isValid()) {  // as in the flat views, and not as black: that looks like a hole
    const QColor flat = turning_mark_colour(theme, tint);
    return qGray(flat.rgb()) < 128 ? QColor("#222222") : flat;
  }
  return theme.kind == desktop::ThemeKind::Dark ? QColor("#4a1f66") : QColor("#7a3fa0");
}

namespace {

/// The way of an element's centre in the picture, cut where bodies begin and end to hide it.
struct CutWay {
  std::vector<std::vector<WayPoint>> seen, hidden;
};

class WayCutter {
 public:
  WayCutter(const SolidLayer& layer, CutWay& out) : layer_(layer), out_(out) {}
  struct Place {
    QPointF at;
    double depth;  ///< towards the viewer [pixels]
  };
  void begin() { last_.reset(); }
  void add(const Place& to, bool joined) {
    if (last_ && joined) {
      // As fine as a body's edge is seen.
      constexpr double kStep = 3.0;  // pixels
      const QPointF way = to.at - last_->at;
      const int parts = std::max(
          1, static_cast<int>(std::ceil(std::min(1e4, std::hypot(way.x(), way.y())) / kStep)));
      const Place from = *last_;
      for (int i = 1; i <= parts; ++i) {
        const double part = static_cast<double>(i) / parts;
        step({from.at + part * way, from.depth + part * (to.depth - from.depth)}, i == parts);
      }
      return;
    }
    // Where the way before is unknown this one is marked, in the same list as that.
    const bool hidden = layer_.hides(to.at, to.depth);
    const bool on = last_ && hidden == hidden_;
    hidden_ = hidden;
    if (!on) piece().emplace_back();
    piece().back().push_back({to.at, false});
    last_ = to;
  }

 private:
  [[nodiscard]] std::vector<std::vector<WayPoint>>& piece() {
    return hidden_ ? out_.hidden : out_.seen;
  }
  void step(const Place& to, bool frame) {
    const bool hidden = layer_.hides(to.at, to.depth);
    if (hidden != hidden_) {
      piece().back().push_back({to.at, true, false});
      hidden_ = hidden;
      piece().push_back({{to.at, false, frame}});
    } else if (frame) {
      piece().back().push_back({to.at, true});
    }
    last_ = to;
  }
  const SolidLayer& layer_;
  CutWay& out_;
  std::optional<Place> last_;
  bool hidden_ = false;
};

/// Paths of the elements, in dashes where bodies hide them. Returns whether any of it is hidden.
bool draw_paths(const Scene& s, const SolidLayer& layer, const Eye& eye) {
  CutWay ways;
  WayCutter cutter(layer, ways);
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
    cutter.begin();
    for (const TrailPoint& point : element_trail(s, k)) {
      const Vec3 place(point.x, point.centre.x(), point.centre.y());
      cutter.add({s.sketch.at(place.dot(eye.right), place.dot(eye.up)),
                  s.sketch.scale() * place.dot(eye.toward)},
                 point.joined);
    }
  }
  QPainter& p = s.sketch.painter();
  const QColor colour = trail_colour(s), edge = s.sketch.theme().surface;
  draw_ways(p, s.sketch.area(), ways.hidden, {colour, 1.2, edge, true});
  draw_ways(p, s.sketch.area(), ways.seen, {colour, 1.8, edge});
  return !ways.hidden.empty();
}

/// Those that no body hides, over the arrows of loads.
void draw_spots(const Scene& s, const SolidLayer& layer, const Eye& eye) {
  QPainter& p = s.sketch.painter();
  const desktop::Theme& t = s.sketch.theme();
  for (const RaceSpot& spot : race_spots(s, eye)) {
    const QPointF at = s.sketch.at(spot.centre.dot(eye.right), spot.centre.dot(eye.up));
    const double radius = race_spot_radius(s) * s.sketch.scale();
    const double front = s.sketch.scale() * spot.centre.dot(eye.toward) + radius;
    if (!std::isfinite(at.x() + at.y() + front)) continue;  // the file has no place of it
    if (layer.hides(at, front)) continue;
    p.setPen(QPen(t.surface, kCasing));
    p.setBrush(spot.race == 0 ? t.light_blue : t.blue);
    p.drawEllipse(at, radius + 0.5 * kCasing, radius + 0.5 * kCasing);
  }
}

/// Of the marks in space: purple on steel, grey on the colours of a scale.
void name_solid_mark(const Scene& s, std::vector<KeyEntry>& key) {
  const std::size_t before = key.size();
  name_turning_mark(s, std::nullopt, key);
  const bool coloured = colouring(s.animation, s.index, s.options.colour, s.options.scale).any();
  for (std::size_t i = before; i < key.size(); ++i)
    key[i].colour = coloured ? solid_mark_colour(s.sketch.theme(), Qt::white)
                             : solid_mark_colour(s.sketch.theme());
}

}  // namespace

double solid_picture_radius(const Animation& animation) {
  const auto& g = animation.file.geometry;
  const double rim = std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius);
  return 1.06 * std::hypot(rim, 0.5 * size_length(animation, "outer_race_width"));
}

void solid_view(const Scene& s, SolidLayer& layer) {
  QPainter& p = s.sketch.painter();
  const auto& t = s.sketch.theme();
  constexpr int kStill = 2;
  layer.draw(s, s.options.moving ? 1 : kStill, p.device()->devicePixelRatioF());
  const Eye eye(s.options.yaw, s.options.elevation);
  const auto at = [&](const Vec3& v) { return s.sketch.at(v.dot(eye.right), v.dot(eye.up)); };
  const bool hidden = s.options.trails && draw_paths(s, layer, eye);
  std::vector<KeyEntry> key;
  if (outer_spot_shown(s, eye))
    key.push_back({t.light_blue, "spot of the outer race", KeyMark::Spot});
  key.push_back({t.blue, "spot of the inner race", KeyMark::Spot});
  if (!land_places(s.animation).empty()) key.push_back({t.red, kGuideLands});
  name_solid_mark(s, key);
  if (s.options.trails) key.push_back(trail_entry(s));
  if (hidden && s.animation.known_trails != Known::None)
    key.push_back({trail_colour(s), "behind a body", KeyMark::Dashed});
  const auto* const loads = s.options.contacts ? s.animation.contacts_at(s.index) : nullptr;
  if (s.options.contacts && loads == nullptr)
    key.push_back({t.muted,
                   QString::fromStdString("no race loads: " + s.animation.no_loads(s.index)),
                   KeyMark::None});
  if (loads != nullptr && s.animation.contacts->largest_load > 0.0) {
    const auto& contacts = *loads;
    const double radius = s.geometry().element_radius;
    for (std::size_t k = 0; k < contacts.size(); ++k)
      for (std::size_t j = 0; j < 2; ++j) {
        const double part = contacts[k].load[j] / s.animation.contacts->largest_load;
        const double angle = s.animation.value("contact.angle", s.index, 2 * k + j);
        if (!(part > 0.0) || !std::isfinite(angle)) continue;
        const double way = j == 0 ? 1.0 : -1.0;
        const Vec3 u = way * (Vec3(std::sin(angle), 0.0, 0.0) +
                              std::cos(angle) * outwards(s.frame.elements.at(k).theta));
        const Vec3 tip = element_place(s, k) + radius * u, tail = tip + 1.3 * part * radius * u;
        s.sketch.arrow(at(tail), at(tip), t.curves[j], 2.6);
      }
    const auto& largest = s.animation.contacts->largest_of_race;
    key.push_back({t.curves[0], "outer race loads" + longest_load(s, largest[0])});
    key.push_back({t.curves[1], "inner race loads" + longest_load(s, largest[1])});
  }
  draw_spots(s, layer, eye);  // no arrow hides them
  if (s.options.colour != ColourBy::None)
    draw_scale(s, colouring(s.animation, s.index, s.options.colour, s.options.scale));
  // The bearing's axes, in the upper left corner.
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
  std::string remark = s.animation.has_cage ? fmt::format("clearances across × {}",
                                                          desktop::pretty_number(s.factor, 3))
                                            : std::string("to scale");
  const double factor = layer.roller_factor(s.animation);
  if (s.animation.file.bearing_type != 1)
    remark += !(factor > 0.0) ? std::string("  ·  no skew, no tilt")
              : factor == 1.0
                  ? std::string("  ·  skew and tilt to scale")
                  : fmt::format("  ·  skew and tilt × {}", desktop::pretty_number(factor, 4));
  // First: colours say nothing without.
  const std::vector<KeyEntry> scale = scale_entries(s);
  key.insert(key.begin(), scale.begin(), scale.end());
  draw_key(s, key, QString::fromStdString(remark));
}

}  // namespace adore::agore
