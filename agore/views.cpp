#include "agore/views.hpp"

#include "agore/kept.hpp"
#include "agore/sketch.hpp"
#include "agore/solid_view.hpp"
#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"

#include <QImage>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::agore {

const desktop::Theme& theme_of(const ViewOptions& options) {
  return desktop::theme(options.dark ? desktop::ThemeKind::Dark : desktop::ThemeKind::Light);
}

namespace {

/// Scale of the picture, and position of its center.
Sketch sketch_of(QPainter& painter, const QRectF& area, const Animation& animation,
                 const ViewOptions& options, SpriteCache* stamps = nullptr) {
  const double foot = legend_height_below(animation, options, area.size());
  const double head = color_scale_top_margin(animation, options, area.size());
  const QSizeF room(area.width(), area.height() - foot - head);
  return {painter,
          area,
          picture_radius(animation, options, room) / std::max(options.zoom, 1e-3),
          theme_of(options),
          options.pan,
          foot,
          stamps,
          head};
}

/// A complete picture needs no clipping.
bool is_clipped(const ViewOptions& options) { return options.zoom != 1.0 || !options.pan.isNull(); }

void paint_still(const Scene& scene) {
  switch (scene.options.view) {
    case View::Bearing:
      return draw_bearing_rings(scene);
    case View::Element:
      return draw_element_rings(scene);
    case View::OuterRace:
    case View::InnerRace:
      return draw_race_ring(scene);
    case View::Cage:
    case View::Pocket:
    case View::Section:
    case View::Solid:
    case View::Flange:
    case View::Raceways:
      return;
  }
}

void paint_moving(const Scene& scene, ViewCache& kept) {
  switch (scene.options.view) {
    case View::Bearing:
      return draw_bearing_view(scene);
    case View::Cage:
      return draw_cage_view(scene);
    case View::Pocket:
      return draw_pocket_view(scene);
    case View::Section:
      return draw_section_view(scene);
    case View::Solid:
      return solid_view(scene, kept.solid);
    case View::Flange:
      return draw_flange_view(scene);
    case View::Raceways:
      return draw_raceway_view(scene);
    case View::Element:
      return draw_element_view(scene);
    case View::OuterRace:
    case View::InnerRace:
      return draw_race_view(scene);
  }
}

}  // namespace

StaticLayerKey static_layer_key(const QRectF& area, const Animation& animation, std::size_t index,
                                const ViewOptions& options) {
  QImage nothing(1, 1, QImage::Format_RGB32);
  QPainter painter(&nothing);
  const Sketch sketch = sketch_of(painter, area, animation, options);
  StaticLayerKey key{
      area,         sketch.at(0.0, 0.0), sketch.scale(),      used_exaggeration(animation, options),
      options.view, options.dark,        is_clipped(options), {}};
  if (options.view != View::Bearing && options.view != View::Element) return key;
  for (std::size_t race = 0; race < 2; ++race)
    for (std::size_t c = 0; c < 2; ++c) {
      constexpr double kFar = 1e8;
      const double at =
          4.0 * key.scale * key.factor * animation.frame(index).races[race].position[c + 1];
      key.races[2 * race + c] = std::lround(std::isfinite(at) ? std::clamp(at, -kFar, kFar) : kFar);
    }
  return key;
}

std::optional<std::size_t> element_at(const QRectF& area, QPointF position,
                                      const Animation& animation, std::size_t frame,
                                      const ViewOptions& options) {
  const bool solid = options.view == View::Solid;
  if (!solid && options.view != View::Bearing && options.view != View::Cage) return std::nullopt;
  QImage nothing(1, 1, QImage::Format_RGB32);
  QPainter painter(&nothing);
  const Sketch sketch = sketch_of(painter, area, animation, options);
  const double factor = used_exaggeration(animation, options);
  const Eye eye(options.yaw, options.elevation);
  const double radius = animation.file.geometry.element_radius * sketch.scale();
  std::optional<std::size_t> out;
  double nearest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < animation.frame(frame).elements.size(); ++k) {
    const QPointF centre = element_centre(animation, frame, factor, k);
    const Vec3 place(animation.frame(frame).elements[k].x, centre.x(), centre.y());
    const QPointF at = solid ? sketch.at(place.dot(eye.right), place.dot(eye.up))
                             : sketch.at(centre.x(), centre.y());
    const double depth = solid ? place.dot(eye.toward) : 0.0;
    if (std::hypot(at.x() - position.x(), at.y() - position.y()) > radius || depth <= nearest)
      continue;
    nearest = depth;
    out = k;
  }
  return out;
}

void paint_picture(QPainter& painter, const QRectF& area, const Animation& animation,
                   std::size_t index, const ViewOptions& options, ViewCache* kept, Layers layers) {
  check_view(animation, options);
  ViewCache once;
  if (kept == nullptr) kept = &once;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (is_clipped(options)) painter.setClipRect(area);
  const Sketch sketch = sketch_of(painter, area, animation, options, kept->stamps.get());
  const Scene scene{
      sketch,  animation,   index,    animation.frame(index), used_exaggeration(animation, options),
      options, kept->cages, kept->key};
  if (layers != Layers::Moving) paint_still(scene);
  if (layers != Layers::Still) paint_moving(scene, *kept);
  painter.restore();
}

}  // namespace adore::agore
