#include "agore/view_layout.hpp"

#include "agore/picture_key.hpp"
#include "agore/view_scene.hpp"
#include "agore/views.hpp"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace adore::agore {

double outer_rim(const results::Sol8Geometry& g) {
  return std::max(g.outer_race_outer_radius, 1.06 * g.outer_race_inner_radius);
}

double numbers_margin(double half) { return std::clamp(0.2 * half, 13.0, 26.0); }

double picture_radius(const Animation& animation, const ViewOptions& options, QSizeF size) {
  const auto& g = animation.file.geometry;
  const double half = 0.5 * std::min(size.width(), size.height());
  const double margin = numbers_margin(half) / half;
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
    case View::Raceways:
      return outer_rim(g);
    case View::InnerRace:
      return g.inner_race_outer_radius * (1.0 + margin);
  }
  return outer_rim(g);
}

namespace {

/// Are the arms of a view's shortest frame too short for their letters? Its picture is nearly as
/// large as a size.
bool short_arms(const Animation& animation, const ViewOptions& options, QSizeF size) {
  const auto& g = animation.file.geometry;
  constexpr double kOfBore = 0.46, kOfCage = 0.5, kPart = 0.75, kLeast = 28.0;
  const double length = options.view == View::Cage ? kOfCage * g.cage_inner_radius
                                                   : kOfBore * g.inner_race_inner_radius;
  const double half = 0.5 * kPart * std::min(size.width(), size.height());
  return length * half / picture_radius(animation, options, size) < kLeast;
}

/// Did the run follow the turning of elements, so that they have a mark?
bool has_turning_marks(const Animation& animation) {
  const auto& elements = animation.file.frames.front().elements;
  return std::any_of(elements.begin(), elements.end(), [](const results::Sol8Element& e) {
    return e.angles != std::array<double, 3>{};
  });
}

/// Entries of the keys of views that have many.
std::size_t key_entries(const Animation& animation, const ViewOptions& options, QSizeF size) {
  const std::size_t loads = options.contacts ? 2 : 0, trails = options.trails ? 1 : 0;
  const std::size_t guide = animation.guide != Guide::None ? 2 : 0;
  const std::size_t scale = options.colour != ColourBy::None && animation.some_free ? 1 : 0;
  const std::size_t arms = short_arms(animation, options, size) ? 1 : 0;
  const std::size_t turning = has_turning_marks(animation) ? 1 : 0;
  switch (options.view) {
    case View::Cage:
      return 5 + guide + arms;
    case View::Solid:
      return 2 + (animation.guide != Guide::None ? 1 : 0) + turning + scale + loads + trails +
             std::min<std::size_t>(1, loads + trails);  // and what dashes are
    default:
      return 2 + (animation.has_cage ? 2 + guide : 0) + arms + turning + scale + loads + trails;
  }
}

/// Do its keys have many entries, in columns?
bool many(View view) { return view == View::Bearing || view == View::Cage || view == View::Solid; }

/// Height of the key of a view at most [pixels].
double key_height(const Animation& animation, const ViewOptions& options, QSizeF size) {
  if (many(options.view)) {
    const std::size_t entries = key_entries(animation, options, size);
    const auto columns = static_cast<std::size_t>(legend_column_count(entries, size));
    return static_cast<double>((entries + columns - 1) / columns + 1) *
           legend_line_height(legend_font_size(entries, size));
  }
  constexpr double kWide = 520.0;  // remarks of narrower ones need another line
  const auto lines = [&] {
    switch (options.view) {
      case View::Element:
        return 6;
      case View::Section:
      case View::Flange:
      case View::Raceways:
        return 3;
      case View::Pocket:
        return 5;
      default:
        return 4;
    }
  };
  return (lines() + (size.width() < kWide ? 1 : 0)) * legend_line_height();
}

/// Width of a view's key [pixels], as its longest line needs it.
double key_width(const Animation& animation, const ViewOptions& options, QSizeF size) {
  constexpr double kTwoColumns = 400.0;
  if (many(options.view) && legend_column_count(key_entries(animation, options, size), size) == 2)
    return std::min(size.width(), kTwoColumns);
  switch (options.view) {
    case View::Solid:
      return 290.0;
    case View::Element:
      return 350.0;
    case View::OuterRace:
    case View::InnerRace:
      return 400.0;
    default:
      return options.contacts ? 260.0 : 215.0;
  }
}

}  // namespace

namespace {

/// Of a picture that leaves `head` free at its top.
double foot_below(const Animation& animation, const ViewOptions& options, QSizeF size,
                  double head) {
  const bool low = is_too_low(options, size.height());
  const bool round = options.view != View::Pocket && options.view != View::Section &&
                     options.view != View::Flange && options.view != View::Raceways;
  const double lines = low ? (options.view == View::Bearing ? 1.0 : 2.0) * legend_line_height()
                           : key_height(animation, options, size);
  const double height = std::min(lines + 4.0, 0.45 * size.height());
  if (!round || (low && options.view == View::Solid)) return height;
  const double beside = std::max(0.0, 0.5 * size.width() - key_width(animation, options, size));
  // Rings end a margin before the picture; the margin contains the element numbers.
  const double half = 0.5 * std::min(size.width(), size.height());
  const bool numbers = options.view == View::Bearing || options.view == View::Cage;
  const double rim = options.view == View::Solid ? 0.05 * half : numbers ? 0.0 : 20.0;
  for (double foot = 0.0; foot < height; foot += 4.0) {
    const double high = size.height() - foot - head;
    const double radius = 0.5 * std::min(size.width(), high);
    const double below = std::max(0.0, size.height() - height - head - 0.5 * high);
    if (std::hypot(beside, below) > radius - rim) return foot;
  }
  return height;
}

}  // namespace

double legend_height_below(const Animation& animation, const ViewOptions& options, QSizeF size) {
  if (!options.shown.key) return 0.0;
  return foot_below(animation, options, size, color_scale_top_margin(animation, options, size));
}

QSizeF color_scale_size(const ViewOptions& options, QSizeF size) {
  const bool round = options.view == View::Bearing || options.view == View::Solid;
  if (options.colour == ColourBy::None || !round) return {0.0, 0.0};
  if (options.one_of_several && is_too_low(options, size.height())) return {0.0, 0.0};
  const double lines = options.scale.kind == ColorScaleKind::Typed ? 3.0 : 2.0;
  return {size.width() < 480.0 ? 110.0 : 156.0, 46.0 + 14.0 * lines};
}

double color_scale_top_margin(const Animation& animation, const ViewOptions& options, QSizeF size) {
  const QSizeF room = color_scale_size(options, size);
  if (room.isEmpty()) return 0.0;
  // A higher foot, which a head may ask for, makes the picture as much smaller as it lifts it.
  const double foot = options.shown.key ? foot_below(animation, options, size, 0.0) : 0.0;
  constexpr double kStep = 2.0, kBeside = 4.0;
  const double right = std::max(0.0, 0.5 * size.width() - room.width());
  for (double head = 0.0; head < room.height(); head += kStep) {
    const double high = size.height() - foot - head, radius = 0.5 * std::min(size.width(), high);
    const double up = std::max(0.0, head + 0.5 * high - room.height());
    if (std::hypot(right, up) > radius + kBeside) return head;
  }
  return room.height();
}

QPointF picture_middle(const Animation& animation, const ViewOptions& options, const QRectF& area) {
  return area.center() +
         QPointF(0.0, 0.5 * (color_scale_top_margin(animation, options, area.size()) -
                             legend_height_below(animation, options, area.size())));
}

}  // namespace adore::agore
