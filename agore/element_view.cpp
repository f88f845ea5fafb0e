#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "agore/ways.hpp"
#include "desktop/even_digits.hpp"

#include <QLineF>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

/// The path of one element, with the loads of both races.
namespace adore::agore {

namespace {

/// Forces of the two races on element k as arrows on its surface, for the largest load of the file
/// as long as its diameter or as the picture has room, with load and slip in the key.
void draw_contact_loads(const Scene& s, std::size_t k, QPointF centre,
                        std::vector<PictureLegendEntry>& key) {
  const ContactFrames& all = *s.animation.contacts;
  const ContactFrame& contact = s.animation.contacts_at(s.index)->at(k);
  const double distance = std::hypot(centre.x(), centre.y());
  if (!(distance > 0.0)) return;
  const QPointF outward = centre / distance;
  const double radius = s.geometry().element_radius;
  constexpr double kMargin = 22.0;  // pixels round the rings that are the picture's
  const double longest =
      longest_load_arrow(s, 2.0 * radius, outer_rim(s.geometry()) + kMargin / s.sketch.scale());
  const std::array<const char*, 2> names{"outer race", "inner race"};
  for (std::size_t j = 0; j < 2; ++j) {
    const double side = j == 0 ? 1.0 : -1.0;  // the outer race presses from outside
    const QColor colour = s.sketch.theme().curves[j];
    const double length =
        all.largest_load > 0.0 ? longest * contact.load[j] / all.largest_load : 0.0;
    const QPointF tip = centre + side * radius * outward;
    const QPointF tail = tip + side * length * outward;
    const bool drawn = draw_load_arrow(s, s.sketch.at(tail.x(), tail.y()),
                                       s.sketch.at(tip.x(), tip.y()), colour, 3.0);
    key.push_back(
        {drawn ? colour : QColor(),
         QString::fromStdString(
             contact.load[j] > 0.0
                 ? fmt::format("{}: load {}{}, slip {}", names[j],
                               desktop::zero_padded_quantity(contact.load[j], all.load_unit, 4),
                               drawn ? "" : kTooSmall,
                               desktop::zero_padded_quantity(contact.slip[j], all.slip_unit, 3))
                 : fmt::format("{}: no contact", names[j]))});
    // With the other half of a split race: in the same plane through the axis, without an arrow.
    const double second = s.animation.value("second_contact.load", s.index, 2 * k + j);
    if (second > 0.0)
      key.push_back({QColor(), QString::fromStdString(fmt::format(
                                   "{}, other half: load {}, slip {}", names[j],
                                   desktop::zero_padded_quantity(second, all.load_unit, 4),
                                   desktop::zero_padded_quantity(
                                       s.animation.value("second_contact.slip", s.index, 2 * k + j),
                                       all.slip_unit, 3)))});
  }
}

}  // namespace

void draw_element_rings(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  s.sketch.ring(s.place(s.frame.races[0]), g.outer_race_inner_radius, g.outer_race_outer_radius,
                t.steel_light, t.steel_dark);
  s.sketch.ring(s.place(s.frame.races[1]), g.inner_race_inner_radius, g.inner_race_outer_radius,
                t.steel_light, t.steel_dark);
  s.sketch.circle({0, 0}, s.pitch_radius(), QPen(t.muted, 1.2, Qt::DotLine));
}

void draw_element_view(const Scene& s) {
  const auto& g = s.geometry();
  const auto& t = s.sketch.theme();
  const auto k = static_cast<std::size_t>(s.options.element - 1);
  // Path of the element so far, at most half a revolution.
  const auto& frames = s.animation.file.frames;
  std::vector<TrajectoryPoint> way;
  double swept = 0.0;
  for (std::size_t i = s.index;; --i) {
    const auto& e = frames[i].elements.at(k);
    way.push_back({s.sketch.around({0, 0}, e.r, e.theta),
                   i < s.index && s.animation.is_path_known(i + 1, k, false)});
    if (i == 0 || swept > kPi) break;
    swept += std::abs(std::remainder(e.theta - frames[i - 1].elements.at(k).theta, 2.0 * kPi));
  }
  if (way.size() == 1 || !way[1].joined) way.erase(way.begin());  // current position
  draw_trajectory(s.sketch.painter(), s.sketch.area(), way, {trail_colour(s), 2.4, t.surface});
  const QPointF centre = element_centre(s, k);
  draw_element(s, k);
  const double arm = 0.62 * g.inner_race_inner_radius, turned = s.animation.race_angle[1][s.index];
  const bool named = s.sketch.can_label_frame(arm);
  s.sketch.frame({0, 0}, turned, arm, race_colour(t, 1), named);
  // Next to the arrow of the outer race, if there is one.
  const double rim = outer_rim(g) + 0.54 * numbers_margin(s.sketch.half()) / s.sketch.scale();
  const bool loads = s.animation.contacts_at(s.index) != nullptr;
  const double aside = loads ? 24.0 / (rim * s.sketch.scale()) : 0.0;
  s.sketch.label(s.sketch.around({0, 0}, rim, std::atan2(-centre.x(), centre.y()) + aside),
                 QString::number(k + 1), t.text, 13, true);
  // The element covers the end of its path.
  const QPointF over = s.sketch.at(centre.x(), centre.y());
  const bool seen = std::any_of(way.begin(), way.end(), [&](const TrajectoryPoint& point) {
    return QLineF(point.at, over).length() > g.element_radius * s.sketch.scale() + 2.0;
  });
  const PictureLegendEntry path = trajectory_entry(trail_colour(s), s.animation.known_elements,
                                                   "element path", "earlier frames");
  std::vector<PictureLegendEntry> key{
      {race_colour(t, 1), "inner race frame"},
      optional_entry(path.colour, seen, path.text, "no path", path.mark),
      {t.muted, "pitch circle", LegendMark::Dotted}};
  add_frame_arms_entry(s, named, key);
  add_rotation_mark_entry(s, k, key);
  QString remark =
      QString::fromStdString("no contact loads: " + s.animation.missing_loads_reason(s.index));
  if (loads) {
    draw_contact_loads(s, k, centre, key);
    remark = is_too_low(s.options, s.sketch.area().height())
                 ? "slip: maximum"
                 : "contact loads and largest slip from RESULTS.h5";
  }
  if (named) s.sketch.draw_frame_labels({0, 0}, turned, arm, race_colour(t, 1));
  draw_legend(s, key, remark);
}

}  // namespace adore::agore
