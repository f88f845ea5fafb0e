#pragma once

#include "agore/view_options.hpp"
#include "desktop/chart_page.hpp"
#include "desktop/theme.hpp"

#include <QPainter>

#include <array>
#include <optional>

/// The pictures and their data curves, as functions of a frame: no state, no window.
namespace adore::agore {

struct ViewCache;

/// Layers of a picture: the lower one is constant while the races do not move, the other one moves.
enum class Layers : unsigned char { All, Still, Moving };

/// Draws the picture area of one frame into `area`. `kept` may be null: then everything is drawn.
void paint_picture(QPainter& painter, const QRectF& area, const Animation& animation,
                   std::size_t frame, const ViewOptions& options, ViewCache* kept = nullptr,
                   Layers layers = Layers::All);

/// Dependencies of the constant layer of a picture: position and scale of its sketch, which change
/// with every option that changes the height of the key, and the positions of the races to a
/// quarter of a pixel.
struct StaticLayerKey {
  QRectF area;
  QPointF centre;
  double scale = 0.0, factor = 0.0;
  View view{};
  bool dark = false, clipped = false;
  std::array<long, 4> races{};
  bool operator==(const StaticLayerKey&) const = default;
};
StaticLayerKey static_layer_key(const QRectF& area, const Animation& animation, std::size_t frame,
                                const ViewOptions& options);

/// Position in `area` of the center of a picture without zoom or displacement.
QPointF picture_middle(const Animation& animation, const ViewOptions& options, const QRectF& area);

/// Element (from 0) at a position of the picture in `area`, in the views that show all of them.
std::optional<std::size_t> element_at(const QRectF& area, QPointF position,
                                      const Animation& animation, std::size_t frame,
                                      const ViewOptions& options);

/// Content of the data area over time.
desktop::ChartPage data_page(const Animation& animation, const ViewOptions& options);

/// The theme that the options ask for.
const desktop::Theme& theme_of(const ViewOptions& options);

}  // namespace adore::agore
